#include "app/scene_files.h"

#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scenefile::app {

namespace {

// Files that cannot be read are reported by the command.
bool is_of_another_program(const std::string& path, const Limits& limits) {
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  return bytes && !may_be_scene(*bytes);
}

void say_left_out(const std::string& folder, const std::vector<std::string>& left_out) {
  say(fmt::format("{}: skipped {} that {} not {}: {}{}\n", escaped(folder, 4096),
                  left_out.size() == 1 ? "one file" : fmt::format("{} files", left_out.size()),
                  left_out.size() == 1 ? "is" : "are", left_out.size() == 1 ? "a scene" : "scenes",
                  escaped(left_out.front(), 4096), left_out.size() == 1 ? "" : ", ..."));
}

void add_folder(const std::string& folder, const Options& options, std::vector<SceneFile>& files) {
  std::vector<Error> errors;
  std::vector<std::string> left_out;
  const std::size_t before = files.size();
  for (std::string& path : files_below(folder, errors)) {
    if (!is_scene_name(path)) {
      continue;
    }
    if (is_of_another_program(path, options.load.limits)) {
      left_out.push_back(std::move(path));
    } else {
      files.push_back({std::move(path), {}});
    }
  }
  for (Error& error : errors) {
    files.push_back({folder, std::move(error)});
  }
  if (files.size() == before) {
    files.push_back({folder, Error{fmt::format("{}: there is no scene in this folder",
                                               escaped(folder, 4096))}});
  }
  if (!left_out.empty() && !options.quiet && !options.json && !options.sarif) {
    say_left_out(folder, left_out);
  }
}

}  // namespace

std::vector<SceneFile> scene_files(const Options& options, Context& context) {
  context.phase = "looking for scenes";
  std::vector<SceneFile> files;
  for (const std::string& argument : options.arguments) {
    if (argument != "-" && is_folder(argument)) {
      add_folder(argument, options, files);
    } else {
      files.push_back({argument, {}});
    }
  }
  return files;
}

}  // namespace scenefile::app
