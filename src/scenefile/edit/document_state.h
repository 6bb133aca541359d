#pragma once
// What a document knows about its text. Internal to edit.

#include "scenefile/edit/document.h"
#include "scenefile/edit/field_words.h"
#include "scenefile/edit/syntax.h"
#include "scenefile/format/xml_fields.h"
#include "scenefile/format/xml_values.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct Document::State {
  std::string text;
  ReadOptions options;
  Syntax syntax;
  Scene scene;
  Diagnostics findings;
  std::vector<SceneItem> items;
  std::string declaration;  ///< the XML declaration, if it says that the text is not UTF-8

  /// Text of the file in UTF-8.
  std::string utf8(std::string_view bytes) const;
  /// UTF-8 as an attribute value of the file, escaped.
  std::string attribute_value(std::string_view text) const;
};

/// Fills `items` from the syntax and the scene.
void find_items(Document::State& state);

/// A start tag as the XML reader gets it: values in UTF-8, without references. Not copyable.
struct ReadTag {
  ReadTag(const Document::State& state, PartId element);
  ReadTag(const ReadTag&) = delete;
  ReadTag& operator=(const ReadTag&) = delete;

  const WrittenAttribute* written_as(const XmlAttribute* attribute) const {
    return attribute == nullptr ? nullptr
                                : &written[static_cast<std::size_t>(attribute - attributes.data())];
  }

  std::vector<WrittenAttribute> written;
  std::vector<std::string> values;
  std::vector<XmlAttribute> attributes;
  XmlTag tag;
};

/// The context for functions of the XML reader whose findings are already known.
struct SilentReader {
  explicit SilentReader(const Document::State& state)
      : found(state.options.limits),
        places(std::string_view(state.text).substr(0, 0)),
        context{state.options, found, places} {}

  Diagnostics found;
  TextPlaces places;
  const XmlContext context;
};

/// The attributes of an XML field's parts as the reader takes them; nullptr: missing.
std::vector<const WrittenAttribute*> field_attributes(const XmlContext& context,
                                                      const ReadTag& element,
                                                      const FieldWord& word);

/// The field word of an element or entry in an item of that kind, as the reader takes its name;
/// nullptr if it is not one.
const FieldWord* word_of_child(const Document::State& state, const XmlContext& context,
                               ItemKind kind, PartId child);

/// The name that the reader gives to a child of <scenefile> or of a transblock; empty: none.
std::string_view child_name(const Document::State& state, const XmlContext& context, PartId child);

/// The object elements in a transblock that count: with `--compat course` all, otherwise the first.
std::vector<PartId> objects_in(const Document::State& state, const XmlContext& context,
                               PartId block);

}  // namespace scenefile
