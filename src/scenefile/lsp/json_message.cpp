#include "scenefile/lsp/json_message.h"

#include "scenefile/base/number.h"

namespace scenefile {

JsonView JsonView::operator[](std::string_view name) const {
  if (!is_object()) {
    return {};
  }
  for (JsonIndex key = at_ + 1; key < tape_->end(at_); key = tape_->end(key + 1)) {
    if (tape_->raw(key) == name) {
      return {*tape_, key + 1};
    }
  }
  return {};
}

std::vector<JsonView> JsonView::elements() const {
  std::vector<JsonView> result;
  if (exists() && tape_->is_array(at_)) {
    for (JsonIndex item = at_ + 1; item < tape_->end(at_); item = tape_->end(item)) {
      result.emplace_back(*tape_, item);
    }
  }
  return result;
}

std::string JsonView::string() const {
  return exists() && tape_->is_string(at_) ? tape_->string(at_) : std::string();
}

double JsonView::number() const {
  return exists() && tape_->is_number(at_) ? parse_number(tape_->raw(at_)).value : 0;
}

std::string_view JsonView::raw() const {
  if (!exists()) {
    return {};
  }
  if (is_object() || tape_->is_array(at_)) {
    return "null";
  }
  const std::size_t quote = tape_->is_string(at_) ? 2 : 0;
  return tape_->text.substr(tape_->items[at_].offset, tape_->raw(at_).size() + quote);
}

}  // namespace scenefile
