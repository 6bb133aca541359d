#pragma once
// The state of reading an XML scene file. Internal to the room.

#include "scenefile/format/xml_camera.h"
#include "scenefile/format/xml_context.h"
#include "scenefile/format/xml_fields.h"
#include "scenefile/format/xml_light.h"
#include "scenefile/format/xml_material.h"
#include "scenefile/format/xml_object.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/format/xml_references.h"
#include "scenefile/format/xml_transform.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class Block : std::uint8_t {
  document,
  scenefile,
  globals,
  camera,
  light,
  tree,
  transblock,
  primitive,
  instance,
  matrix,
  leaf
};

/// An element that is being read.
struct Frame {
  Block block = Block::leaf;
  bool has_content = false;  ///< transblock: its object has come; tree: a transblock has
  bool is_implicit = false;  ///< transblock that is not in the file
  bool is_nested = false;    ///< tree inside a transblock
  NodeId node = 0;           ///< tree, transblock, primitive, instance
  std::string_view element;  ///< as written
  Location name_place;       ///< tree
};

/// Builds the scene while the file is read. Holds the elements that are open and nothing of those
/// that are closed but what they mean.
class SceneBuilder final : public XmlHandler {
 public:
  explicit SceneBuilder(const XmlContext& context) : context_(context) { push(Block::document, 0); }

  bool start(const XmlTag& tag) override;
  void end() override;
  void text(std::string_view characters, Location location) override;

  /// At the end of the file, or where reading it stopped.
  Scene finish(bool complete);

 private:
  bool open(const XmlTag& tag);
  bool open_document(const XmlTag& tag);
  bool open_top(const XmlTag& tag);
  bool open_globals(const XmlTag& tag);
  bool open_light(const XmlTag& tag);
  bool open_top_object(const XmlTag& tag);
  bool open_in_tree(const XmlTag& tag);
  bool open_transblock(const XmlTag& tag);
  bool open_in_transblock(const XmlTag& tag);
  bool open_transform(const XmlTag& tag, std::optional<Transform> transform);
  bool open_matrix(const XmlTag& tag);
  bool open_object(const XmlTag& tag);
  bool open_tree(const XmlTag& tag, const ObjectTag& object);
  bool open_instance(const XmlTag& tag, const ObjectTag& object);
  bool open_primitive(const XmlTag& tag, const ObjectTag& object);
  bool open_leaf(const XmlTag& tag, bool known);
  bool ignore(const Code& code, const XmlTag& tag, std::string message);

  bool push(Block block, NodeId node, std::string_view element = {});
  Frame& top() { return frames_.back(); }
  NodeId add_node(Location location);
  NodeId add_child_node(NodeId parent, Location location);
  void flush_transforms(NodeId node);
  void make_room_for_object(NodeId node);
  void end_tree(const Frame& tree);
  void end_transblock(const Frame& block);

  XmlContext context_;
  Scene scene_;
  XmlReferences references_;
  std::vector<Frame> frames_;
  std::size_t ignored_ = 0;  // elements open inside one that is left out, and itself
  bool stopped_ = false;
  bool lost_tree_ = false;  // a tree at the top, after an error: its name may be used
  bool text_reported_ = false;
  Location scenefile_;

  // What is being read; none of these can stand inside itself.
  SeenFields globals_;
  CameraDraft camera_;
  LightDraft light_;
  PrimitiveDraft primitive_;
  MatrixDraft matrix_;
  std::vector<Transform> transforms_;  // of the innermost transblock, until its object comes
};

}  // namespace scenefile
