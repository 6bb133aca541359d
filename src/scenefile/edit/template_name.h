#pragma once
// Which names a template can have.

#include <string>
#include <string_view>

namespace scenefile {

/// Why a template cannot get a name that is not its own; empty if it can. `taken`: another template
/// has it, or something that would become an instance.
std::string why_no_template_name(std::string_view name, bool is_xml, bool taken);

}  // namespace scenefile
