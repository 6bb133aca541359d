#include "app/load_picture.h"

#include "app/output.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"

#include <fmt/format.h>

namespace scenefile::app {

LoadedPicture load_picture(const std::string& path, Context& context) {
  context.phase = "reading a picture";
  const Limits limits;
  LoadedPicture loaded;
  loaded.path = path;
  std::string bytes;
  if (const IoError error = read_file(path, limits.file_bytes, bytes); !error.empty()) {
    loaded.error = error.text;
    loaded.status = error.over_limit ? ExitCode::limit : ExitCode::environment;
    return loaded;
  }
  std::uint64_t budget = limits.texture_bytes;
  std::string error;
  bool over_limit = false;
  loaded.picture = decode_image(bytes, limits, budget, error, &over_limit);
  if (!error.empty()) {
    loaded.error = fmt::format("{}: cannot decode: {}", escaped(shown_name(path), 4096), error);
    loaded.status = over_limit ? ExitCode::limit : ExitCode::findings;
  }
  return loaded;
}

bool is_picture_file(const std::string& path) {
  std::string bytes;
  return path != "-" && !path.starts_with("/dev/") && !path.starts_with("/proc/") &&
         read_file(path, Limits{}.file_bytes, bytes).empty() && is_image(bytes);
}

std::string png_of(const Texture& picture, std::string& error) {
  return encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest, error);
}

ExitCode save_picture(const std::string& path, const Texture& picture, Context& context) {
  context.phase = "writing a picture";
  std::string error;
  const std::string bytes = png_of(picture, error);
  error = error.empty() ? write_file(path, bytes).text
                        : fmt::format("{}: cannot encode: {}", escaped(path, 4096), error);
  if (!error.empty()) {
    say_error(error);
  }
  return error.empty() ? ExitCode::fine : ExitCode::environment;
}

}  // namespace scenefile::app
