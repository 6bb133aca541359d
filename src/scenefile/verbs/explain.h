#pragma once
// Why a pixel has its color: as data, for people and for programs.

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
  std::optional<Yours> yours;  ///< another program's value of the pixel, where it was given
};

/// Traces the pixel (x, y), row 0 on top, as render() does with these options. `sample`: which one
/// is to be shown in full, else the one nearest to the pixel's middle. The scene must be usable.
/// Fails where render() does, and with ErrorKind::usage where there is no such sample.
Result<ExplainReport> explain_pixel(const LoadedScene& scene, const RenderOptions& options, int x,
                                    int y, std::optional<std::uint32_t> sample = {});

struct ExplainStyle {
  bool color = false;     ///< ANSI colors
  bool swatches = false;  ///< 24-bit colors: a patch of each color beside its numbers
};

/// A tree of what the pixel is made of.
std::string explain_text(const LoadedScene& scene, const ExplainReport& report,
                         const ExplainStyle& style = {});

/// docs/explain.md describes the document. `report` is null where there is nothing to explain;
/// `error` says why then.
std::string explain_json(const LoadedScene& scene, const RenderOptions& options,
                         const ExplainReport* report, const std::string& error = {});

/// The words for faces of shapes, in the order of the enumerators of Face.
inline constexpr std::array<std::string_view, 9> face_words{"side", "top", "bottom", "+x", "-x",
                                                            "+y",   "-y",  "+z",     "-z"};

}  // namespace scenefile
