#pragma once
// The scene as written by its author: names, degrees, file names and places in the file. It is
// read, checked, compared, converted and written back, but never rendered; for that see
// render_scene.h.
//
// Conventions: right-handed, y up, column vectors; angles in degrees (`_deg`); colors are red,
// green, blue, with 1 as full intensity.

#include "scenefile/base/location.h"
#include "scenefile/base/rare.h"
#include "scenefile/base/shape.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace scenefile {

/// A value of the global data, the camera, a light, a primitive or a node; named like the member
/// that holds it.
enum class Field : std::uint8_t {
  ambient,
  diffuse,
  specular,
  transparent,
  position,
  look,
  up,
  height_angle_deg,
  aperture,
  focal_length,
  color,
  direction,
  attenuation,
  angle_deg,
  penumbra_deg,
  width,
  height,
  id,
  reflective,
  shininess,
  ior,
  blend,
  mesh_file,
  instance_of
};

/// A set of fields.
class FieldSet {
 public:
  constexpr FieldSet(std::initializer_list<Field> fields = {}) {
    for (const Field field : fields) {
      insert(field);
    }
  }
  constexpr void insert(Field field) { bits_ |= bit(field); }
  constexpr void set(Field field, bool contained) {
    bits_ = contained ? bits_ | bit(field) : bits_ & ~bit(field);
  }
  constexpr bool contains(Field field) const { return (bits_ & bit(field)) != 0; }
  friend constexpr bool operator==(const FieldSet&, const FieldSet&) = default;

 private:
  static constexpr std::uint32_t bit(Field field) { return 1u << static_cast<unsigned>(field); }
  static_assert(static_cast<unsigned>(Field::instance_of) < 32);

  std::uint32_t bits_ = 0;
};

/// Coefficients that scale the terms of the lighting equation in the whole scene.
struct Global {
  float ambient = 0.5f;
  float diffuse = 0.5f;
  float specular = 0.5f;
  /// Not given in nearly all files; the renderer's profile then decides its value.
  std::optional<float> transparent;
  Location location;
  /// Values that the file gives, but that could not be read; they have their defaults. check()
  /// reports nothing that depends on them.
  FieldSet unread{};

  friend bool operator==(const Global& a, const Global& b);
};

/// The camera. The readers convert `focus`, a point in files, to a look direction.
struct Camera {
  glm::vec3 position{5, 5, 5};
  glm::vec3 look{-1, -1, -1};   ///< direction; any length except zero
  glm::vec3 up{0, 1, 0};        ///< any length, not parallel to look
  float height_angle_deg = 45;  ///< full vertical angle of view, in (0, 180)
  float aperture = 0;           ///< lens size in world units; 0 is a pinhole
  float focal_length = 0;       ///< distance of the plane in focus, world units; 0 is a pinhole
  Location location;
  FieldSet unread{};  ///< as in Global

  friend bool operator==(const Camera& a, const Camera& b);
};

struct Translate {
  glm::vec3 by{0};
  friend bool operator==(const Translate&, const Translate&) = default;
};
struct Rotate {
  glm::vec3 axis{0, 1, 0};  ///< any length except zero
  float angle_deg = 0;      ///< right-handed about the axis
  friend bool operator==(const Rotate&, const Rotate&) = default;
};
struct Scale {
  glm::vec3 by{1};
  friend bool operator==(const Scale&, const Scale&) = default;
};
/// A 4x4 matrix as glm stores it: m()[column][row]; files list rows. Matrices are rare and large,
/// so each is immutable and shared on the heap, which keeps other transforms small.
class Matrix {
 public:
  explicit Matrix(const glm::mat4& m = glm::mat4(1)) : m_(std::make_shared<const glm::mat4>(m)) {}
  const glm::mat4& m() const { return *m_; }
  friend bool operator==(const Matrix& a, const Matrix& b) { return a.m() == b.m(); }

 private:
  std::shared_ptr<const glm::mat4> m_;
};

struct Transform {
  std::variant<Translate, Rotate, Scale, Matrix> map;
  Location location;

  friend bool operator==(const Transform& a, const Transform& b) { return a.map == b.map; }
};

