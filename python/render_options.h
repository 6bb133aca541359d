#pragma once

#include "scenefile/trace/render_options.h"

#include <pybind11/pybind11.h>

#include <string>

namespace scenefile::python {

/// The options of a picture from keyword arguments, with the names of RenderOptions' fields but
/// `size`. Raises TypeError for a name that is none of them, ValueError for a value or an option
/// that the profile does not know.
RenderOptions render_options(const pybind11::dict& given);

/// "shadows,reflect" of that or of a list of words.
std::string joined_words(const pybind11::handle& words);

}  // namespace scenefile::python
