#pragma once
// An unfinished picture as plain data: created, drawn pass by pass, and converted to an image by
// its owner.
//
//   Film film = make_film(scene, options);
//   while (!complete(film) &&
//          render_pass(traced, scene, options, film) == RenderStatus::complete) {
//   }
//   Resolved picture = resolve(std::move(film));
//
// render() is this loop. To draw a picture in bands, crop it: the pixels are the same.

#include "scenefile/asset/image.h"
#include "scenefile/trace/denoise.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/tile_flags.h"
#include "scenefile/trace/trace_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

/// Arrays hold the pixels of `region`, row by row. The course profile takes one pass; so does the
/// fine profile if pixels do not depend on their neighbors (adaptive_sampler.h). Otherwise its
/// first pass takes the first samples of each pixel, and its second pass refines the pixels that
/// need it (refinement_map).
///
/// During a pass, threads write the pixels of unfinished tiles. Another thread may read the pixels
/// of finished ones.
struct Film {
  Profile profile = Profile::fine;
  PixelRegion crop;    ///< the pixels of the result
  PixelRegion own;     ///< pixels to complete: the crop, and what denoising reads around it
  PixelRegion region;  ///< pixels to draw: also the neighbors that decide about samples
  Image image;
  std::vector<ImageLayer> layers;           ///< like RenderOptions::layers
  std::vector<PixelStatistics> statistics;  ///< by pixel; empty: no denoising
  bool sharp = true;                        ///< see denoised()
  TileFlags tiles;                          ///< finished in this pass; tiles of the region
  std::uint32_t pass = 0;                   ///< 0 or 1
  /// By pixel; empty if there is only one pass. After the first pass kept_hash()
  /// (adaptive_sampler.h), behind a lens 1 if the pixel could take more samples; then
  /// AdaptiveSampler::refinement_of(): 0 if the pixel needs no more samples.
  std::vector<std::uint16_t> refinement_map;
};

/// The film of the whole picture before drawing. `canvas`: a black image to draw into, used if it
/// has the size of the region; for callers with cheaper memory than the allocator's (io/memory.h).
Film make_film(const RenderScene& scene, const RenderOptions& options, Image canvas = {});

/// How many pixels around its crop a film also draws, where the picture has them: what denoising
/// and the decision about more samples read.
int margin_of(const RenderScene& scene, const RenderOptions& options);

/// Whether all passes are complete.
bool complete(const Film& film);

/// Draws the next pass, or the rest of it. `traced`, `scene` and `options` must be the same for all
/// passes. Returns `complete` at the end of the pass, or `cancelled` if `progress` said so; calling
/// it again continues. Adds the rays of this call to `stats`.
RenderStatus render_pass(const TraceScene& traced, const RenderScene& scene,
                         const RenderOptions& options, Film& film, const Progress& progress = {},
                         RenderStats* stats = nullptr);

/// The picture, cropped.
struct Resolved {
  Image image;
  std::vector<ImageLayer> layers;
};

/// Extracts the picture; denoised if that was requested and the film is complete.
Resolved resolve(Film film);

/// The pixels of `crop` from an image of `region`, which contains it.
Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop);

/// Copies the pixels of `region` that are finished in this pass to an image of the region. May be
/// called by one thread during a pass.
void copy_done(const Film& film, Image& image);

}  // namespace scenefile
