#pragma once
// Configuration files of the course's ray tracer and path tracer: the .ini file that is the only
// argument of each.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The program that a configuration is for: that of the assignments with rays (Intersect,
/// Illuminate), or that of the advanced course's assignment Path.
enum class ConfigKind : std::uint8_t { ray, path };

/// The contents of a configuration.
struct CourseConfig {
  ConfigKind kind = ConfigKind::ray;
  std::string scene;   ///< [IO] path, as written: relative to the working directory
  std::string output;  ///< [IO] path of the picture
  Location scene_place;
  Location output_place;
  int width = 0;   ///< pixels, 1 to limits.image_side; [Canvas], or [Settings] imageWidth
  int height = 0;  ///< [Canvas], or [Settings] imageHeight

  // Rays.
  std::vector<std::string_view> features;  ///< [Feature] keys that are true and affect the picture
  std::optional<int> maximum_recursive_depth;  ///< [Settings] number of bounces, 0 to 64
  bool only_render_normals = false;            ///< [Settings]

  // Paths, [Settings]. Counts that are 0 or not given are 1.
  int samples_per_pixel = 1;            ///< 1 to 65,536
  int num_direct_lighting_samples = 1;  ///< points on lamps for each surface point, 1 to 1,024
  float path_continuation_prob = 0;     ///< of each bounce, 0 to 1; 0: none
  bool direct_lighting_only = false;

  /// Of paths; 0: no maximum. Paths that never go on see direct light.
  int most_bounces() const { return path_continuation_prob == 0 ? 1 : 0; }

  friend bool operator==(const CourseConfig&, const CourseConfig&) = default;
};

/// Reads a configuration in the dialect of QSettings (sections, key = value, semicolon comments,
/// quotes, backslash escapes). Sections and keys in the wrong case are accepted with a warning;
/// true is `true` or `1`; false is `false`, `0` or empty. The kind is the one that more keys belong
/// to, or `program` if no key tells; keys of the other kind have no effect, with a warning. Codes:
/// format/codes.h. If errors are reported, do not use the result.
CourseConfig read_config(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                         std::optional<ConfigKind> program = std::nullopt);

}  // namespace scenefile
