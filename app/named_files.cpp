#include "app/named_files.h"

#include "app/option_table.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

constexpr std::array<std::string_view, 3> words_for_inputs{"FILE", "PICTURE", "SCENE"};
constexpr std::array<std::string_view, 3> words_for_outputs{"OUT", "OUTDIR", "PATTERN"};

bool contains(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// What messages call a file, by the name of its option or the word for the argument.
std::string role_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 12> others{
      {{"--heatmap", "heat map"},
       {"--energy", "plot of light"},
       {"--csv", "CSV table"},
       {"--csv-students", "CSV table of students"},
       {"--junit", "JUnit file"},
       {"--gradescope", "Gradescope file"},
       {"--path", "camera path"},
       {"--mine", "picture"},
       {"A", "picture A"},
       {"B", "picture B"},
       {"DIR", "archive of the class"},  // if it is a file
       {"IN", "input"}}};
  const auto other = std::find_if(others.begin(), others.end(),
                                  [&](const auto& row) { return row.first == name; });
  return other != others.end() ? std::string(other->second)
                               : lower_case(name.substr(name.starts_with("--") ? 2 : 0));
}

// The word of the usage for each argument: "SCENE", "REFERENCE" for "[SCENE [REFERENCE]]"; the last
// one stands for all others.
std::vector<std::string> argument_words(const Command& command) {
  std::istringstream usage{std::string(command.arguments)};
  std::vector<std::string> words;
  for (std::string word; usage >> word && !word.starts_with('-');) {
    std::erase_if(word, [](char c) { return c == '[' || c == ']' || c == '.'; });
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace

UsedFile named_file(std::string_view role, const std::string& path) {
  return {path, fmt::format("the {} {}", role, escaped(path))};
}

Result<void> add_named_files(const Command& command, const Options& options, UsedFiles& files) {
  const std::vector<std::string> words = argument_words(command);
  bool stdin_is_read = false;
  const auto claim_input = [&](std::string_view name, const std::string& path) -> Result<void> {
    if (path != "-") {
      return files.read(named_file(role_of(name), path));
    }
    if (std::exchange(stdin_is_read, true)) {
      return Error{"standard input can be read only once", ErrorKind::usage};
    }
    return files.read({path, "the file on standard input"});
  };
  Result<void> added;
  for (std::size_t i = 0; i < options.arguments.size() && !words.empty() && added; ++i) {
    const std::string& word = words[std::min(i, words.size() - 1)];
    const std::string& path = options.arguments[i];
    added = word == "OUT" ? files.write(named_file("output", path)) : claim_input(word, path);
  }
  std::string on_stdout = options.json ? "the answer of --json" : "";
  const auto claim_stdout = [&](const UsedFile& file) {
    if (!is_standard_output(file.path)) {
      return files.write(file);
    }
    const std::string other = std::exchange(on_stdout, file.what);
    return other.empty() ? Result<void>()
                         : Result<void>(Error{fmt::format("{} and {} cannot both be on standard "
                                                          "output",
                                                          file.what, other),
                                              ErrorKind::usage});
  };
  for (const auto& [row, value] : options.given) {
    if (added && row->value == "OUT") {
      added = claim_stdout(named_file(role_of(row->name), value));
    } else if (added && contains(words_for_inputs, row->value)) {
      added = claim_input(row->name, value);
    }
  }
  return added;
}

bool names_file(const OptionRow& row) {
  return contains(words_for_inputs, row.value) || contains(words_for_outputs, row.value) ||
         row.value == "DIR";
}

bool writes_files(const Options& options) {
  return !options.output.empty() || options.to ||
         std::any_of(options.given.begin(), options.given.end(), [](const GivenOption& given) {
           return contains(words_for_outputs, given.row->value);
         });
}

Outcome check_named_outputs(const Options& options) {
  for (const auto& [row, value] : options.given) {
    if (row->value == "OUT") {
      if (Outcome outcome = outcome_of(check_writable(value)); outcome.status != ExitCode::fine) {
        return outcome;
      }
    }
  }
  return {};
}

void make_output_folder(const Options& options) {
  std::error_code ignored;
  const std::string& scene = options.arguments.front();
  if (!is_standard_output(options.output) && std::filesystem::exists(scene, ignored)) {
    std::filesystem::create_directories(folder_of(options.output), ignored);
  }
}

Outcome claim_inputs(std::span<const UsedFile> inputs, Context& context) {
  Result<void> added;
  for (const UsedFile& input : inputs) {
    added = added ? context.files.read(input) : added;
  }
  return outcome_of(added);
}

Outcome claim_outputs(std::span<const UsedFile> outputs, Context& context) {
  for (const UsedFile& output : outputs) {
    Outcome outcome = outcome_of(context.files.write(output));
    if (outcome.status == ExitCode::fine && !output.path.empty()) {
      outcome = outcome_of(check_writable(output.path));
    }
    if (outcome.status != ExitCode::fine) {
      return outcome;
    }
  }
  return {};
}

}  // namespace scenefile::app
