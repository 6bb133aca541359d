#include "app/help.h"

#include "app/codes_page.h"
#include "app/json.h"
#include "app/limit_table.h"
#include "app/manual.h"
#include "app/option_table.h"
#include "app/output.h"
#include "app/wrap.h"
#include "scenefile/base/text.h"
#include "scenefile/mistakes/cause_help.h"
#include "scenefile/scene/vocabulary_words.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

// The start of the second column.
std::size_t second_column(std::size_t width, std::size_t usual) {
  return width >= usual + 40 ? usual : 6;
}

// Two columns; the second starts on a new line if the first is too long.
std::string columns_text(std::string_view first, std::string_view second, std::size_t column,
                         std::size_t width) {
  const bool fits = first.size() + 2 <= column;
  return fmt::format("{}{}{:{}}{}\n", first, fits ? "" : "\n", "",
                     fits ? column - first.size() : column, wrapped(second, column, column, width));
}

std::string option_text(const OptionRow& row, std::size_t width) {
  const std::string head = fmt::format("  {}{}{}{}{}", row.letter, row.letter.empty() ? "" : ", ",
                                       row.name, row.value.empty() ? "" : " ", row.value);
  return columns_text(head, row.help, second_column(width, 24), width);
}

// "scenefile check SCENE...".
std::string usage_text(const Command& command) {
  return fmt::format("scenefile {}{}{}", command.name, command.arguments.empty() ? "" : " ",
                     command.arguments);
}

std::string example_text(std::string_view lines, std::size_t width) {
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    result += fmt::format("  {}\n", wrapped(lines.substr(0, end), 2, 6, width, " \\"));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return result;
}

std::string no_such_topic(const std::string& topic) {
  std::vector<std::string_view> known = help_topics();
  known.insert(known.end(), code_families().begin(), code_families().end());
  const auto longer = std::find_if(known.begin(), known.end(), [&](std::string_view name) {
    return topic.size() >= 3 && name.starts_with(topic);
  });
  return fmt::format("unknown topic {}{}", scenefile::quoted(topic),
                     longer == known.end() ? did_you_mean(topic, known)
                                           : fmt::format("; did you mean {}?", *longer));
}

bool is_family(std::string_view name) {
  const auto families = code_families();
  return std::find(families.begin(), families.end(), name) != families.end();
}

std::string vocabulary_text(std::size_t width) {
  std::string text = "Elements of XML\n";
  for (const ElementWord& element : element_words()) {
    std::vector<std::string_view> attributes;
    for (const AttributeWord& attribute : element.attributes) {
      attributes.push_back(attribute.name);
    }
    text += columns_text(
        fmt::format("  {}", element.name),
        fmt::format("{}{}{}", element.about,
                    attributes.empty() ? "" : " Attributes: ", fmt::join(attributes, " ")),
        22, width);
  }
  for (const ObjectWord& object : object_words()) {
    text += fmt::format("\nKeys of {} in JSON\n",
                        object.name.empty() ? std::string("the scene") : std::string(object.name));
    for (const KeyWord& key : object.keys) {
      text += columns_text(fmt::format("  {}", key.name), key.about, 22, width);
    }
  }
  return text;
}

// What an element and keys of that name mean; empty if there are none.
std::string word_text(std::string_view word, std::size_t width) {
  std::string text;
  if (const ElementWord* const element = find_element(word)) {
    text += wrapped(fmt::format("<{}> in XML: {}", word, element->about), 0, 2, width) + "\n";
    for (const AttributeWord& attribute : element->attributes) {
      text += columns_text(fmt::format("  {}", attribute.name), attribute.about, 14, width);
    }
  }
  std::vector<std::pair<const KeyWord*, std::string>> keys;  // with the objects that have them
  for (const ObjectWord& object : object_words()) {
    const std::string place = object.name.empty() ? "the scene" : std::string(object.name);
    if (const KeyWord* const key = find_key(object, word)) {
      const auto same = std::find_if(keys.begin(), keys.end(), [&](const auto& other) {
        return other.first->about == key->about;
      });
      if (same == keys.end()) {
        keys.emplace_back(key, place);
      } else {
        same->second += " and " + place;
      }
    }
  }
  for (const auto& [key, places] : keys) {
    text += wrapped(fmt::format("\"{}\" in JSON, in {}: {}{}{}", word, places, key->about,
                                key->example.empty() ? "" : " Example: ", key->example),
                    0, 2, width) +
            "\n";
  }
  return text;
}

