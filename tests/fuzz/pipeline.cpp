// The whole pipeline: read, check, prepare, load the files, and draw at 4x4.

#include "finding_laws.h"
#include "law.h"
#include "scene_laws.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/render.h"
#include "target.h"

#include <cmath>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;

constexpr std::string_view triangle =
    "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt .5 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";
// An uncompressed TGA of 2x2 pixels.
constexpr std::string_view checker(
    "\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\x18\0\0\0\xff\0\xff\0\xff\0\0\xff\xff\xff", 30);

// Two files exist; all others are missing.
Result<std::string> fetch(const std::string& name) {
  if (name == "a.obj") {
    return std::string(triangle);
  }
  if (name == "a.tga") {
    return std::string(checker);
  }
  return Error{"no such file"};
}

Limits small_limits() {
  Limits limits;
  limits.nesting = 64;
  limits.lights = 6;
  limits.instance_nesting = 200;
  return limits;
}

void draw(const RenderScene& scene, const Assets& assets, Profile profile, Mode mode) {
  RenderOptions options = default_options(profile);
  options.mode = mode;
  options.width = 4;
  options.height = 4;
  options.samples = 4;
  options.max_depth = 4;
  options.threads = 1;
  const RenderResult result = render(scene, assets, options);
  require(result.status == RenderStatus::complete || result.status == RenderStatus::limit_reached,
          "a picture is finished or refused");
  if (result.status != RenderStatus::complete) {
    return;
  }
  require(result.image.width == 4 && result.image.height == 4 && result.image.rgb.size() == 48,
          "a picture is complete");
  for (const float value : result.image.rgb) {
    require(!std::isnan(value), "no pixel is NaN");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Limits limits = small_limits();
  Diagnostics diagnostics(limits);
  const Scene scene = read_scene(text, {.compat_course = true, .limits = limits}, diagnostics);
  if (!diagnostics.has_errors()) {
    check(scene, limits, diagnostics);
  }
  if (diagnostics.has_errors()) {
    return 0;
  }
  const Prepared prepared = prepare(scene, limits);
  fuzz::require_valid(prepared, limits);
  const RenderScene& ready = prepared.scene;
  const Assets assets = load_assets(ready.texture_files, ready.mesh_files, fetch,
                                    {.allow_missing = true, .limits = limits}, diagnostics);
  require(assets.textures.size() == ready.texture_files.size() &&
              assets.meshes.size() == ready.mesh_files.size(),
          "assets are at the indices of the scene");
  fuzz::require_sound(diagnostics, limits, text);
  draw(ready, assets, Profile::course, Mode::ray);
  draw(ready, assets, Profile::fine, Mode::ray);
  draw(ready, assets, Profile::fine, Mode::intersect);
  return 0;
}
