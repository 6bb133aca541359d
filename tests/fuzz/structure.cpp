#include "structure.h"

#include <array>
#include <cctype>
#include <string_view>
#include <vector>

namespace scenefile::fuzz {

namespace {

// A part of the text that can be moved.
struct Span {
  std::size_t begin;
  std::size_t end;

  std::size_t size() const { return end - begin; }
};

constexpr std::array<std::string_view, 24> numbers = {
    "0",   "-0", "1",  "-1",  "0.5",   "1e30", "-1e30", "1e-30", "3e38", "-3e38", "1e400", "1e-46",
    "nan", "",   "90", "180", "359.9", "1e-7", "1e7",   "2",     "1e19", "1e-12", "8",     "255"};

std::size_t pick(Random& random, std::size_t count) {
  return random() % count;
}

void add_xml_spans(std::string_view text, std::vector<Span>& spans) {
  std::vector<std::size_t> open;
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
    const std::size_t close = text.find('>', at);
    if (close == text.npos) {
      return;
    }
    if (text[at + 1] == '/') {
      if (!open.empty()) {
        spans.push_back({open.back(), close + 1});
        open.pop_back();
      }
    } else if (text[close - 1] == '/' || text[at + 1] == '!' || text[at + 1] == '?') {
      spans.push_back({at, close + 1});
    } else {
      open.push_back(at);
    }
  }
}

// Objects and arrays, together with their keys.
void add_json_spans(std::string_view text, std::vector<Span>& spans) {
  std::vector<std::size_t> open;
  std::size_t item = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || c == '[') {
      open.push_back(item);
      item = at + 1;
    } else if (c == ',' || c == '}' || c == ']') {
      spans.push_back({item, at});
      item = at + 1;
      if (c != ',' && !open.empty()) {
        item = open.back();
        open.pop_back();
      }
    }
  }
}

std::vector<Span> spans_of(std::string_view text) {
  std::vector<Span> spans;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) {
    return spans;
  }
  if (text[first] == '<') {
    add_xml_spans(text, spans);
  } else {
    add_json_spans(text, spans);
  }
  return spans;
}

bool is_json(std::string_view text) {
  return text.find_first_of("{[") == text.find_first_not_of(" \t\r\n");
}

std::string replace_number(std::string text, Random& random) {
  std::vector<Span> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::size_t end = at;
    while (end < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.')) {
      ++end;
    }
    if (end != at) {
      found.push_back({at != 0 && text[at - 1] == '-' ? at - 1 : at, end});
      at = end;
    }
  }
  if (found.empty()) {
    return text;
  }
  const Span span = found[pick(random, found.size())];
  return text.replace(span.begin, span.size(), numbers[pick(random, numbers.size())]);
}

std::string swapped(const std::string& text, Span a, Span b) {
  if (b.begin < a.begin) {
    std::swap(a, b);
  }
  if (b.begin < a.end) {
    return text;
  }
  return text.substr(0, a.begin) + text.substr(b.begin, b.size()) +
         text.substr(a.end, b.begin - a.end) + text.substr(a.begin, a.size()) + text.substr(b.end);
}

}  // namespace

std::string restructured(const std::string& text, Random& random) {
  const std::vector<Span> spans = spans_of(text);
  const std::size_t way = pick(random, 8);
  if (spans.empty() || way >= 5) {
    return replace_number(text, random);
  }
  const Span a = spans[pick(random, spans.size())];
  const Span b = spans[pick(random, spans.size())];
  const std::string comma = is_json(text) ? "," : "";
  std::string changed = text;
  switch (way) {
    case 0:  // removed, with the comma after it
      return changed.erase(a.begin, a.size() + (changed[a.end] == ',' ? 1 : 0));
    case 1:  // duplicated
      return changed.insert(a.end, comma + text.substr(a.begin, a.size()));
    case 2:
      return swapped(text, a, b);
    case 3:  // replaced
      return changed.replace(a.begin, a.size(), text.substr(b.begin, b.size()));
    default:  // inserted after another
      return changed.insert(b.end, comma + text.substr(a.begin, a.size()));
  }
}

}  // namespace scenefile::fuzz
