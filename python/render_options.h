#pragma once

#include "scenefile/trace/render_options.h"

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

namespace scenefile::python {

/// The options of a picture from keyword arguments named like the fields of RenderOptions, plus
/// `size`. Without `mode`, scenes that are lit by faces only are drawn in mode path, if it has
/// all given options. Raises TypeError for an unknown name, ValueError for an invalid value, or
/// for an option or layer that the profile or mode does not support.
RenderOptions render_options(const pybind11::dict& given, bool lit_by_faces_only = false);

/// Whether the arguments have mode="path".
bool asks_for_paths(const pybind11::dict& given);

/// A number from `least` to `most`; raises ValueError for others and NaN.
double real_number(std::string_view name, const pybind11::handle& value, double least, double most);

/// "shadows,reflect" from that text, or from a list of words.
std::string joined_words(const pybind11::handle& words);

}  // namespace scenefile::python
