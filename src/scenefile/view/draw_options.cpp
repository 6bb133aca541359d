#include "scenefile/view/draw_options.h"

namespace scenefile {

namespace {

DrawMode draw_mode(Mode mode) {
  switch (mode) {
    case Mode::ray:
    case Mode::intersect:
    case Mode::path:
      return DrawMode::shaded;
    case Mode::normals:
      return DrawMode::normals;
  }
  return DrawMode::shaded;
}

// 0: chosen by the size of the objects.
int default_samples(const RenderOptions& options) {
  switch (options.profile) {
    case Profile::course:
      return options.features.super_sample ? 16 : 1;
    case Profile::fine:
      return 0;
  }
  return 0;
}

}  // namespace

DrawOptions draw_options(const RenderOptions& options) {
  const bool ray = options.mode == Mode::ray;
  DrawOptions result;
  result.mode = draw_mode(options.mode);
  result.course = options.profile == Profile::course;
  result.shadows = ray && options.features.shadows;
  result.textures = ray && options.features.texture;
  result.texture_filter = options.features.texture_filter;
  result.transparency = ray && options.features.refract;
  result.directional_only = result.course && options.mode == Mode::intersect;
  result.samples = default_samples(options);
  return result;
}

UploadOptions upload_options(const RenderOptions& options) {
  UploadOptions result;
  result.flat_meshes = options.profile == Profile::course;
  return result;
}

}  // namespace scenefile
