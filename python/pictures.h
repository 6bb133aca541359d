#pragma once

#include "scenefile/asset/image.h"
#include "scenefile/trace/render.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace scenefile::python {

/// A rendered picture. Its arrays share its memory.
struct Picture {
  RenderResult result;
  RenderOptions options;
};

/// The 8-bit picture of a Picture, of an array of rows of colors, or of an image file. Raises
/// TypeError for anything else, OSError or ValueError if the file cannot be used.
Texture texture_of(const pybind11::handle& picture);

/// Height x width x 3, 8 bits.
pybind11::array_t<std::uint8_t> array_of(const Texture& picture);

/// The bytes of a PNG.
pybind11::bytes png_of(const Texture& picture);

}  // namespace scenefile::python