/// An image file on a surface.
struct TextureUse {
  std::string file;    ///< as written
  float repeat_u = 1;  ///< how often the image repeats along u
  float repeat_v = 1;
  Location location;

  friend bool operator==(const TextureUse& a, const TextureUse& b);
};

/// Phong material. Colors are not bounded by 1.
struct Material {
  glm::vec3 ambient{0};
  glm::vec3 diffuse{1};
  glm::vec3 specular{0};
  glm::vec3 reflective{0};
  glm::vec3 transparent{0};
  float shininess = 0;  ///< exponent; 0 means no highlight
  float ior = 0;        ///< index of refraction; 0 means not given, and counts as 1
  float blend = 0;      ///< share of the texture in the diffuse color, 0..1
  Rare<TextureUse> texture;
  Rare<TextureUse> bump_map;

  friend bool operator==(const Material&, const Material&) = default;
};

struct Primitive {
  Shape shape = Shape::cube;
  FieldSet unread{};   ///< as in Global
  RareText mesh_file;  ///< as written; only for Shape::mesh
  Material material;
  Location location;

  friend bool operator==(const Primitive& a, const Primitive& b);
};

struct Light {
  LightType type = LightType::point;
  glm::vec3 color{1};
  glm::vec3 position{0};           ///< in the space of its node; unused by directional lights
  glm::vec3 direction{0};          ///< in which the light travels, in the space of its node
  glm::vec3 attenuation{1, 0, 0};  ///< constant, linear and quadratic coefficients of the distance
  std::optional<float> angle_deg;  ///< spot: half-angle of the outer cone
  float penumbra_deg = 0;          ///< spot: degrees from full light to none, inside `angle_deg`
  float width = 0;                 ///< area: both in world units
  float height = 0;
  std::optional<int> id;  ///< has no effect
  std::string name;       ///< has no effect
  Location location;
  FieldSet unread{};  ///< as in Global

  friend bool operator==(const Light& a, const Light& b);
};

/// Index into Scene::nodes.
using NodeId = std::uint32_t;

/// A group; its transforms place its contents. A node with `instance_of` is an instance of that
/// template (including the template's transforms) and has no contents.
struct Node {
  RareText name;                      ///< may be empty; templates need one
  std::vector<Transform> transforms;  ///< product in listed order: the last listed acts first
  std::vector<Light> lights;
  std::vector<Primitive> primitives;
  std::vector<NodeId> children;
  RareText instance_of;  ///< name of a template; empty: not an instance
  Location location;
};

/// The place of one value in the file. The owner is named by its own place, which stays right when
/// nodes, lights or primitives are added or removed, as an index would not.
struct FieldPlace {
  Location owner;  ///< the `location` of the Global, Camera, Light, Primitive or Node
  Field field = Field::ambient;
  Location location;
};

/// A scene as written. The nodes form a forest whose trees are the root and the templates. Every
/// other node is the child of exactly one node; a node without a parent is not part of the scene.
/// All nodes are in one array, so that no depth of nesting can overflow the stack when a scene is
/// copied or destroyed.
struct Scene {
  std::string name;
  Global global;
  std::optional<Camera> camera;  ///< absent: the default camera is used
  std::vector<Node> nodes = std::vector<Node>(1);
  std::vector<NodeId> templates;  ///< named nodes to instantiate, in the order of declaration
  NodeId root = 0;
  /// Only for messages; in any order. The place of a value that is not listed is that of its owner.
  std::vector<FieldPlace> field_places;
  /// The file had errors or no root, so parts may be missing. check() then does not report problems
  /// that may follow from that.
  bool incomplete = false;

  /// Equal structure and values; places in the file and the order of `nodes` are ignored.
  friend bool operator==(const Scene& a, const Scene& b);
};

/// Appends an empty node as a child of `parent`. Returns its index. Invalidates references to
/// nodes.
NodeId add_child(Scene& scene, NodeId parent);

/// Appends an empty node with that name and makes it a template. Returns its index. Invalidates
/// references to nodes.
NodeId add_template(Scene& scene, std::string name);

}  // namespace scenefile
