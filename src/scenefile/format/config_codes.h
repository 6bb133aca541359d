#pragma once
// The kinds of finding that reading a configuration of the course's ray tracer reports.

#include "scenefile/base/diagnostics.h"

namespace scenefile {

inline constexpr Code config_syntax{
    "config.syntax", Severity::error, "a line of the configuration cannot be read",
    "A line is a [section], a key = value, or a comment that starts with a semicolon. Values may "
    "stand in double quotes, which end on their line."};
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
    "config.key-case", Severity::warning, "a key of the configuration in other case",
    "Names of sections and keys were read without regard to case. The course's program does so on "
    "Windows only; elsewhere it does not see the key."};
inline constexpr Code config_duplicate_key{"config.duplicate-key", Severity::warning,
                                           "a key of the configuration is given twice",
                                           "The last one counts. Delete the others."};
inline constexpr Code config_missing_key{
    "config.missing-key", Severity::error, "the configuration lacks a key",
    "A configuration says at least what to draw, where to and how large: scene and output in [IO], "
    "width and height in [Canvas]."};
inline constexpr Code config_picture_format{
    "config.picture-format", Severity::warning, "the picture is written as PNG",
    "The ending of output decides: .png, .exr or .pfm. Anything else becomes a PNG, whatever the "
    "name says."};
inline constexpr Code config_value{
    "config.value", Severity::error, "a value of the configuration cannot be used",
    "Features are true or false (1 or 0); sizes are whole numbers of pixels. The course's program "
    "takes every other word for true and every other number for 0."};

}  // namespace scenefile
