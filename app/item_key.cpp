#include "app/item_key.h"

#include "app/limit_table.h"
#include "app/output.h"
#include "app/realtime.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/item.h"
#include "scenefile/trace/visit_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

std::uint64_t hash_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

std::string phrase_of(const KeyDifference& difference) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> phrases{
      {{"program", "by another build of the program"},
       {"scene", "from another scene, or the scene was changed"},
       {"files", "with other textures or meshes"},
       {"camera", "with another camera"},
       {"student", "for another student"},
       {"references", "with other references or scenes"},
       {"pictures", "from other pictures"}}};
  const auto phrase = std::find_if(phrases.begin(), phrases.end(),
                                   [&](const auto& row) { return row.first == difference.name; });
  if (phrase != phrases.end()) {
    return std::string(phrase->second);
  }
  const auto option = [&](const std::string& value) {
    return value.empty() ? "its default" : escaped(value, 80);
  };
  return fmt::format("with {} = {}, not {}", escaped(difference.name, 80), option(difference.found),
                     option(difference.wanted));
}

}  // namespace

std::string program_word() {
  const Result<std::string> bytes = read_file("/proc/self/exe", std::uint64_t{1} << 30);
  return fmt::format("program={:x}", hash_of(SCENEFILE_VERSION + (bytes ? *bytes : std::string())));
}

std::string option_words(const Options& options) {
  std::string text = picture_key(options.render);
  text += fmt::format("engine={} compat={} allow_missing={}",
                      engine_words[static_cast<std::size_t>(options.engine)],
                      options.load.compat_course ? "course" : "none", options.load.allow_missing);
  if (const std::optional<RealtimeOptions> panel = realtime_options(options)) {
    // Lists all members, so that adding one is a compile error until it is part of the key.
    const auto& [tessellation, near, far, filter, milestone] = *panel;
    const auto& [parameter1, parameter2] = tessellation;
    text += fmt::format(" milestone={} parameters={},{} near={} far={} filter={}",
                        static_cast<int>(milestone), parameter1, parameter2, near, far,
                        static_cast<int>(filter));
  }
  for (const LimitRow& limit : limit_table()) {
    if (limit.get(options.load.limits) != limit.get({})) {
      text += fmt::format(" limit.{}={}", limit.name, limit.get(options.load.limits));
    }
  }
  return text;
}

std::string picture_key_of(const Options& options, const LoadedScene& scene) {
  return fmt::format("{} scene={:x} files={:x} {}", program_word(), hash_of(scene.text),
                     scene.asset_fingerprint, option_words(options));
}

std::string key_mismatch(std::string_view found, std::string_view wanted) {
  constexpr std::size_t most = 4;
  const std::vector<KeyDifference> differences = compare_keys(found, wanted);
  std::string text;
  for (std::size_t i = 0; i < std::min(differences.size(), most); ++i) {
    text += (i == 0 ? "" : ", and ") + phrase_of(differences[i]);
  }
  return differences.size() > most ? text + ", and more" : text;
}

Outcome foreign_item(const std::string& path, std::string_view why) {
  return {ExitCode::findings, fmt::format("{}: {}; choose another folder, or remove the file",
                                          escaped(path, 400), why)};
}

Outcome make_store(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? Outcome{ExitCode::environment,
                         fmt::format("{}: cannot make the folder of --store: {}",
                                     escaped(folder, 400), error.message())}
               : Outcome();
}

ExitCode answer_missing(std::span<const std::uint32_t> shares) {
  std::string lines;
  for (const std::uint32_t share : shares) {
    lines += fmt::format("{}\n", share);
  }
  return lines.empty() ? ExitCode::fine : worse(ExitCode::findings, answer(lines));
}

}  // namespace scenefile::app
