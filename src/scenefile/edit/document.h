#pragma once
// The text of a scene file as an author sees it: its objects, lights, camera and global data, and
// the fields of each, with their places in the text. What is an object and which value counts is
// what read_scene() says; the text is only searched for where they are.
//
//     const Result<Document> document = Document::open(text, options);
//     for (const FieldView& field : document->fields(*document->item_of(light.location))) { ... }
//     const Result<Edit> edit = set_value(*document, item, field, 0, "0.5");   // edits.h
//
// A document does not change: apply an edit to its text and open the result.

#include "scenefile/base/location.h"
#include "scenefile/base/result.h"
#include "scenefile/edit/text_edit.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"
#include "scenefile/scene/value_kind.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class ItemKind : std::uint8_t {
  globals,  ///< there is always one, even if the file has none
  camera,   ///< the same
  light,    ///< in XML a child of nothing, in JSON of its group
  root,     ///< the scene itself; an XML file may lack it
  master,   ///< a template, to be drawn by its instances
  group,
  primitive,
  instance,  ///< of a template
  unread,    ///< an object that the reader left out, after an error or a warning
};

/// Index into Document::items(). Only valid for one document; the place where an item starts
/// identifies it from one document to the next (moved() in text_edit.h).
using ItemId = std::uint32_t;
inline constexpr ItemId no_item = ~ItemId{0};

/// A part of the scene that can be selected. In XML, an object includes its transblock.
struct SceneItem {
  ItemKind kind = ItemKind::group;
  std::string name;     ///< of a group or template; of the template of an instance; the shape of
                        ///< a primitive; the type of a light
  bool written = true;  ///< false: the file has no such global data or camera
  TextRange range;      ///< in the text, without comments around it
  ItemId parent = no_item;       ///< the group, root or template that contains it
  std::vector<ItemId> children;  ///< in the order of the scene
  /// Several objects are in its transblock (`--compat course`): it cannot be copied or moved alone.
  bool shared = false;
  NodeId node = 0;  ///< of the scene: its own, or the one that contains it
  /// Parts of the syntax, internal to edit.
  std::uint32_t element = ~std::uint32_t{0};
  std::uint32_t block = ~std::uint32_t{0};
};

/// One number, word or text of a field.
struct FieldPart {
  std::string_view name;  ///< "x"; the name of the field if it has only one part
  bool is_number = true;
  NumberRange range;  ///< of a number
  std::string value;  ///< UTF-8 as written, or where the file has none, what a new field has
  bool written = false;
  TextRange place;  ///< in the text, with escapes and the quotes of JSON; if written
};

/// The number that the part has; of text that is not one, what it begins with, or 0.
double number_of(const FieldPart& part);

/// A field of an item.
struct FieldView {
  std::string_view name;   ///< in the file's dialect, such as "heightangle"
  std::string_view title;  ///< "Height angle"
  ValueKind kind = ValueKind::number;
  std::vector<FieldPart> parts;
  std::vector<std::string> choices;
  bool written = false;
  bool needed = false;     ///< the item needs it: it should not be removed
  bool effective = true;   ///< false: written, but without effect on this type of light
  bool transform = false;  ///< places its item; in XML there may be several in any order
  TextRange place;         ///< of the element, entry or attribute in the text, if written
  std::uint32_t element = ~std::uint32_t{0};  ///< internal to edit
};

/// A number as both dialects accept it: as typed where possible. Otherwise an error that says what
/// the part needs. Texts are accepted as they are.
Result<std::string> parse_value(const FieldView& field, std::size_t part, std::string_view typed);

class Document {
 public:
  /// Reads the text of a scene file. Fails if it is not well-formed XML or valid JSON (also if
  /// `--compat course` would repair it), or is in UTF-16; other errors of the scene do not matter.
  static Result<Document> open(std::string text, const ReadOptions& options);

  const std::string& text() const;
  bool is_xml() const;
  const ReadOptions& options() const;
  const Scene& scene() const;
  /// What read_scene() found.
  const Diagnostics& findings() const;

  /// Global data, camera, lights (XML), templates and the root, each before its contents.
  std::span<const SceneItem> items() const;
  const SceneItem& operator[](ItemId item) const { return items()[item]; }
  /// The item that contains this byte; the innermost.
  std::optional<ItemId> item_at(std::uint32_t offset) const;
  /// The item that contains a place: that of a node, primitive, light, transform or value.
  std::optional<ItemId> item_of(Location place) const;
  /// The fields that the item has or can have.
  std::vector<FieldView> fields(ItemId item) const;
  /// The range of an item with the comments that belong to it: after it on its last line if it
  /// begins a line, and on the lines directly above.
  TextRange with_comments(ItemId item) const;
  /// The templates that can be instantiated in a group: those declared before it.
  std::vector<std::string> templates_for(ItemId group) const;

  struct State;  ///< internal to edit: document_state.h
  const State& state() const { return *state_; }

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace scenefile
