#pragma once
// The parts of an XML scene: a reader for each block, element and tag. Internal to format.

#include "scenefile/base/shape.h"
#include "scenefile/format/xml_fields.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace scenefile {

enum class ObjectType : std::uint8_t { tree, master, primitive };

struct ObjectTag {
  ObjectType type = ObjectType::tree;
  bool has_name = false;
  bool has_filename = false;
  std::string_view name;      ///< may be empty
  std::string_view filename;  ///< of a mesh
  Location name_place;        ///< of the attribute, or of the tag if there is none
  Location filename_place;
};

/// Reads the attributes. Returns nullopt to skip the object: after an error, or a warning about a
/// type that the format does not have.
std::optional<ObjectTag> read_object_tag(const XmlContext& context, const XmlTag& tag);

/// The shape that a primitive names. Returns nullopt to skip it: after an error, or a warning about
/// a shape that the format does not have.
std::optional<Shape> read_shape(const XmlContext& context, const XmlTag& tag,
                                const ObjectTag& object);

/// Reads a child of <globaldata>. Returns false to skip it with its contents.
bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene);

/// A camera while it is read.
struct CameraDraft {
  Camera camera;
  glm::vec3 focus{0};
  SeenFields seen;
};

/// Reads a child of <cameradata>. Returns false to skip it with its contents.
bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft,
                      Scene& scene);
/// Called at the end of <cameradata>: adds the camera to the scene.
void finish_camera(const XmlContext& context, CameraDraft& draft, Scene& scene);

/// A light while it is read.
struct LightDraft {
  Light light;
  SeenFields seen;
  bool type_known = true;  ///< false: misspelled, so missing values cannot be reported
};

/// Called at <lightdata>; `type` and `id` may be attributes.
LightDraft begin_light(const XmlContext& context, const XmlTag& tag);
/// Reads a child of <lightdata>. Returns false to skip it with its contents.
bool read_light_part(const XmlContext& context, const XmlTag& tag, LightDraft& draft, Scene& scene);
/// Called at the end of <lightdata>: adds the light to the root.
void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene);

/// A primitive while it is read; it is already in the scene.
struct PrimitiveDraft {
  NodeId node = 0;  ///< the primitive is the last one of this node
  SeenFields seen;
  bool texture_known = true;
};

/// The file name of a texture: `file`, another dialect's name for it, or the first attribute that
/// is not a number. Returns nullptr, after an error, if there is none.
const XmlAttribute* find_image_file(const XmlContext& context, const XmlTag& tag);

/// The attribute `name` of a texture, "u" or "v", in any letter case unless read as by the course's
/// programs. Reports another letter case. Returns nullptr if there is none.
const XmlAttribute* find_repeat(const XmlContext& context, const XmlTag& tag,
                                std::string_view name);

/// Reads a child of a primitive. Returns false to skip it with its contents.
bool read_primitive_part(const XmlContext& context, const XmlTag& tag, PrimitiveDraft& draft,
                         Scene& scene);

/// Called at the end of a primitive.
void finish_primitive(PrimitiveDraft& draft, Scene& scene);

/// Each of these returns nullopt if there is nothing to apply, after an error or a warning.
std::optional<Transform> read_translate(const XmlContext& context, const XmlTag& tag);
std::optional<Transform> read_scale(const XmlContext& context, const XmlTag& tag);
std::optional<Transform> read_rotate(const XmlContext& context, const XmlTag& tag);

/// A matrix while it is read.
struct MatrixDraft {
  glm::mat4 rows{1};  ///< as written: rows[i] is a row, not a column
  std::size_t count = 0;
  bool valid = true;
  Location location;
  Location last_row;
};

/// Reads any child of <matrix> as a row.
void read_matrix_child(const XmlContext& context, const XmlTag& tag, MatrixDraft& draft);
/// Called at the end of <matrix>.
std::optional<Transform> finish_matrix(const XmlContext& context, const MatrixDraft& draft);

}  // namespace scenefile
