#include "app/render_part.h"

#include "app/checkpoint.h"
#include "app/output.h"
#include "app/part_files.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace scenefile::app {

namespace {

// Why this file is not the requested part; empty if it is.
std::string part_mismatch(const PartHead& found, const DividedPicture& picture,
                          std::uint32_t index) {
  PartKey wanted = picture.key;
  wanted.driver = found.picture.key.driver;  // only known after drawing with OpenGL
  if (const std::string why = foreign_part(found.picture.key, wanted); !why.empty()) {
    return fmt::format("the part was drawn {}", why);
  }
  if (found.index != index || found.picture.count != picture.count) {
    return fmt::format("it is part {} of {}, not {} of {}", found.index + 1, found.picture.count,
                       index + 1, picture.count);
  }
  return {};
}

}  // namespace

DividedPicture divided_picture(const Options& options, const LoadedScene& scene) {
  const CheckpointKey key = picture_key_of(options, scene);
  const RenderOptions& render = options.render;
  DividedPicture picture;
  picture.key = {key.program, key.scene, key.assets, key.options, 0};
  picture.count = options.part->count;
  picture.region = render.crop.value_or(PixelRegion{0, 0, render.width, render.height});
  picture.rounding = options.engine == Engine::gl ? Rounding::nearest : rounding_of(render.profile);
  picture.max_depth = render.max_depth;
  picture.layers = render.layers;
  return picture;
}

Outcome find_part(const Options& options, const DividedPicture& picture, bool& there) {
  there = false;
  std::error_code ignored;
  if (is_standard_output(options.output) ||
      !std::filesystem::is_regular_file(options.output, ignored)) {
    return {};
  }
  const auto refused = [&](const std::string& why) {
    return Outcome{ExitCode::findings, fmt::format("{}: {}; remove the file or choose another name",
                                                   escaped(options.output, 400), why)};
  };
  const Result<PartCandidate> found = check_part_file(options.output);
  if (!found) {
    return {ExitCode::environment, found.error().text};
  }
  if (!found->has_head) {
    const bool empty = std::filesystem::file_size(options.output, ignored) == 0;
    return empty || kind_of_part(options.output) == PartKind::of_picture ? Outcome()
                                                                         : refused(found->damage);
  }
  if (const std::string why = part_mismatch(found->head, picture, options.part->index);
      !why.empty()) {
    return refused(why);
  }
  there = found->damage.empty();
  return {};
}

Outcome write_part(const Options& options, const DividedPicture& picture,
                   const RenderResult& result, Context& context) {
  context.phase = "writing the part";
  return outcome_of(
      write_part_file(options.output, picture, options.part->index, result.image, result.layers));
}

}  // namespace scenefile::app
