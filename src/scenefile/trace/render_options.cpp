#include "scenefile/trace/render.h"

namespace scenefile {

RenderOptions default_options(Profile profile) {
  RenderOptions options;
  options.profile = profile;
  if (profile == Profile::course) {
    options.features.super_sample = false;
    options.max_depth = 4;
  }
  return options;
}

Rounding rounding_of(Profile profile) {
  return profile == Profile::course ? Rounding::truncate : Rounding::nearest;
}

}  // namespace scenefile
