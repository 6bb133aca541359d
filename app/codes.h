#pragma once
// All codes of all rooms, and those of the program itself.

#include "scenefile/base/diagnostics.h"

#include <span>
#include <string_view>

namespace scenefile::app {

inline constexpr Code render_no_directional_light{
    "render.no-directional-light", Severity::warning, "no light counts in this mode",
    "The course's ray caster (--profile course --mode intersect) knows directional lights alone, "
    "and the scene has none: the picture shows ambient light only. With --profile fine, or with "
    "--mode ray, the other lights count too."};

inline constexpr Code render_transparent_default{
    "render.transparent-default", Severity::warning, "transparentcoeff is missing and was guessed",
    "The scene has transparent materials, but says nothing about transparentcoeff (JSON: "
    "transparentCoeff), which scales them. Programs take 0 or 0.5 for it; --profile fine takes "
    "0.5, --profile course 0. Write it into the global data to be safe."};

/// Sorted by name.
std::span<const Code* const> all_codes();
/// Their names, in the same order.
std::span<const std::string_view> code_names();
/// The code of that name, or null.
const Code* find_code(std::string_view name);

/// "note", "warning" or "error".
std::string_view severity_name(Severity severity);

}  // namespace scenefile::app
