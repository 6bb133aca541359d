#include "scenefile/format/json_repair.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/text_places.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

class Repair {
 public:
  Repair(std::string_view text, Diagnostics& diagnostics)
      : text_(text), diagnostics_(diagnostics), places_(text) {}

  RepairedJson run() {
    bool in_string = false;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      const char c = text_[at];
      if (c == '.' && !in_string) {
        copy_point(at);
        continue;
      }
      result_.text += c;
      if (in_string && c == '\\' && at + 1 < text_.size()) {
        result_.text += text_[++at];
      } else if (c == '"') {
        in_string = !in_string;
      }
    }
    return std::move(result_);
  }

 private:
  // A decimal point needs a digit on each side; adds the missing one.
  void copy_point(std::size_t at) {
    const bool before = at > 0 && is_digit(text_[at - 1]);
    const bool after = at + 1 < text_.size() && is_digit(text_[at + 1]);
    if (!before && after) {
      insert_zero();
    }
    result_.text += '.';
    if (before && !after) {
      insert_zero();
    }
    if (before != after) {
      const std::string_view part = text_.substr(before ? at - 1 : at, 2);
      diagnostics_.report(json_number, Severity::warning, places_.at(at),
                          fmt::format("a number with {} is not JSON; it is read with a zero {} the "
                                      "point, as by the course's programs",
                                      quoted(part), before ? "after" : "before"));
    }
  }

  void insert_zero() {
    result_.inserted.push_back(result_.text.size());
    result_.text += '0';
  }

  std::string_view text_;
  Diagnostics& diagnostics_;
  TextPlaces places_;
  RepairedJson result_;
};

}  // namespace

std::size_t RepairedJson::original_offset(std::size_t offset) const {
  const auto first_after = std::lower_bound(inserted.begin(), inserted.end(), offset);
  return offset - static_cast<std::size_t>(first_after - inserted.begin());
}

RepairedJson repair_json_numbers(std::string_view text, Diagnostics& diagnostics) {
  return Repair(text, diagnostics).run();
}

}  // namespace scenefile
