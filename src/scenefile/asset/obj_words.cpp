#include "scenefile/asset/obj_words.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"

#include <string>

namespace scenefile {

namespace {

// Lines can be many megabytes long; counting their characters for each finding would be quadratic.
constexpr std::size_t max_counted = 65536;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

ObjWords::ObjWords(std::string_view text) : text_(without_byte_order_mark(text)) {}

// Length of the line end at this position: 0, 1, or 2 for CR LF.
std::size_t ObjWords::line_end_bytes(std::size_t at) const {
  if (at >= text_.size() || !is_line_end(text_[at])) {
    return 0;
  }
  return text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1;
}

void ObjWords::pass_line_end(std::size_t bytes) {
  at_ += bytes;
  ++line_;
  line_start_ = at_;
}

// Also skips a backslash at the end of a line, which continues the statement on the next line.
void ObjWords::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (const std::size_t end = text_[at_] == '\\' ? line_end_bytes(at_ + 1) : 0; end > 0) {
      ++at_;
      pass_line_end(end);
    } else {
      return;
    }
  }
}

void ObjWords::skip_comment() {
  while (at_ < text_.size() && !is_line_end(text_[at_])) {
    ++at_;
  }
}

bool ObjWords::next_statement() {
  while (inside_ && !next_word().empty()) {
  }
  inside_ = false;
  while (true) {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '#') {
      skip_comment();
    }
    if (at_ >= text_.size()) {
      return false;
    }
    const std::size_t end = line_end_bytes(at_);
    if (end == 0) {
      inside_ = true;
      return true;
    }
    pass_line_end(end);
  }
}

std::string_view ObjWords::next_word() {
  skip_blanks();
  const std::size_t start = at_;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (is_blank(c) || is_line_end(c) || c == '#' || (c == '\\' && line_end_bytes(at_ + 1) > 0)) {
      break;
    }
    ++at_;
  }
  return text_.substr(start, at_ - start);
}

// Whether a # belongs to the name that ends at `end`, as in "wall#2" and "Material #25".
bool ObjWords::number_sign_in_name(std::size_t end) const {
  return at_ < text_.size() && text_[at_] == '#' &&
         (at_ == end || (at_ + 1 < text_.size() && is_digit(text_[at_ + 1])));
}

std::string_view ObjWords::rest(std::string_view first) {
  const auto start = static_cast<std::size_t>(first.data() - text_.data());
  std::size_t end = start + first.size();
  while (true) {
    skip_blanks();
    if (end > start && number_sign_in_name(end)) {
      ++at_;
    } else if (next_word().empty()) {
      break;
    }
    end = at_;
  }
  return text_.substr(start, end - start);
}

Location ObjWords::location(std::string_view word) const {
  const auto at = static_cast<std::size_t>(word.data() - text_.data());
  if (at < line_start_) {
    return {line_, 1};
  }
  const std::size_t bytes = at - line_start_;
  const std::size_t counted = bytes < max_counted ? bytes : max_counted;
  const std::size_t before =
      count_code_points(text_.substr(line_start_, counted)) + (bytes - counted);
  return {line_, static_cast<std::uint32_t>(before + 1)};
}

std::vector<FileReference> library_names(ObjWords& words) {
  std::vector<FileReference> names;
  const std::string_view first = words.next_word();
  if (first.empty()) {
    return names;
  }
  const Location location = words.location(first);
  const std::string_view line = words.rest(first);
  for (ObjWords each(line); each.next_statement();) {
    for (std::string_view word = each.next_word(); !word.empty(); word = each.next_word()) {
      names.push_back({std::string(word), location});
    }
  }
  if (names.empty() || names.front().name != line) {
    names.push_back({std::string(line), location});
  }
  return names;
}

}  // namespace scenefile
