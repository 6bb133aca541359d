#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/json_fields.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_syntax.h"
#include "scenefile/format/layout_lines.h"
#include "scenefile/format/text_places.h"

namespace scenefile {

namespace {

constexpr std::size_t max_list_bytes = 80;

class JsonLayout {
 public:
  explicit JsonLayout(const JsonTape& tape) : tape_(tape), lines_(line_end_of(tape.text)) {}

  std::string make() {
    place(0);
    while (!open_.empty()) {
      const Container top = open_.back();
      if (next_ == tape_.end(top.item)) {
        open_.pop_back();
        close(top);
      } else {
        place_inside(top);
      }
    }
    return lines_.finish();
  }

 private:
  struct Container {
    JsonIndex item;
    bool is_object;
    bool in_line;
  };

  bool is_container(JsonIndex item) const { return tape_.is_object(item) || tape_.is_array(item); }

  std::string_view raw(JsonIndex item) const {
    const JsonItem& it = tape_.items[item];
    return tape_.text.substr(it.offset, it.extent);
  }

  // Prints a scalar, or the opening bracket of a container.
  void place(JsonIndex item) {
    next_ = item + 1;
    if (!is_container(item)) {
      lines_.add(raw(item));
      behind_ = tape_.items[item].offset + tape_.items[item].extent;
      return;
    }
    const bool is_object = tape_.is_object(item);
    behind_ = tape_.items[item].offset + 1;
    lines_.add(is_object ? "{" : "[");
    open_.push_back({item, is_object, fits_line(item)});
  }

  void place_inside(const Container& top) {
    const bool first = next_ == top.item + 1;
    lines_.add(first ? "" : ",");
    if (!top.in_line) {
      lines_.start_line(open_.size(), !first && blank_line_before(next_));
    } else if (!first) {
      lines_.add(" ");
    }
    if (top.is_object) {
      lines_.add(raw(next_));
      lines_.add(": ");
      ++next_;
    }
    place(next_);
  }

  void close(const Container& container) {
    if (!container.in_line && next_ != container.item + 1) {
      lines_.start_line(open_.size(), false);
    }
    lines_.add(container.is_object ? "}" : "]");
    behind_ = tape_.text.find(container.is_object ? '}' : ']', behind_) + 1;
  }

  // Whether the item is a short list of scalars, at any depth.
  bool fits_line(JsonIndex item) const {
    if (tape_.is_object(item)) {
      return false;
    }
    std::size_t bytes = 0;
    for (JsonIndex i = item + 1; i < tape_.end(item); ++i) {
      if (is_container(i)) {
        return false;
      }
      bytes += raw(i).size() + 2;
    }
    return bytes <= max_list_bytes;
  }

  // Whether the author left an empty line before the item, possibly with a comma in between.
  bool blank_line_before(JsonIndex item) const {
    return count_line_ends(tape_.text.substr(behind_, tape_.items[item].offset - behind_)) > 1;
  }

  const JsonTape& tape_;
  LinePrinter lines_;
  std::vector<Container> open_;
  JsonIndex next_ = 0;
  std::size_t behind_ = 0;  // offset after the last printed token
};

}  // namespace

std::optional<std::string> lay_out_json(std::string_view text, const Limits& limits,
                                        Diagnostics& diagnostics) {
  JsonTape tape;
  const JsonError error = parse_json(text, limits.nesting, tape);
  if (error.fault != JsonFault::none) {
    report_json_error(error, text, limits, diagnostics);
    return std::nullopt;
  }
  if (!tape.is_object(0)) {
    diagnostics.report(json_wrong_type, TextPlaces(text).at(tape.items[0].offset),
                       "a scene must be an object, found " + describe_json(tape, 0));
    return std::nullopt;
  }
  return JsonLayout(tape).make();
}

}  // namespace scenefile
