// The command merge: combines the parts of a picture or of a class.

#include "app/merge.h"

#include "app/command.h"
#include "app/json.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/part_files.h"
#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/parallel.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

// The parts on the command line, after reading their headers.
struct Parts {
  std::vector<std::string> paths;
  bool of_class = false;                  // not of a picture
  std::vector<PartCandidate> candidates;  // by path; empty for a class
  std::vector<GradePart> graded;          // by path; empty for a picture; without their results
  std::vector<PartTag> tags;              // by path
  SortedParts set;
};

// The files given by the arguments; a folder stands for the parts in it.
std::vector<std::string> part_paths(const Options& options) {
  std::vector<std::string> paths;
  for (const std::string& argument : options.arguments) {
    if (!is_folder(argument)) {
      paths.push_back(argument);
      continue;
    }
    for (const std::string& name : files_in(argument, 2 * std::size_t{max_parts})) {
      const std::string path = argument + (argument.ends_with('/') ? "" : "/") + name;
      if (!name.starts_with('.') && kind_of_part(path) != PartKind::none) {
        paths.push_back(path);
      }
    }
  }
  return paths;
}

// Reads all parts with `read`. The error is about the first part that cannot be read.
template <typename Part, typename Read>
Outcome read_parts(const std::vector<std::string>& paths, const Read& read,
                   std::vector<Part>& parts) {
  parts.resize(paths.size());
  std::vector<std::string> errors(paths.size());
  for_each_index(paths.size(), 0, [&](std::size_t i) {
    Result<Part> part = read(paths[i]);
    if (part) {
      parts[i] = *std::move(part);
    } else {
      errors[i] = part.error().text;
    }
  });
  const auto unreadable = std::find_if(errors.begin(), errors.end(),
                                       [](const std::string& error) { return !error.empty(); });
  return unreadable == errors.end() ? Outcome() : Outcome{ExitCode::environment, *unreadable};
}

Outcome check_parts(const Options& options, Parts& parts, Context& context) {
  context.phase = "reading the parts";
  parts.paths = part_paths(options);
  for (const std::string& path : parts.paths) {
    if (const Result<void> added = context.files.read(named_file("part", path)); !added) {
      return outcome_of(added);
    }
  }
  std::array<std::size_t, 3> kinds{};
  for (const std::string& path : parts.paths) {
    ++kinds[static_cast<std::size_t>(kind_of_part(path))];
  }
  parts.of_class = kinds[static_cast<std::size_t>(PartKind::of_class)] >
                   kinds[static_cast<std::size_t>(PartKind::of_picture)];
  Outcome outcome;
  if (parts.of_class) {
    const auto read = [](const std::string& path) {
      Result<GradePart> part = read_grade_part(path);
      if (part) {
        part->book = {};
      }
      return part;
    };
    outcome = read_parts(parts.paths, read, parts.graded);
    for (const GradePart& part : parts.graded) {
      parts.tags.push_back(tag_of(part));
    }
  } else {
    outcome = read_parts(parts.paths, check_part_file, parts.candidates);
    for (const PartCandidate& part : parts.candidates) {
      parts.tags.push_back(tag_of(part));
    }
  }
  if (outcome.error.empty()) {
    parts.set = sort_parts(parts.tags);
  }
  return outcome;
}

std::string numbered(const Parts& parts, std::size_t file) {
  const PartTag& part = parts.tags[file];
  const std::string number = part.whole.empty()
                                 ? std::string()
                                 : fmt::format(" (part {} of {})", part.index + 1, part.count);
  return escaped(parts.paths[file], 400) + number;
}

std::string foreign_text(const Parts& parts, std::size_t file) {
  const std::size_t usual = parts.set.usual;
  const std::string why = parts.of_class
                              ? std::string(foreign_grade_part(parts.graded[file].head.whole.key,
                                                               parts.graded[usual].head.whole.key))
                              : foreign_part(parts.candidates[file].head.picture.key,
                                             parts.candidates[usual].head.picture.key);
  const std::string_view whole = parts.of_class ? "class" : "picture";
  return why.empty()
             ? fmt::format(
                   "{}: belongs to {}", numbered(parts, file),
                   parts.tags[file].count != parts.tags[usual].count
                       ? fmt::format("the same {}, divided into another number of parts", whole)
                       : fmt::format("another {}", whole))
             : fmt::format("{}: {} {}", numbered(parts, file), parts.of_class ? "graded" : "drawn",
                           why);
}

