#pragma once

#include "scenefile/trace/render_options.h"

#include <pybind11/pybind11.h>

#include <string>

namespace scenefile::python {

/// The options of a picture from keyword arguments named like the fields of RenderOptions, plus
/// `size`. Raises TypeError for an unknown name, ValueError for an invalid value or an option that
/// the profile does not support.
RenderOptions render_options(const pybind11::dict& given);

/// "shadows,reflect" from that text, or from a list of words.
std::string joined_words(const pybind11::handle& words);

}  // namespace scenefile::python
