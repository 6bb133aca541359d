#include "app/completion.h"

#include "app/command.h"
#include "app/help.h"
#include "app/option_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace scenefile::app {

namespace {

// Single quotes work in all shells.
std::string shell_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

// The first sentence of a help text.
std::string_view brief(std::string_view help) {
  const std::size_t point = help.find(". ");
  help = help.substr(0, point == std::string_view::npos ? help.size() : point);
  return help.ends_with('.') ? help.substr(0, help.size() - 1) : help;
}

// The words with blanks between them.
template <typename Words>
std::string in_line(const Words& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

bool is_list(const OptionRow& row) {
  return row.value == "LIST";
}

bool is_folder_name(const OptionRow& row) {
  return row.value == "DIR" || row.value == "OUTDIR";
}

std::string bash_case(const Command& command) {
  std::string names, values;
  for (const OptionRow* row : options_of(command)) {
    names += fmt::format("{}{}", names.empty() ? "" : " ", row->name);
    if (row->value.empty()) {
      continue;
    }
    const std::string pattern =
        row->letter.empty() ? std::string(row->name) : fmt::format("{}|{}", row->name, row->letter);
    if (!words_of(*row).empty()) {
      values += fmt::format("        {}) {} {}; return ;;\n", pattern,
                            is_list(*row) ? "_scenefile_list" : "_scenefile_words",
                            shell_quoted(in_line(words_of(*row))));
    } else if (is_folder_name(*row)) {
      values += fmt::format(
          "        {}) compopt -o filenames; COMPREPLY=($(compgen -d -- \"$cur\")); return ;;\n",
          pattern);
    } else {
      values += fmt::format("        {}) return ;;\n", pattern);
    }
  }
  return fmt::format("    {})\n      case $prev in\n{}      esac\n      options={}\n      ;;\n",
                     command.name, values, shell_quoted(names));
}

std::string bash() {
  std::string cases;
  for (const Command& command : commands()) {
    cases += bash_case(command);
  }
  return fmt::format(
      R"(# Completion of scenefile for bash. Made by: scenefile help --completion bash
_scenefile_words() {{
  COMPREPLY=($(compgen -W "$1" -- "$cur"))
}}

# Words separated by commas: completes the last one.
_scenefile_list() {{
  local before=
  [[ $cur == *,* ]] && before=${{cur%,*}},
  COMPREPLY=($(compgen -P "$before" -W "$1" -- "${{cur##*,}}"))
  compopt -o nospace
}}

_scenefile() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} options=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    _scenefile_words {}
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $cur == -* ]]; then
    _scenefile_words "$options"
  elif [ "${{COMP_WORDS[1]}}" = help ]; then
    _scenefile_words {}
  fi
}}
complete -o bashdefault -o default -F _scenefile scenefile
)",
      shell_quoted(fmt::format("{} --help --version", fmt::join(command_names(), " "))), cases,
      shell_quoted(in_line(help_topics())));
}

// Brackets, colons and backslashes are special in specifications for _arguments.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  return result;
}

std::string zsh_value(const OptionRow& row) {
  if (row.value.empty()) {
    return "";
  }
  const std::string name = zsh_text(row.value);
  if (!words_of(row).empty()) {
    return is_list(row) ? fmt::format(":{}:_values -s , {} {}", name, row.value,
                                      fmt::join(words_of(row), " "))
                        : fmt::format(":{}:({})", name, fmt::join(words_of(row), " "));
  }
  return fmt::format(":{}:{}", name, is_folder_name(row) ? "_files -/" : "_files");
}

std::string zsh() {
  std::string list, cases;
  for (const Command& command : commands()) {
    list += fmt::format(
        "    {}\n", shell_quoted(fmt::format("{}:{}", command.name, zsh_text(command.summary))));
    cases += fmt::format("    {})\n      _arguments", command.name);
    for (const OptionRow* row : options_of(command)) {
      for (const std::string_view name : {row->name, row->letter}) {
        if (!name.empty()) {
          cases += fmt::format(" \\\n        {}",
                               shell_quoted(fmt::format(
                                   "{}[{}]{}", name, zsh_text(brief(row->help)), zsh_value(*row))));
        }
      }
    }
    cases +=
        command.name == "help"
            ? fmt::format(" \\\n        {}\n      ;;\n",
                          shell_quoted(fmt::format("1:topic:({})", fmt::join(help_topics(), " "))))
            : " \\\n        '*:file:_files'\n      ;;\n";
  }
  return fmt::format(
      R"(#compdef scenefile
# Completion of scenefile for zsh. Made by: scenefile help --completion zsh
_scenefile() {{
  local -a subcommands
  subcommands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command subcommands
    return
  fi
  local name=$words[2]
  shift words
  (( CURRENT-- ))
  case $name in
{}  esac
}}
if [ "$funcstack[1]" = _scenefile ]; then
  _scenefile "$@"
else
  compdef _scenefile scenefile
fi
)",
      list, cases);
}

std::string fish() {
  std::string text =
      "# Completion of scenefile for fish. Made by: scenefile help --completion fish\n";
  for (const Command& command : commands()) {
    text += fmt::format("complete -c scenefile -n __fish_use_subcommand -f -a {} -d {}\n",
                        command.name, shell_quoted(command.summary));
    const std::string here =
        fmt::format("complete -c scenefile -n '__fish_seen_subcommand_from {}'", command.name);
    for (const OptionRow* row : options_of(command)) {
      text += fmt::format("{} -l {}", here, row->name.substr(2));
      if (!row->letter.empty()) {
        text += fmt::format(" -s {}", row->letter.substr(1));
      }
      if (!words_of(*row).empty()) {
        const std::string words = in_line(words_of(*row));
        text += is_list(*row)
                    ? fmt::format(" -x -a {}",
                                  shell_quoted("(__fish_complete_list , 'string split \" \" \"" +
                                               words + "\"')"))
                    : fmt::format(" -x -a {}", shell_quoted(words));
      } else if (is_folder_name(*row)) {
        text += " -x -a '(__fish_complete_directories)'";
      } else if (!row->value.empty()) {
        text += " -r";
      }
      text += fmt::format(" -d {}\n", shell_quoted(brief(row->help)));
    }
  }
  return text +
         fmt::format("complete -c scenefile -n '__fish_seen_subcommand_from help' -f -a {}\n",
                     shell_quoted(in_line(help_topics())));
}

}  // namespace

std::string completion_script(Shell shell) {
  switch (shell) {
    case Shell::bash:
      return bash();
    case Shell::zsh:
      return zsh();
    case Shell::fish:
      return fish();
  }
  return {};
}

}  // namespace scenefile::app
