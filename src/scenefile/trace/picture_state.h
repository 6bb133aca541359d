#pragma once
// A picture on its way, in the hands of who wants it: made, drawn pass by pass, stored, put
// together of parts, and resolved to an image.
//
//   PictureState state = make_state(scene, options);
//   while (!complete(state) && render_pass(traced, scene, options, state) ==
//   RenderStatus::complete) {
//   }
//   Resolved picture = resolve(std::move(state));
//
// render() is this loop. A state holds numbers alone: it may be copied, kept in a file
// (encode_state), or drawn as parts on several machines and merged. The picture is the same to the
// byte whatever way was taken.

#include "scenefile/asset/image.h"
#include "scenefile/trace/denoise.h"
#include "scenefile/trace/pieces.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/trace_scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Arrays hold the pixels of `region`, row by row. The course profile takes one pass; so does the
/// fine profile where pixels do not depend on their neighbors (fine_samples.h). Else its first pass
/// takes a sample of each pixel, the second those of the pixels that are marked.
///
/// During a pass threads write pixels of pieces that are not done. Another thread may read the
/// pixels of pieces that are.
struct PictureState {
  Profile profile = Profile::fine;
  PixelRegion crop;    ///< the pixels of the result
  PixelRegion own;     ///< those drawn to the end: of the crop, and what taking noise away reads
  PixelRegion region;  ///< those drawn at all: neighbors tell which pixels need more samples
  Image image;
  std::vector<ImageLayer> layers;           ///< as RenderOptions::layers
  std::vector<PixelStatistics> statistics;  ///< by pixel; empty: there is no noise to take away
  bool sharp = true;                        ///< see denoised()
  Pieces pieces;                            ///< done in this pass; tiles of the region
  std::uint32_t pass = 0;                   ///< 0 or 1
  /// By pixel; empty: one pass is all. In the first pass kept_signature() (fine_samples.h), in the
  /// second FineSampler::mark_of(): 0 where nothing more is needed.
  std::vector<std::uint16_t> marked;
  std::size_t merged = 0;  ///< pixels that merge() put in
};

/// The whole picture, with nothing drawn. `canvas`: a black image to draw in, if it has the size of
/// the region; for those who know cheaper memory than the allocator does (io/memory.h).
PictureState make_state(const RenderScene& scene, const RenderOptions& options, Image canvas = {});

/// Part `index` of `count` of the same picture, counted from 0: whole tiles, about as many in each
/// part; none where there are more parts than tiles.
PictureState make_part(const RenderScene& scene, const RenderOptions& options, std::uint32_t index,
                       std::uint32_t count);

/// Whether all passes are done.
bool complete(const PictureState& state);

/// Draws the next pass, or what is left of it. `traced`, `scene` and `options` must be the same for
/// all passes. Returns `complete` when the pass is done, `cancelled` where `progress` said so;
/// calling again goes on. Adds the rays of this call to `stats`.
RenderStatus render_pass(const TraceScene& traced, const RenderScene& scene,
                         const RenderOptions& options, PictureState& state,
                         const Progress& progress = {}, RenderStats* stats = nullptr);

/// A picture of the crop.
struct Resolved {
  Image image;
  std::vector<ImageLayer> layers;
};

/// What was drawn, without noise where that was asked for and the state is complete.
Resolved resolve(PictureState state);

/// Puts a complete part of the same picture, of the same options and not merged before, into the
/// whole, which is complete once it has all parts. False, with nothing changed: the part is not
/// complete, or of another kind of picture.
bool merge(PictureState& whole, const PictureState& part);

/// All that decode_state() needs, in a form of this build. May be called during a pass, by one
/// thread: holds the pieces that are done by then.
std::string encode_state(const PictureState& state);
/// Goes on from such bytes: `state` is as make_state() or make_part() gives it for the same
/// picture. False: the bytes are of no picture of this size and kind; nothing has changed.
bool decode_state(std::string_view bytes, PictureState& state);

/// The pixels of `crop` of an image of `region`, which holds it.
Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop);

/// Copies the pixels of `region` that are done in this pass to an image of the region. May be
/// called during a pass, by one thread.
void copy_done(const PictureState& state, Image& image);

}  // namespace scenefile
