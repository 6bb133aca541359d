#include "scenefile/format/json_plain.h"

#include "scenefile/base/text.h"

#include <array>
#include <cstddef>
#include <vector>

namespace scenefile {

namespace {

// What a character may be, as bits.
enum CharacterClass : std::uint8_t { blank = 1, digit = 2, string_part = 4 };

// } and ] end every run of characters of one class, so that a text that ends with one of them needs
// no other guard. Bytes from 128 on are in no class.
constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned c = ' '; c < 128; ++c) {
    const bool special = c == '"' || c == '\\' || c == '}' || c == ']';
    classes[c] =
        static_cast<std::uint8_t>((special ? 0 : string_part) | (c >= '0' && c <= '9' ? digit : 0));
  }
  for (const unsigned c : {' ', '\t', '\n', '\r'}) {
    classes[c] |= blank;
  }
  return classes;
}
constexpr std::array<std::uint8_t, 256> classes = make_classes();

bool is(char c, CharacterClass what) {
  return (classes[static_cast<unsigned char>(c)] & what) != 0;
}

const char* skip(const char* p, CharacterClass what) {
  while (is(*p, what)) {
    ++p;
  }
  return p;
}

std::string_view between(const char* first, const char* last) {
  return {first, static_cast<std::size_t>(last - first)};
}

class PlainReader {
 public:
  PlainReader(std::string_view text, std::uint32_t max_depth, JsonTape& tape)
      : tape_(tape),
        max_depth_(max_depth),
        begin_(text.data()),
        p_(text.data()),
        end_(text.data() + text.find_last_not_of(" \t\r\n") + 1) {}

  bool run();

 private:
  bool read_value();
  bool read_behind_value();
  bool read_string();
  bool read_key();
  bool read_number();
  bool read_word(std::string_view word);
  void open();
  void close();
  void add(const char* from) {
    tape_.items.push_back(
        {static_cast<std::uint32_t>(from - begin_), static_cast<std::uint32_t>(p_ - from)});
  }

  struct Container {
    JsonIndex item;
    char closing;
  };

  JsonTape& tape_;
  std::uint32_t max_depth_;
  const char* begin_;
  const char* p_;
  const char* end_;  // the last character before it is } or ]
  std::vector<Container> open_;
};

bool PlainReader::run() {
  if (p_ == end_ || (end_[-1] != '}' && end_[-1] != ']')) {
    return false;
  }
  p_ = skip(p_, blank);
  do {
    if (!read_value() || !read_behind_value()) {
      return false;
    }
  } while (!open_.empty());
  return p_ == end_;
}

// A scalar or an empty container; of another container, all up to such a value in it.
bool PlainReader::read_value() {
  while (*p_ == '{' || *p_ == '[') {
    if (open_.size() == max_depth_) {
      return false;
    }
    open();
    if (*p_ == open_.back().closing) {
      close();
      return true;
    }
    if (open_.back().closing == '}' && !read_key()) {
      return false;
    }
  }
  switch (*p_) {
    case '"':
      return read_string();
    case 't':
      return read_word("true");
    case 'f':
      return read_word("false");
    case 'n':
      return read_word("null");
    default:
      return read_number();
  }
}

// Up to the next value, or the end of all.
bool PlainReader::read_behind_value() {
  while (!open_.empty() && p_ != end_) {
    p_ = skip(p_, blank);
    const char closing = open_.back().closing;
    if (*p_ == ',') {
      p_ = skip(p_ + 1, blank);
      return closing == ']' || read_key();
    }
    if (*p_ != closing) {
      return false;
    }
    close();
  }
  return open_.empty();
}

void PlainReader::open() {
  open_.push_back({static_cast<JsonIndex>(tape_.items.size()), *p_ == '{' ? '}' : ']'});
  tape_.items.push_back({static_cast<std::uint32_t>(p_ - begin_), 0});
  p_ = skip(p_ + 1, blank);
}

void PlainReader::close() {
  const JsonIndex item = open_.back().item;
  tape_.items[item].extent = static_cast<std::uint32_t>(tape_.items.size()) - item - 1;
  open_.pop_back();
  ++p_;
}

// With the colon and the blanks behind it.
bool PlainReader::read_key() {
  if (*p_ != '"' || !read_string()) {
    return false;
  }
  p_ = skip(p_, blank);
  if (*p_ != ':') {
    return false;
  }
  p_ = skip(p_ + 1, blank);
  return true;
}

bool PlainReader::read_string() {
  const char* const from = p_++;
  while (*(p_ = skip(p_, string_part)) != '"') {
    const CodePoint c = first_code_point(between(p_, end_));
    if (c.value < ' ' || c.value == '\\') {
      return false;
    }
    p_ += c.bytes;
    if (p_ == end_) {
      return false;
    }
  }
  ++p_;
  add(from);
  return true;
}

bool PlainReader::read_word(std::string_view word) {
  const char* const from = p_;
  if (!between(p_, end_).starts_with(word)) {
    return false;
  }
  p_ += word.size();
  add(from);
  return true;
}

bool PlainReader::read_number() {
  constexpr std::ptrdiff_t longest = 64;
  const char* const from = p_;
  const auto digits = [&] {
    const char* const first = p_;
    p_ = skip(p_, digit);
    return p_ != first;
  };
  p_ += *p_ == '-';
  const bool zero = *p_ == '0';
  const char* const whole = p_;
  if (!digits() || (zero && p_ != whole + 1)) {
    return false;
  }
  if (*p_ == '.') {
    ++p_;
    if (!digits()) {
      return false;
    }
  }
  if (*p_ == 'e' || *p_ == 'E') {
    if (*++p_ != '-') {
      return false;
    }
    ++p_;
    if (!digits()) {
      return false;
    }
  }
  add(from);
  return p_ - from <= longest;
}

}  // namespace

bool read_plain_json(std::string_view text, std::uint32_t max_depth, JsonTape& tape) {
  begin_tape(text, tape);
  return PlainReader(text, max_depth, tape).run();
}

}  // namespace scenefile
