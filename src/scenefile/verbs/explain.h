#pragma once
// Explains the color of a pixel; as data, text and JSON.

#include "scenefile/base/result.h"
#include "scenefile/explain/remarks.h"
#include "scenefile/explain/yours.h"
#include "scenefile/verbs/load_scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct ExplainReport {
  PixelRecord pixel;
  std::vector<Remark> remarks;
  std::optional<Yours> yours;  ///< another program's value of the pixel, if given
};

/// Traces the pixel (x, y), row 0 at the top, like render() with these options. `sample` selects
/// the sample to describe in full; by default the one nearest to the pixel's center. The scene must
/// be usable. Fails if render() does, and with ErrorKind::usage if there is no such sample.
Result<ExplainReport> explain_pixel(const LoadedScene& scene, const RenderOptions& options, int x,
                                    int y, std::optional<std::uint32_t> sample = {});

struct ExplainStyle {
  bool color = false;     ///< ANSI colors
  bool swatches = false;  ///< 24-bit colors: a patch of each color next to its numbers
};

/// A tree of the contributions to the pixel.
std::string explain_text(const LoadedScene& scene, const ExplainReport& report,
                         const ExplainStyle& style = {});

/// The document described in docs/explain.md. If `report` is null, `error` says why.
std::string explain_json(const LoadedScene& scene, const RenderOptions& options,
                         const ExplainReport* report, const std::string& error = {});

/// Names of faces, indexed by Face.
inline constexpr std::array<std::string_view, 9> face_words{"side", "top", "bottom", "+x", "-x",
                                                            "+y",   "-y",  "+z",     "-z"};

}  // namespace scenefile
