#pragma once
// Escaping of text for both writers. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Appends `text` as the value of an XML attribute. Characters that XML cannot represent become
/// U+FFFD. Returns whether all could be represented.
bool append_xml(std::string& out, std::string_view text);

/// Appends `text` as a JSON string, with quotes. Bytes that are not UTF-8 become U+FFFD. Returns
/// whether all could be represented.
bool append_json(std::string& out, std::string_view text);

/// Reports that the output exceeds the nesting limit of the readers.
void report_nesting(const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
