#include "scenefile/viewer/script.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/viewer/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

namespace scenefile::viewer {

namespace {

constexpr std::array<std::string_view, 3> button_names{"left", "right", "middle"};

// Whether the key has an effect in the window or its menus and fields.
bool is_key(std::string_view text) {
  constexpr std::array<std::string_view, 4> others{"Shift", "Left", "Right", "Space"};
  const KeyPress key = parse_key(text);
  return action_of(key) != nullptr || is_flying_key(key) || is_assignment_key(key) ||
         std::find(others.begin(), others.end(), key.name) != others.end();
}

/// Splits a line into words.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string next() {
    const std::size_t begin = std::min(rest_.find_first_not_of(blanks), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(blanks, begin), rest_.size());
    std::string word(rest_.substr(begin, end - begin));
    rest_.remove_prefix(end);
    return word;
  }
  /// The rest of the line, trimmed.
  std::string rest() {
    const std::size_t begin = std::min(rest_.find_first_not_of(blanks), rest_.size());
    const std::size_t last = rest_.find_last_not_of(blanks);
    return last == std::string_view::npos || begin > last
               ? std::string()
               : std::string(rest_.substr(begin, last - begin + 1));
  }
  double number() {
    const ParsedNumber number = parse_number(next());
    bad_ = bad_ || number.error != NumberError::none;
    return number.value;
  }
  int frames() {
    const double value = number();
    bad_ = bad_ || !(value >= 1 && value <= 100000);
    return bad_ ? 1 : static_cast<int>(value);
  }
  int button() {
    const auto* const found = std::find(button_names.begin(), button_names.end(), next());
    bad_ = bad_ || found == button_names.end();
    return static_cast<int>(found - button_names.begin());
  }
  /// Whether a word was invalid, or some are left over.
  bool bad() { return bad_ || !rest().empty(); }

 private:
  static constexpr std::string_view blanks = " \t\r";
  std::string_view rest_;
  bool bad_ = false;
};

class ScriptParser {
 public:
  // Returns false if the line is invalid.
  bool parse(std::string_view line, std::uint32_t number) {
    line_ = number;
    Words words(line);
    const std::string verb = words.next();
    return pointer_step(verb, words) || other_step(verb, words);
  }

  std::vector<ScriptStep> steps;

 private:
  ScriptStep& add(StepKind kind) {
    ScriptStep step;
    step.kind = kind;
    step.line = line_;
    return steps.emplace_back(std::move(step));
  }
  void add_move(double x, double y) {
    ScriptStep& step = add(StepKind::move);
    step.x = x;
    step.y = y;
  }
  void add_click(StepKind kind, int button) { add(kind).number = button; }

  bool drag(Words& words) {
    const int button = words.button();
    const double x0 = words.number();
    const double y0 = words.number();
    const double x1 = words.number();
    const double y1 = words.number();
    const int count = words.frames();
    if (words.bad()) {
      return false;
    }
    add_move(x0, y0);
    add_click(StepKind::press, button);
    for (int i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      add_move(x0 + (x1 - x0) * share, y0 + (y1 - y0) * share);
    }
    add_click(StepKind::release, button);
    return true;
  }

  bool click(Words& words) {
    const double x = words.number();
    const double y = words.number();
    add_move(x, y);
    add_click(StepKind::press, 0);
    add_click(StepKind::release, 0);
    return !words.bad();
  }

  bool pointer_step(const std::string& verb, Words& words) {
    if (verb == "drag") {
      return drag(words);
    }
    if (verb == "click") {
      return click(words);
    }
    if (verb == "move") {
      const double x = words.number();
      add_move(x, words.number());
    } else if (verb == "press" || verb == "release") {
      add_click(verb == "press" ? StepKind::press : StepKind::release, words.button());
    } else if (verb == "wheel") {
      add(StepKind::wheel).y = words.number();
    } else {
      return false;
    }
    return !words.bad();
  }

  bool other_step(const std::string& verb, Words& words) {
    if (verb == "key" || verb == "drop" || verb == "screenshot" || verb == "copied" ||
        verb == "times") {
      ScriptStep& step = add(verb == "key"      ? StepKind::key
                             : verb == "drop"   ? StepKind::drop
                             : verb == "copied" ? StepKind::copied
                             : verb == "times"  ? StepKind::times
                                                : StepKind::screenshot);
      step.text = words.rest();
      return step.kind == StepKind::key          ? is_key(step.text)
             : step.kind == StepKind::screenshot ? step.text.ends_with(".png")
                                                 : !step.text.empty();
    }
    if (verb == "hold") {
      ScriptStep& step = add(StepKind::hold);
      step.text = words.next();
      step.number = words.frames();
      return !words.bad() && is_key(step.text);
    }
    if (verb == "frames") {
      add(StepKind::frames).number = words.frames();
    } else if (verb == "copy") {
      ScriptStep& step = add(StepKind::copy);
      step.text = words.next();
      step.other = words.next();
      return !step.other.empty() && !words.bad();
    } else if (verb == "settle" || verb == "quit") {
      add(verb == "settle" ? StepKind::settle : StepKind::quit);
    } else {
      return false;
    }
    return !words.bad();
  }

  std::uint32_t line_ = 0;
};

}  // namespace

Script parse_script(std::string_view text) {
  ScriptParser parser;
  std::uint32_t number = 0;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') {
      continue;
    }
    if (!parser.parse(line, number)) {
      return {{}, fmt::format("line {}: this is not a step", number)};
    }
  }
  return {std::move(parser.steps), {}};
}

}  // namespace scenefile::viewer
