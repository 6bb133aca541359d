#include "app/help.h"

#include "app/codes.h"
#include "app/codes_page.h"
#include "app/json.h"
#include "app/limit_table.h"
#include "app/manual.h"
#include "app/option_table.h"
#include "app/output.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace scenefile::app {

namespace {

constexpr std::size_t text_width = 80;
constexpr std::size_t option_column = 24;

// Breaks text at spaces so that it ends before text_width; all lines but the first are indented.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    if (column > indent && column + 1 + word.size() > text_width) {
      result += '\n';
      result.append(indent, ' ');
      column = indent;
    }
    if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return result;
}

std::string option_text(const OptionRow& row) {
  const std::string head = fmt::format("  {}{}{}{}{}", row.letter, row.letter.empty() ? "" : ", ",
                                       row.name, row.value.empty() ? "" : " ", row.value);
  const bool fits = head.size() + 2 <= option_column;
  return fmt::format("{}{}{:{}}{}\n", head, fits ? "" : "\n", "",
                     fits ? option_column - head.size() : option_column,
                     wrapped(row.help, option_column));
}

std::string indented_lines(std::string_view lines) {
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    result += fmt::format("  {}\n", lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return result;
}

std::string no_such_topic(const std::string& topic) {
  std::vector<std::string_view> known(command_names().begin(), command_names().end());
  known.insert(known.end(), code_names().begin(), code_names().end());
  known.insert(known.end(), code_families().begin(), code_families().end());
  known.push_back("limits");
  return fmt::format("there is no command and no code {}{}", quoted(topic),
                     did_you_mean(topic, known));
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

std::string overview_text() {
  std::string text =
      "scenefile reads, checks and renders scene files of the course CS123 / CSCI1230.\n\n";
  for (const Command& command : commands()) {
    const std::string head = fmt::format("  scenefile {} {}", command.name, command.arguments);
    text += fmt::format("{:<38}{}\n", head, command.summary);
  }
  return text +
         "\n\"scenefile help COMMAND\" explains a command, \"scenefile help CODE\" a finding,\n"
         "\"scenefile help codes\" lists the codes of all findings,\n"
         "\"scenefile help limits\" what a file may cost.\n"
         "- in place of a file is standard input or output.\n\n"
         "Exit status: 0 fine (warnings included), 1 errors in the input, 2 wrong usage,\n"
         "3 something cannot be read or written, 4 a limit was reached, 130 interrupted.\n";
}

std::string command_text(const Command& command) {
  std::string text = fmt::format("scenefile {}{}{} [options]\n\n{}\n\nOptions:\n", command.name,
                                 command.arguments.empty() ? "" : " ", command.arguments,
                                 wrapped(command.description, 0));
  for (const OptionRow& row : option_table()) {
    if ((row.commands & command.bit) != 0) {
      text += option_text(row);
    }
  }
  return text + "\nExamples:\n" + indented_lines(command.examples);
}

std::string code_text(const Code& code) {
  return fmt::format("{}: {} ({}{})\n\n{}\n", code.name, code.summary, severities_text(code),
                     code.kind == CodeKind::dialect ? ": an error with --strict" : "",
                     wrapped(code.help, 0));
}

ExitCode run_help(const Options& options, Context& /*context*/) {
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
  if (const Command* const command = find_command(topic); command != nullptr) {
    if (options.man) {
      return answer(manual_page(*command));
    }
    return answer(options.json ? command_json(*command) : command_text(*command));
  }
  if (const Code* const code = find_code(topic); code != nullptr) {
    return answer(options.json ? code_json(*code) : code_text(*code));
  }
  if (const auto families = code_families();
      std::find(families.begin(), families.end(), topic) != families.end()) {
    return answer(options.json ? help_json() : codes_text(topic));
  }
  if (topic == "codes") {
    return answer(options.json ? help_json() : codes_text());
  }
  if (topic == "limits") {
    return answer(options.json ? help_json() : limits_text());
  }
  say_error(no_such_topic(topic));
  return ExitCode::usage;
}

}  // namespace scenefile::app
