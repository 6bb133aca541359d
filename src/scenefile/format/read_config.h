#pragma once
// Configuration files of the course's ray tracer: the .ini file that is its only argument.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The contents of a configuration. Features that it does not mention are off.
struct CourseConfig {
  std::string scene;   ///< [IO] path, as written: relative to the working directory
  std::string output;  ///< [IO] path of the picture
  Location scene_place;
  Location output_place;
  int width = 0;   ///< [Canvas] pixels, 1 to limits.image_side
  int height = 0;  ///< [Canvas]
  bool shadows = false;
  bool reflect = false;
  bool refract = false;
  bool texture = false;
  bool texture_filter = false;
  bool super_sample = false;
  bool depthoffield = false;
  bool parallel = false;                       ///< does not affect the picture
  bool acceleration = false;                   ///< does not affect the picture
  std::optional<int> maximum_recursive_depth;  ///< [Settings] number of bounces, 0 to 64
  bool only_render_normals = false;            ///< [Settings]

  friend bool operator==(const CourseConfig&, const CourseConfig&) = default;
};

/// Reads a configuration in the dialect of QSettings (sections, key = value, semicolon comments,
/// quotes, backslash escapes). Sections and keys in the wrong case are accepted with a warning;
/// true is `true` or `1`; false is `false`, `0` or empty. Codes: format/codes.h. If errors are
/// reported, do not use the result.
CourseConfig read_config(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
