#pragma once
// Explains to the author of a text why it is not well-formed XML, and repairs comments. Internal to
// format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/xml_judge.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

struct OpenElement {
  std::string_view name;
  Location location;
};

/// The offset of the first reference to an entity not predefined in XML; npos if there is none.
std::size_t find_entity_use(std::string_view markup);

/// Reports the fault of `text`; `open` lists the open elements.
void report_syntax(const XmlFault& fault, std::string_view text, std::span<const OpenElement> open,
                   Diagnostics& diagnostics);

/// Reports comments that contain -- and comments that start with <--, which are invalid in XML, but
/// which the parsers of the course's programs accept, and overwrites what is wrong with them. The
/// result has the same length, and text outside of comments is unchanged. Returns nullopt if there
/// are none. A comment ends at the first -->.
std::optional<std::string> repair_comments(std::string_view text, const ReadOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace scenefile
