#pragma once
// The fields of RenderOptions with their names: the only list, used for JSON output, the key of
// existing work, and the checks of the program. A field that is missing here is a compile error,
// because a structured binding names every field.

#include "scenefile/trace/render_options.h"

#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace scenefile {

/// The renderer: the ray tracer or OpenGL.
enum class Engine : std::uint8_t { trace, gl };
inline constexpr std::array<std::string_view, 2> engine_words{"trace", "gl"};

/// Where an option has an effect.
struct OptionSupport {
  bool trace = true;   ///< the ray tracer
  bool gl = true;      ///< OpenGL
  bool course = true;  ///< the profile course
  bool path = true;    ///< the mode path
  bool ray = true;     ///< the other modes
};
inline constexpr OptionSupport supported_everywhere{};
inline constexpr OptionSupport tracer_only{.gl = false};
inline constexpr OptionSupport fine_only{.course = false};
inline constexpr OptionSupport fine_tracer_only{.gl = false, .course = false};
inline constexpr OptionSupport fine_rays_only{.gl = false, .course = false, .path = false};
inline constexpr OptionSupport path_only{.gl = false, .course = false, .ray = false};

constexpr bool supports_option(Engine engine, OptionSupport support) {
  switch (engine) {
    case Engine::trace:
      return support.trace;
    case Engine::gl:
      return support.gl;
  }
  return true;
}
constexpr bool supports_option(Profile profile, OptionSupport support) {
  switch (profile) {
    case Profile::course:
      return support.course;
    case Profile::fine:
      return true;
  }
  return true;
}

constexpr bool supports_option(Mode mode, OptionSupport support) {
  return mode == Mode::path ? support.path : support.ray;
}

/// When an option appears in JSON output.
enum class InAnswers : std::uint8_t { always, when_set, never };

struct OptionField {
  std::string_view name;  ///< for features their name; for others also the JSON key
  OptionSupport support = supported_everywhere;
  bool changes_pixels = true;
  InAnswers answers = InAnswers::always;
  int least = 0;  ///< of an int
  int most = std::numeric_limits<int>::max();
};

/// RenderOptions or a member of it, const or not.
template <typename T, typename Struct>
concept OptionsOf = std::same_as<std::remove_const_t<T>, Struct>;

/// Calls visit(const OptionField&, field) for each field, in the order of the JSON output.
template <OptionsOf<RenderOptions> T, typename Visit>
constexpr void visit_options(T& options, Visit&& visit) {
  auto& [profile, mode, features, width, height, samples, min_samples, max_depth, seed, fresnel,
         threads, crop, layers, denoise, light_samples, mis, direct_only, continuation, convention,
         clamp] = options;
  visit(OptionField{.name = "width", .least = 1}, width);
  visit(OptionField{.name = "height", .least = 1}, height);
  visit(OptionField{"profile"}, profile);
  visit(OptionField{"mode"}, mode);
  visit(OptionField{"features", {.path = false}}, features);
  visit(OptionField{.name = "max_depth", .support = tracer_only, .most = 64}, max_depth);
  visit(OptionField{.name = "samples", .support = fine_only, .least = 1, .most = 1 << 16}, samples);
  visit(OptionField{.name = "min_samples", .support = fine_rays_only, .least = 1, .most = 1 << 16},
        min_samples);
  visit(OptionField{"seed", fine_tracer_only}, seed);
  visit(OptionField{"fresnel", fine_rays_only}, fresnel);
  visit(OptionField{.name = "threads",
                    .support = tracer_only,
                    .changes_pixels = false,
                    .answers = InAnswers::never,
                    .most = 1024},
        threads);
  visit(OptionField{"crop", tracer_only, true, InAnswers::when_set}, crop);
  visit(OptionField{"layers", tracer_only, true, InAnswers::when_set}, layers);
  visit(OptionField{"denoise", fine_tracer_only, true, InAnswers::when_set}, denoise);
  visit(OptionField{.name = "light_samples", .support = path_only, .most = 1024}, light_samples);
  visit(OptionField{"mis", path_only}, mis);
  visit(OptionField{"direct_only", path_only}, direct_only);
  visit(OptionField{"continuation", path_only}, continuation);
  visit(OptionField{"convention", path_only}, convention);
  visit(OptionField{"clamp", path_only}, clamp);
}

/// The same for the features, under their names in the course's configuration files.
template <OptionsOf<Features> T, typename Visit>
constexpr void visit_options(T& features, Visit&& visit) {
  auto& [shadows, reflect, refract, texture, texture_filter, super_sample, depthoffield] = features;
  visit(OptionField{"shadows"}, shadows);
  visit(OptionField{"reflect", tracer_only}, reflect);
  visit(OptionField{"refract"}, refract);
  visit(OptionField{"texture"}, texture);
  visit(OptionField{"texture-filter"}, texture_filter);
  visit(OptionField{"super-sample"}, super_sample);
  visit(OptionField{"depthoffield", tracer_only}, depthoffield);
}

template <OptionsOf<PixelRegion> T, typename Visit>
constexpr void visit_options(T& region, Visit&& visit) {
  auto& [x0, y0, x1, y1] = region;
  visit(OptionField{"x0"}, x0);
  visit(OptionField{"y0"}, y0);
  visit(OptionField{"x1"}, x1);
  visit(OptionField{"y1"}, y1);
}

/// The field of RenderOptions with this name; one without restrictions if there is none.
OptionField option_field(std::string_view name);
/// Where that field has an effect.
OptionSupport support_of(std::string_view field);

/// All options that affect pixels, as one line `width=640 height=480 ...`. Equal for two options if
/// and only if they describe the same picture.
std::string picture_key(const RenderOptions& options);

}  // namespace scenefile
