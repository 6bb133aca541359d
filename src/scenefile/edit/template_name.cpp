#include "scenefile/edit/template_name.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile {

std::string why_no_template_name(std::string_view name, bool is_xml, bool taken) {
  if (name.empty()) {
    return "a template needs a name";
  }
  if (is_xml && name == "root") {
    return "the name \"root\" is reserved for the scene itself";
  }
  return taken ? fmt::format("the name {} is taken", quoted(name)) : std::string();
}

}  // namespace scenefile
