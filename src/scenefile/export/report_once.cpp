#include "scenefile/export/report_once.h"

#include <algorithm>

namespace scenefile {

void report_once(const Code& code, std::string_view message, Diagnostics& diagnostics) {
  const auto& list = diagnostics.list();
  const bool said = std::any_of(list.begin(), list.end(), [&](const Diagnostic& d) {
    return d.code == &code && d.message == message;
  });
  if (!said) {
    diagnostics.report(code, {}, std::string(message));
  }
}

}  // namespace scenefile
