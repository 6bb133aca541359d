#include "scenefile/import/picture_file.h"

#include "scenefile/asset/image_file.h"

#include <fmt/format.h>

namespace scenefile {

std::string add_picture(const Texture& texture, const ImportOptions& options,
                        std::vector<ImportedFile>& files) {
  const std::string name = fmt::format("{}-{}.png", options.stem, files.size() + 1);
  files.push_back({name, *encode_image(to_float(texture), ImageFormat::png8, Rounding::nearest)});
  return name;
}

}  // namespace scenefile