// Why the parts cannot be merged, one reason per line.
std::vector<std::string> problems(const Parts& parts) {
  const SortedParts& set = parts.set;
  std::vector<std::string> lines;
  if (parts.paths.empty()) {
    lines.emplace_back("no parts found");
  }
  for (const std::size_t file : set.foreign) {
    lines.push_back(foreign_text(parts, file));
  }
  for (const std::size_t file : set.damaged) {
    lines.push_back(fmt::format("{}: {}", numbered(parts, file), parts.tags[file].damage));
  }
  for (const std::size_t file : set.doubled) {
    const std::size_t first = set.files[parts.tags[file].index];
    lines.push_back(fmt::format("{}: the same part as {}", numbered(parts, file),
                                escaped(parts.paths[first], 400)));
  }
  if (!set.missing.empty()) {
    lines.push_back(fmt::format("missing: {} of {}: {}", set.missing.size(), set.files.size(),
                                part_numbers(set.missing)));
  }
  return lines;
}

ExitCode print_missing(const Parts& parts) {
  std::string lines;
  for (const std::uint32_t index : parts.set.missing) {
    lines += fmt::format("{}\n", index + 1);
  }
  return worse(answer(lines), parts.set.missing.empty() ? ExitCode::fine : ExitCode::findings);
}

std::string merge_json(const Options& options, const Parts& parts, const std::string& error) {
  Json json;
  begin_document(json, "merge");
  const SortedParts& set = parts.set;
  json.add("parts", set.files.size());
  json.begin_array("missing");
  for (const std::uint32_t index : set.missing) {
    json.value(index + 1);
  }
  json.end_array();
  const auto add_files = [&](std::string_view name, const std::vector<std::size_t>& files,
                             const auto& why) {
    json.begin_array(name);
    for (const std::size_t file : files) {
      json.begin_object();
      json.add("file", parts.paths[file]);
      if (!parts.tags[file].whole.empty()) {
        json.add("number", parts.tags[file].index + 1);
      }
      if (const std::string reason = why(file); !reason.empty()) {
        json.add("error", reason);
      }
      json.end_object();
    }
    json.end_array();
  };
  add_files("doubled", set.doubled, [](std::size_t) { return std::string(); });
  add_files("damaged", set.damaged, [&](std::size_t file) { return parts.tags[file].damage; });
  add_files("foreign", set.foreign, [&](std::size_t file) { return foreign_text(parts, file); });
  if (!options.missing) {
    const PixelRegion region = parts.of_class || set.usual == no_file
                                   ? PixelRegion{}
                                   : parts.candidates[set.usual].head.picture.region;
    json.add("output", options.output);
    json.add("width", region.width());
    json.add("height", region.height());
    json.add("written", error.empty());
  }
  if (!error.empty()) {
    json.add("error", error);
  }
  json.end_object();
  return json.text();
}

// Checks whether the options fit parts of this kind.
Outcome check_kind(const Options& options, const Parts& parts) {
  if (parts.of_class) {
    return options.output.empty()
               ? Outcome()
               : Outcome{ExitCode::usage,
                         "these are parts of a class: write --report, --csv, --junit, --pages or "
                         "--gradescope instead of -o"};
  }
  for (const std::string_view name :
       {"--report", "--title", "--csv", "--csv-students", "--junit", "--pages", "--gradescope"}) {
    if (was_given(options, name)) {
      return {ExitCode::usage,
              fmt::format("{} is for parts of a class, which grade --part writes", name)};
    }
  }
  return options.output.empty() ? Outcome{ExitCode::usage, "merge needs an output: -o OUT.png"}
                                : Outcome();
}

}  // namespace

ExitCode run_merge(const Options& options, Context& context) {
  Parts parts;
  Outcome outcome = check_parts(options, parts, context);
  std::vector<std::string> wrong;
  if (outcome.status == ExitCode::fine) {
    wrong = problems(parts);
  }
  if (outcome.status == ExitCode::fine && options.missing && !parts.set.files.empty()) {
    if (options.json) {
      return worse(parts.set.missing.empty() ? ExitCode::fine : ExitCode::findings,
                   answer(merge_json(options, parts, {})));
    }
    return print_missing(parts);
  }
  if (outcome.status == ExitCode::fine && !parts.set.files.empty()) {
    outcome = check_kind(options, parts);
  }
  if (outcome.status == ExitCode::fine && !wrong.empty()) {
    outcome = {ExitCode::findings, wrong.back()};
    wrong.pop_back();
  }
  if (outcome.status == ExitCode::fine && parts.of_class) {
    return merge_class(options, parts.set, parts.paths, context);
  }
  if (outcome.status == ExitCode::fine) {
    outcome = merge_picture(options, parts.candidates, parts.paths, context);
  }
  if (options.json) {
    return worse(outcome.status, answer(merge_json(options, parts, outcome.error)));
  }
  if (outcome.status == ExitCode::findings) {
    for (const std::string& line : wrong) {
      say_error(line);
    }
  }
  if (!outcome.error.empty()) {
    say_error(outcome.error);
  }
  return outcome.status;
}

}  // namespace scenefile::app
