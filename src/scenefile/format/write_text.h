#pragma once
// Escaping of text for both writers. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/format/write_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Appends `text` as the value of an XML attribute. Characters that XML cannot represent become
/// U+FFFD. Returns whether all could be represented.
bool append_xml(std::string& out, std::string_view text);

/// The text of an attribute's value: the opposite of append_xml(). What is not a reference to a
/// character stays as it is.
std::string unescaped_xml(std::string_view value);

/// Appends `text` as a JSON string, with quotes. Bytes that are not UTF-8 become U+FFFD. Returns
/// whether all could be represented.
bool append_json(std::string& out, std::string_view text);

/// Starts the lines of a text: indents them, or, in a listing, notes where they come from.
class LineStarts {
 public:
  explicit LineStarts(std::vector<ListedLine>* listing) : listing_(listing) {}

  bool listing() const { return listing_ != nullptr; }
  /// What the next lines come from.
  void at(std::string_view what, Location place, NodeId node = ListedLine::no_group) {
    next_ = {0, what, place, node, 0};
  }
  void start(std::string& out, std::size_t depth);
  /// The number; a listing writes -0 as 0, because both are the same value in a comparison.
  std::string number(float value) const;

 private:
  std::vector<ListedLine>* listing_;
  ListedLine next_;
};

/// Limits for a listing: no nesting is too deep.
Limits listing_limits();

/// Reports that the output exceeds the nesting limit of the readers.
void report_nesting(const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