// What has this name: a family of codes, a cause of wrong pictures, words of the format. Some are
// several of these.
std::string topic_text(const std::string& topic, std::optional<Cause> cause) {
  std::string text;
  for (const std::string& part :
       {is_family(topic) ? codes_text(help_width(), topic) : std::string(),
        cause ? cause_text(*cause) : std::string(), word_text(topic, help_width())}) {
    text += text.empty() || part.empty() ? part : "\n" + part;
  }
  return text;
}

// Families that have the name of a command need the word codes.
ExitCode run_help_codes(const std::string& given, const Options& options) {
  const std::string family = given.substr(0, given.find('.'));
  if (!is_family(family)) {
    return fail(ExitCode::usage, fmt::format("there are no codes {}.*{}", escaped(family),
                                             did_you_mean(family, code_families())));
  }
  return answer(options.json ? codes_json(family) : codes_text(help_width(), family));
}

}  // namespace

const Command* find_command(std::string_view name) {
  const auto all = commands();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::span<const std::string_view> command_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> result;
    for (const Command& command : commands()) {
      result.push_back(command.name);
    }
    return result;
  }();
  return names;
}

std::vector<std::string_view> help_topics() {
  std::vector<std::string_view> topics(command_names().begin(), command_names().end());
  topics.insert(topics.end(), {"codes", "causes", "limits", "vocabulary"});
  topics.insert(topics.end(), code_names().begin(), code_names().end());
  for (std::size_t i = 0; i < cause_count; ++i) {
    topics.push_back(name_of(static_cast<Cause>(i)));
  }
  return topics;
}

std::string overview_text() {
  const std::size_t width = help_width();
  std::string text =
      wrapped("scenefile reads, checks and renders scene files of the course CS123 / CSCI1230.", 0,
              0, width) +
      "\n\n";
  for (const Command& command : commands()) {
    text +=
        columns_text("  " + usage_text(command), command.summary, second_column(width, 38), width);
  }
  text += "\nMore:\n";
  for (const auto& [topic, what] :
       {std::pair("COMMAND", "a command with its options and examples"),
        {"CODE", "a finding, such as xml.number; or a family of them, such as xml"},
        {"codes [FAMILY]", "the codes of all findings, or of a family, such as render"},
        {"CAUSE", "a mistake that diff and grade name, such as normals"},
        {"causes", "the list of these mistakes"},
        {"limits", "how large a file may be, how deeply nested, and so on"},
        {"WORD", "an element or a key of the format, such as rotate"},
        {"vocabulary", "the list of these words"}}) {
    text += columns_text(fmt::format("  scenefile help {}", topic), what, second_column(width, 38),
                         width);
  }
  return text + "\n" +
         wrapped(
             "A file name of - means standard input or output. \"scenefile version\" prints "
             "the folder of the documentation, which these texts call docs/.",
             0, 0, width) +
         "\n\n" +
         wrapped(
             "Exit status: 0 fine (warnings included), 1 errors in the input, 2 wrong usage, 3 "
             "something cannot be read or written, 4 a limit was reached, 130 interrupted.",
             0, 0, width) +
         "\n";
}

