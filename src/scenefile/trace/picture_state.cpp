#include "scenefile/trace/picture_state.h"

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/pieces.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace scenefile {

namespace {

struct Head {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t pass = 0;
  std::uint32_t marks = 0;       // whether there are marks
  std::uint32_t channels = 0;    // total over all layers
  std::uint32_t statistics = 0;  // whether there are statistics
  std::uint32_t profile = 0;

  friend bool operator==(const Head&, const Head&) = default;
};
static_assert(std::is_trivially_copyable_v<PixelStatistics>);

bool has_two_passes(const RenderScene& scene, const RenderOptions& options) {
  return options.profile == Profile::fine &&
         sample_plan(options, softness(scene, options)).two_passes;
}

// Whether the picture will be denoised.
bool will_denoise(const RenderScene& scene, const RenderOptions& options) {
  return options.denoise && options.profile == Profile::fine &&
         softness(scene, options) != Softness::none;
}

PixelRegion overlap(const PixelRegion& a, const PixelRegion& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRegion grown(const PixelRegion& region, int by) {
  return {region.x0 - by, region.y0 - by, region.x1 + by, region.y1 + by};
}

std::size_t pixels_of(const PixelRegion& region) {
  return std::size_t(region.width()) * region.height();
}

// Sets everything that follows from the crop and the own pixels.
void allocate(const RenderScene& scene, const RenderOptions& options, const PixelRegion& most,
              Image canvas, PictureState& state) {
  const bool two_passes = has_two_passes(scene, options);
  state.profile = options.profile;
  state.region =
      empty(state.own) ? PixelRegion{} : overlap(grown(state.own, two_passes ? 1 : 0), most);
  const int width = state.region.width();
  const int height = state.region.height();
  state.image =
      canvas.width == width && canvas.height == height ? std::move(canvas) : Image(width, height);
  state.layers = make_layers(options, state.region);
  state.statistics.resize(will_denoise(scene, options) ? pixels_of(state.region) : 0);
  state.sharp = softness(scene, options) < Softness::lens;
  state.pieces = Pieces(width, height);
  state.marked.resize(two_passes ? pixels_of(state.region) : 0);
}

PixelRegion whole_picture(const RenderOptions& options) {
  return {0, 0, options.width, options.height};
}

std::size_t index_in(const PixelRegion& region, int x, int y) {
  return std::size_t(y - region.y0) * region.width() + (x - region.x0);
}

Head head_of(const PictureState& state) {
  Head head{std::uint32_t(state.region.width()),
            std::uint32_t(state.region.height()),
            state.pass,
            !state.marked.empty(),
            0,
            !state.statistics.empty(),
            static_cast<std::uint32_t>(state.profile)};
  for (const ImageLayer& layer : state.layers) {
    head.channels += static_cast<std::uint32_t>(layer.channels.size());
  }
  return head;
}

// Calls row(from, to, bytes) for the rows of the pixels of `own` in two arrays.
template <typename Row>
void for_each_row(const PixelRegion& own, const Row& row) {
  for (int y = own.y0; y < own.y1; ++y) {
    row(own.x0, y, static_cast<std::size_t>(own.width()));
  }
}

template <typename T>
void copy_rows(const std::vector<T>& from, const PixelRegion& from_region, std::size_t per_pixel,
               const PixelRegion& own, const PixelRegion& to_region, std::vector<T>& to) {
  for_each_row(own, [&](int x, int y, std::size_t pixels) {
    std::copy_n(from.data() + per_pixel * index_in(from_region, x, y), per_pixel * pixels,
                to.data() + per_pixel * index_in(to_region, x, y));
  });
}

// Calls part(bytes of the pixels, bytes per pixel) for each array of the picture.
template <typename State, typename Part>
void for_each_array(State& state, const Part& part) {
  part(state.image.rgb.data(), 3 * sizeof(float));
  for (auto& layer : state.layers) {
    part(layer.values.data(), layer.channels.size() * sizeof(float));
  }
  if (!state.statistics.empty()) {
    part(state.statistics.data(), sizeof(PixelStatistics));
  }
}

std::size_t bytes_of_pixel(const PictureState& state) {
  std::size_t sum = 0;
  for_each_array(state, [&](const auto* /*pixels*/, std::size_t bytes) { sum += bytes; });
  return sum;
}

std::size_t byte_count(const PictureState& state) {
  return sizeof(Head) + state.pieces.count() + sizeof(std::uint16_t) * state.marked.size() +
         bytes_of_pixel(state) * pixels_of(state.region);
}

}  // namespace

Image cut(const Image& image, const PixelRegion& region, const PixelRegion& crop) {
  Image part(crop.width(), crop.height());
  copy_rows(image.rgb, region, 3, crop, crop, part.rgb);
  return part;
}

PictureState make_state(const RenderScene& scene, const RenderOptions& given, Image canvas) {
  const RenderOptions options = in_range(given);
  PictureState state;
  state.crop = options.crop.value_or(whole_picture(options));
  state.own =
      overlap(grown(state.crop, options.denoise ? denoise_reach : 0), whole_picture(options));
  allocate(scene, options, whole_picture(options), std::move(canvas), state);
  return state;
}

PictureState make_part(const RenderScene& scene, const RenderOptions& given, std::uint32_t index,
                       std::uint32_t count) {
  const RenderOptions options = in_range(given);
  PictureState whole;
  whole.crop = options.crop.value_or(whole_picture(options));
  whole.own =
      overlap(grown(whole.crop, options.denoise ? denoise_reach : 0), whole_picture(options));
  PictureState part;
  part.own = part.crop = part_of(whole.own, index, count);
  allocate(scene, options, whole_picture(options), {}, part);
  return part;
}

bool complete(const PictureState& state) {
  return (state.marked.empty() || state.pass == 1) && state.pieces.all_done();
}

Resolved resolve(PictureState state) {
  if (!state.statistics.empty() && complete(state)) {
    const std::vector<glm::vec3> colors =
        denoised(state.region.width(), state.region.height(), state.statistics, state.sharp);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      std::copy_n(&colors[i].x, 3, &state.image.rgb[3 * i]);
    }
  }
  Resolved result;
  if (state.crop == state.region) {
    result.image = std::move(state.image);
    result.layers = std::move(state.layers);
    return result;
  }
  result.image = cut(state.image, state.region, state.crop);
  for (const ImageLayer& layer : state.layers) {
    const std::size_t channels = layer.channels.size();
    ImageLayer& part =
        result.layers.emplace_back(ImageLayer{layer.name, layer.channels, layer.whole, {}});
    part.values.resize(channels * pixels_of(state.crop));
    copy_rows(layer.values, state.region, channels, state.crop, state.crop, part.values);
  }
  return result;
}

bool merge(PictureState& whole, const PictureState& part) {
  const PixelRegion& own = part.own;
  if (empty(own)) {
    return complete(part);
  }
  Head kind = head_of(part);
  const Head wanted = head_of(whole);
  kind.width = wanted.width;
  kind.height = wanted.height;
  kind.pass = wanted.pass;
  if (!complete(part) || !(kind == wanted) || !(overlap(own, whole.own) == own)) {
    return false;
  }
  copy_rows(part.image.rgb, part.region, 3, own, whole.region, whole.image.rgb);
  for (std::size_t i = 0; i < whole.layers.size(); ++i) {
    copy_rows(part.layers[i].values, part.region, part.layers[i].channels.size(), own, whole.region,
              whole.layers[i].values);
  }
  if (!whole.statistics.empty()) {
    copy_rows(part.statistics, part.region, 1, own, whole.region, whole.statistics);
  }
  whole.merged += pixels_of(own);
  if (whole.merged == pixels_of(whole.own)) {
    whole.pass = whole.marked.empty() ? 0 : 1;
    for (std::size_t piece = 0; piece < whole.pieces.count(); ++piece) {
      whole.pieces.finish(piece);
    }
  }
  return true;
}

std::string encode_state(const PictureState& state) {
  const Head head = head_of(state);
  std::string result(byte_count(state), '\0');
  char* to = result.data();
  std::memcpy(to, &head, sizeof head);
  to += sizeof head;
  // Reads each flag once: a piece finished in the meantime counts as unfinished.
  std::vector<bool> done(state.pieces.count());
  for (std::size_t i = 0; i < done.size(); ++i) {
    done[i] = state.pieces.done(i);
    *to++ = char(done[i]);
  }
  const int width = std::max(1, state.region.width());
  const std::size_t pixels = pixels_of(state.region);
  const auto whole = [&](std::size_t i) {
    return done[state.pieces.at(int(i % width), int(i / width))];
  };
  for (std::size_t i = 0; i < state.marked.size(); ++i) {
    const std::uint16_t mark = whole(i) || state.pass == 1 ? state.marked[i] : std::uint16_t{0};
    std::memcpy(to, &mark, sizeof mark);
    to += sizeof mark;
  }
  // Everything that no thread is writing: finished pieces, and what the second pass does not
  // change.
  for_each_array(state, [&](const auto* from, std::size_t bytes) {
    const char* const first = reinterpret_cast<const char*>(from);
    for (std::size_t i = 0; i < pixels; ++i) {
      if (whole(i) || (state.pass == 1 && state.marked[i] == 0)) {
        std::memcpy(to + bytes * i, first + bytes * i, bytes);
      }
    }
    to += bytes * pixels;
  });
  return result;
}

bool decode_state(std::string_view bytes, PictureState& state) {
  Head head;
  if (bytes.size() != byte_count(state)) {
    return false;
  }
  std::memcpy(&head, bytes.data(), sizeof head);
  Head wanted = head_of(state);
  wanted.pass = head.pass;
  if (!(head == wanted) || head.pass > wanted.marks) {
    return false;
  }
  bytes.remove_prefix(sizeof head);
  state.pass = head.pass;
  state.pieces.restart();
  for (std::size_t i = 0; i < state.pieces.count(); ++i) {
    if (bytes[i] != 0) {
      state.pieces.finish(i);
    }
  }
  bytes.remove_prefix(state.pieces.count());
  const std::size_t of_marks = sizeof(std::uint16_t) * state.marked.size();
  if (of_marks != 0) {
    std::memcpy(state.marked.data(), bytes.data(), of_marks);
  }
  bytes.remove_prefix(of_marks);
  for_each_array(state, [&](auto* to, std::size_t of_pixel) {
    const std::size_t size = of_pixel * pixels_of(state.region);
    std::memcpy(static_cast<void*>(to), bytes.data(), size);
    bytes.remove_prefix(size);
  });
  return true;
}

void copy_done(const PictureState& state, Image& image) {
  for (int y = 0; y < state.region.height(); ++y) {
    for (int x = 0; x < state.region.width(); ++x) {
      if (state.pieces.done(state.pieces.at(x, y))) {
        std::copy_n(state.image.pixel(x, y), 3, image.pixel(x, y));
      }
    }
  }
}

}  // namespace scenefile
