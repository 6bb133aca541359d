#pragma once

#include "scenefile/asset/image_file.h"
#include "scenefile/io/used_files.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/render.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

namespace scenefile::python {

/// A rendered picture. Its arrays share its memory.
struct Picture {
  RenderResult result;
  RenderOptions options;     ///< `samples`: in mode path the number that was taken
  Tone tone = Tone::course;  ///< of 8-bit pictures in mode path
  double exposure = 0;
  std::vector<UsedFile> inputs = {};  ///< which the file of the picture must not replace
};

/// The 8-bit picture of a Picture or of an array of rows of colors, or the picture in a file, of
/// which `layer` is read as by decode_picture(). Raises TypeError for anything else, OSError or
/// ValueError if the file cannot be used.
DecodedPicture picture_of(const pybind11::handle& picture, const std::string& layer);

/// Height x width x 3, 8 bits.
pybind11::array_t<std::uint8_t> array_of(const Texture& picture);

/// The bytes of a PNG.
pybind11::bytes png_of(const Texture& picture);

}  // namespace scenefile::python