std::string command_text(const Command& command) {
  const std::size_t width = help_width();
  std::string text =
      fmt::format("{}\n\n{}\n", wrapped(usage_text(command) + " [options]", 0, 6, width),
                  wrapped(command.description, 0, 0, width));
  for (const OptionGroup& group : option_groups()) {
    std::string rows;
    for (const OptionRow& row : group.rows) {
      rows += (row.commands & command.bit) != 0 ? option_text(row, width) : "";
    }
    text += rows.empty() ? "" : fmt::format("\n{}:\n{}", group.heading, rows);
  }
  text += "\nExamples:\n" + example_text(command.examples, width);
  return is_family(command.name)
             ? text + "\n" +
                   wrapped(fmt::format("\"scenefile help codes {0}\" lists the codes {0}.*.",
                                       command.name),
                           0, 0, width) +
                   "\n"
             : text;
}

std::string cause_text(Cause cause) {
  const CauseHelp& page = help_of(cause);
  const std::size_t width = help_width();
  const auto paragraph = [&](std::string_view label, std::string_view text) {
    return wrapped(fmt::format("{}: {}", label, text), 0, 0, width);
  };
  return fmt::format("{}\n\n{}\n\n{}\n\n{}\n", paragraph(name_of(cause), page.title),
                     paragraph("What it looks like", page.looks), paragraph("Why", page.why),
                     paragraph("Where to look", page.where));
}

// All causes, each with its title.
std::string causes_list() {
  const std::size_t width = help_width();
  std::string text = wrapped(
      "Mistakes that diff and grade name; \"scenefile help CAUSE\" explains one.", 0, 0, width);
  text += "\n\n";
  for (std::size_t i = 0; i < cause_count; ++i) {
    const CauseHelp& page = help_of(static_cast<Cause>(i));
    text += columns_text(fmt::format("  {}", name_of(page.cause)), page.title,
                         second_column(width, 20), width);
  }
  return text;
}

std::string code_text(const Code& code) {
  const std::size_t width = help_width();
  return wrapped(fmt::format("{}: {} ({}{})", code.name, code.summary, severities_text(code),
                             code.kind == CodeKind::dialect ? ": an error with --strict" : ""),
                 0, 2, width) +
         "\n\n" + wrapped(code.help, 0, 0, width) + "\n";
}

ExitCode run_help(const Options& options, Context& /*context*/) {
  if (!options.arguments.empty() && options.arguments.front() == "causes") {
    return answer(options.json       ? causes_json()
                  : options.markdown ? causes_markdown()
                                     : causes_list());
  }
  if (options.markdown) {
    return answer(codes_markdown());
  }
  if (options.completion.has_value()) {
    return answer(completion_script(*options.completion));
  }
  if (options.arguments.empty() && options.man) {
    return answer(manual_page());
  }
  if (options.arguments.empty()) {
    return answer(options.json ? help_json() : overview_text());
  }
  const std::string& topic = options.arguments.front();
  if (options.arguments.size() > 1) {
    if (topic == "codes") {
      return run_help_codes(options.arguments[1], options);
    }
    return fail(ExitCode::usage, fmt::format("help explains one topic; unexpected {}",
                                             scenefile::quoted(options.arguments[1])));
  }
  if (const Command* const command = find_command(topic); command != nullptr) {
    if (options.man) {
      return answer(manual_page(*command));
    }
    return answer(options.json ? command_json(*command) : command_text(*command));
  }
  if (const Code* const code = find_code(topic); code != nullptr) {
    return answer(options.json ? code_json(*code) : code_text(*code));
  }
  if (topic == "codes") {
    return answer(options.json ? codes_json() : codes_text(help_width()));
  }
  if (topic == "limits") {
    return answer(options.json ? limits_json() : limits_text(help_width()));
  }
  if (topic == "vocabulary") {
    return answer(options.json ? vocabulary_json() : vocabulary_text(help_width()));
  }
  const std::optional<Cause> cause = find_cause(topic);
  if (const std::string text = topic_text(topic, cause); !text.empty()) {
    return answer(!options.json      ? text
                  : is_family(topic) ? codes_json(topic, cause)
                  : cause            ? cause_json(*cause)
                                     : vocabulary_json(topic));
  }
  return fail(ExitCode::usage, no_such_topic(topic));
}

}  // namespace scenefile::app
