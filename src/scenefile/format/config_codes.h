#pragma once
// Findings about configuration files of the course's ray tracer.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code config_syntax{
    "config.syntax", Severity::error, "a line of the configuration cannot be read",
    "A line is a [section], a key = value, or a comment that starts with a semicolon. Values may "
    "be in double quotes, which must end on the same line."};
inline constexpr Code config_backslash{
    "config.backslash", Severity::error, "a backslash that is no escape",
    "The course's reader (QSettings) takes a backslash for the start of an escape and loses what "
    "follows. Write / between folders, \\\\ for a backslash, \\\" for a quote, \\x with the number "
    "in hexadecimal for any other character."};
inline constexpr Code config_unknown_key{
    "config.unknown-key", Severity::warning, "a key of the configuration that is not known",
    "Known are scene and output in [IO], width and height in [Canvas], maximum-recursive-depth and "
    "only-render-normals in [Settings], and in [Feature] shadows, reflect, refract, texture, "
    "texture-filter, super-sample, depthoffield; parallel and acceleration too, on which no pixel "
    "depends. Others have no effect."};
inline constexpr Code config_key_case{
    "config.key-case", Severity::warning, "a key of the configuration in another case",
    "Names of sections and keys were matched ignoring case. The course's program does so only on "
    "Windows; elsewhere it does not find the key."};
inline constexpr Code config_duplicate_key{"config.duplicate-key", Severity::warning,
                                           "a key of the configuration is given twice",
                                           "The last one counts. Delete the others."};
inline constexpr Code config_missing_key{
    "config.missing-key", Severity::error, "the configuration lacks a key",
    "A configuration says at least what to draw, where to and how large: scene and output in [IO], "
    "width and height in [Canvas]."};
inline constexpr Code config_picture_format{
    "config.picture-format", Severity::warning, "the picture is written as PNG",
    "The extension of output decides: .png, .exr or .pfm. Any other extension gives a PNG."};
inline constexpr Code config_value{
    "config.value", Severity::error, "a value of the configuration cannot be used",
    "Features are true or false (1 or 0); sizes are whole numbers of pixels. The course's program "
    "reads every other word as true and every other number as 0."};

}  // namespace scenefile
