#include "app/checkpoint.h"

#include "app/limit_table.h"
#include "app/output.h"
#include "app/realtime.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/trace/visit_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>

namespace scenefile::app {

namespace {

std::uint64_t fingerprint(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

// An upper bound for the state of such a picture.
std::uint64_t max_bytes(const Options& options) {
  return std::uint64_t(options.render.width) * std::uint64_t(options.render.height) * 16 +
         (1u << 20);
}

Outcome refusal(const Options& options, const std::string& why) {
  return {ExitCode::findings, fmt::format("{}: {}; remove the file to start from the beginning",
                                          escaped(options.checkpoint), why)};
}

Outcome resume(const Options& options, const CheckpointKey& key, std::string& state) {
  std::error_code ignored;
  if (!std::filesystem::exists(options.checkpoint, ignored) && !ignored) {
    return {};
  }
  const Result<std::string> bytes = read_file(options.checkpoint, max_bytes(options));
  if (!bytes && bytes.error().kind == ErrorKind::limit) {
    return refusal(options, "the file is longer than a checkpoint of this picture");
  }
  if (!bytes) {
    return {ExitCode::environment, bytes.error().text};
  }
  const std::string why = decode_checkpoint(*bytes, key, state);
  return why.empty() ? Outcome() : refusal(options, why);
}

}  // namespace

// Fingerprint of the program file, because the version number does not change during development.
std::uint64_t program_fingerprint() {
  const Result<std::string> bytes = read_file("/proc/self/exe", std::uint64_t{1} << 30);
  return fingerprint(SCENEFILE_VERSION + (bytes ? *bytes : std::string()));
}

// Everything on the command line that affects pixels.
std::uint64_t options_fingerprint(const Options& options) {
  std::string text = fmt::format("{}compat={} missing={}", picture_key(options.render),
                                 options.load.compat_course, options.load.allow_missing);
  text += fmt::format(" engine={}", engine_words[static_cast<std::size_t>(options.engine)]);
  if (const std::optional<RealtimeOptions> panel = realtime_options(options)) {
    // Lists all members, so that adding one is a compile error until it is part of the key.
    const auto& [tessellation, near, far, filter, milestone] = *panel;
    const auto& [parameter1, parameter2] = tessellation;
    text += fmt::format(" realtime={},{},{},{:a},{:a},{}", static_cast<int>(milestone), parameter1,
                        parameter2, near, far, static_cast<int>(filter));
  }
  for (const LimitRow& limit : limit_table()) {
    text += fmt::format(" {}={}", limit.name, limit.get(options.load.limits));
  }
  return fingerprint(text);
}

CheckpointKey picture_key_of(const Options& options, const LoadedScene& scene) {
  return {program_fingerprint(), fingerprint(scene.text), scene.asset_fingerprint,
          options_fingerprint(options)};
}

Outcome open_checkpoint(const Options& options, const LoadedScene& scene,
                        Checkpoints& checkpoints) {
  const CheckpointKey key = picture_key_of(options, scene);
  Outcome error = resume(options, key, checkpoints.resume);
  checkpoints.save = [path = options.checkpoint, key,
                      said = std::make_shared<bool>(false)](const std::string& state) {
    const Result<void> written = write_file(path, encode_checkpoint(key, state));
    if (!written && !*said) {
      *said = true;
      say_error(fmt::format("warning: no checkpoint: {}", written.error().text));
    }
  };
  return error;
}

void remove_checkpoint(const Options& options) {
  std::error_code ignored;
  std::filesystem::remove(options.checkpoint, ignored);
}

}  // namespace scenefile::app
