#pragma once
// Explains the color of a pixel; as data, text and JSON.

#include "scenefile/base/result.h"
#include "scenefile/explain/remarks.h"
#include "scenefile/explain/yours.h"
#include "scenefile/mistakes/realtime_pixel.h"
#include "scenefile/path/explain_path.h"
#include "scenefile/verbs/compare_paths.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/load_scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A pixel of the assignment Realtime.
struct RealtimeRecord {
  RealtimeOptions panel;
  RealtimePixel pixel;
  std::vector<PixelRecord> shares;  ///< the frame's pixels, in the order of pixel.shares
};

/// A term of the lighting equation, in 1/255.
struct TermWith {
  std::string name;  ///< "ambient", "point light (line 5), diffuse"
  glm::dvec3 ours{0};
  glm::dvec3 mistaken{0};  ///< with the mistakes that were found
};

/// What comparing the whole pictures found, and what it says about the pixel.
struct YoursCompared {
  PictureComparison found;
  bool explained = false;       ///< found.causes.asked is the other program's value
  std::vector<TermWith> terms;  ///< without those that are 0; empty if they are not known
};

struct ExplainReport {
  /// For Realtime, the samples are pixels of the frame.
  PixelRecord pixel;
  std::optional<RealtimeRecord> realtime;
  std::optional<PathPixel> path;           ///< of mode path; then `pixel` is not used
  std::optional<PathNeighborhood> around;  ///< mode path: another program's picture, if given
  std::vector<Remark> remarks;
  std::optional<Yours> yours;             ///< another program's value of the pixel, if given
  std::optional<YoursCompared> compared;  ///< of its whole picture, if compared
};

/// Traces the pixel (x, y), row 0 at the top, like render() with these options, or in mode path
/// like render_path(). `sample` selects the sample to describe in full; by default the one nearest
/// to the pixel's center. The scene must be usable. Fails if render() does, and with
/// ErrorKind::usage if there is no such sample.
Result<ExplainReport> explain_pixel(const LoadedScene& scene, const RenderOptions& options, int x,
                                    int y, std::optional<std::uint32_t> sample = {});

/// The same for a picture of the assignment Realtime. `sample` selects a pixel of the frame; by
/// default the one with the largest weight. Fails with ErrorKind::limit if the scene has more than
/// max_explained_shapes shapes.
Result<ExplainReport> explain_realtime_pixel(const LoadedScene& scene, const RealtimeOptions& panel,
                                             const glm::ivec2& size, const glm::ivec2& pixel,
                                             std::optional<std::uint32_t> sample = {});

/// The error if the pixel has fewer samples.
std::optional<Error> no_such_sample(std::optional<std::uint32_t> sample, std::size_t taken);

/// Sets report.yours: the value of the pixel in another program's picture.
void add_yours(const LoadedScene& scene, const std::array<std::uint8_t, 3>& value,
               ExplainReport& report);

/// Whether the pictures differ and the comparison says nothing about why, so that one pixel may
/// suggest more.
bool shows_nothing(const PictureComparison& found);

/// Sets report.yours, and report.compared to the result of comparing the whole pictures, in which
/// the pixel was asked for (CompareSettings::asked). What the whole pictures show goes before what
/// one pixel suggests: if they have a cause, or differ only in sampling, yours.fits is empty.
void add_compared(const LoadedScene& scene, const std::array<std::uint8_t, 3>& value,
                  PictureComparison found, ExplainReport& report);

struct ExplainStyle {
  bool color = false;     ///< ANSI colors
  bool swatches = false;  ///< 24-bit colors: a patch of each color next to its numbers
};

/// A tree of the contributions to the pixel.
std::string explain_text(const LoadedScene& scene, const ExplainReport& report,
                         const ExplainStyle& style = {});

/// The document described in docs/explain.md. If `report` is null, `error` says why. For a picture
/// of the assignment Realtime, only the size of `options` is used.
std::string explain_json(const LoadedScene& scene, const RenderOptions& options,
                         const ExplainReport* report, const std::string& error = {},
                         const std::optional<RealtimeOptions>& realtime = {});

/// Names of faces, indexed by Face.
inline constexpr std::array<std::string_view, 9> face_words{"side", "top", "bottom", "+x", "-x",
                                                            "+y",   "-y",  "+z",     "-z"};

}  // namespace scenefile
