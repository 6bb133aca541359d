#include "scenefile/verbs/load_scene.h"

#include "scenefile/asset/codes.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/placement/check_view.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/codes.h"
#include "scenefile/verbs/codes.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

void enter(const LoadSettings& settings, const char* phase) {
  if (settings.entering) {
    settings.entering(phase);
  }
}

void load_files(LoadedScene& scene, const FetchFile& fetch, const LoadSettings& settings) {
  Hash hash;
  const FetchFile hashed = [&](const std::string& name) {
    Result<std::string> bytes = fetch(name);
    hash.add(name);
    hash.add(bytes ? *bytes : std::string());
    return bytes;
  };
  LoadOptions load;
  load.textures = settings.depth == LoadDepth::with_all_assets;
  load.allow_missing = settings.allow_missing;
  // Without lights it is a scene for the path tracer, which the faces light.
  load.materials = settings.materials || scene.ready.scene.lights.empty();
  load.limits = settings.limits;
  load.for_each = settings.for_each;
  scene.assets = load_assets(scene.ready.scene.texture_files, scene.ready.scene.mesh_files,
                             fetch ? hashed : fetch, load, scene.diagnostics);
  scene.asset_fingerprint = hash.value();
}

// Checks the view of a scene without errors. Sets the source locations in `question`.
void ask(LoadedScene& scene, ViewQuestion question) {
  if (scene.written.camera) {
    question.camera = scene.written.camera->location;
  }
  question.place_of = [&](std::uint32_t source) {
    return place_of(scene.written, scene.ready.sources[source]);
  };
  check_view(scene.ready.scene, scene.assets, question, scene.diagnostics);
}

// Whether the course's ray caster would use none of the scene's lights.
bool dark_in_caster(const RenderOptions& options, const RenderScene& scene) {
  return options.profile == Profile::course && options.mode == Mode::intersect &&
         !scene.lights.empty() &&
         std::none_of(scene.lights.begin(), scene.lights.end(),
                      [](const RenderLight& l) { return is_in_intersect(l.type); });
}

void drop(const Code& dropped, Diagnostics& diagnostics) {
  diagnostics.rewrite([&](const Code& code, Severity severity) {
    return &code == &dropped ? std::nullopt : std::optional(severity);
  });
}

// Whether the picture depends on the default of transparentcoeff.
bool guesses_transparency(const RenderOptions& options) {
  return options.profile == Profile::fine &&
         (options.mode == Mode::path || (options.mode == Mode::ray && options.features.refract));
}

}  // namespace

LoadedScene load_scene(std::string path, std::string text, const FetchFile& fetch,
                       const LoadSettings& settings) {
  const Limits& limits = settings.limits;
  LoadedScene scene;
  scene.diagnostics = Diagnostics(limits);
  scene.path = std::move(path);
  scene.text = std::move(text);
  enter(settings, "reading the scene");
  scene.written = read_scene(
      scene.text, {.compat_course = settings.compat_course, .limits = limits}, scene.diagnostics);
  load_written(scene, fetch, settings);
  return scene;
}

void load_written(LoadedScene& scene, const FetchFile& fetch, const LoadSettings& settings) {
  enter(settings, "checking the scene");
  check(scene.written, settings.limits, scene.diagnostics);
  enter(settings, "preparing the scene");
  scene.ready = prepare(scene.written, settings.limits);
  if (settings.depth != LoadDepth::prepared) {
    enter(settings, "loading textures and meshes");
    load_files(scene, fetch, settings);
    // Faces that could not be read may emit light.
    const std::vector<Diagnostic>& found = scene.diagnostics.list();
    if (has_emissive_faces(scene.assets) ||
        std::any_of(found.begin(), found.end(), [](const Diagnostic& d) {
          return d.severity == Severity::error &&
                 (d.code == &"mesh.missing"_code || d.code == &"mesh.unusable"_code);
        })) {
      drop("scene.no-light"_code, scene.diagnostics);
    }
  }
}

bool lit_by_faces_only(const LoadedScene& scene) {
  return scene.ready.scene.lights.empty() && has_emissive_faces(scene.assets);
}

LoadDepth depth_for(const RenderOptions& options) {
  return options.mode == Mode::path || (options.mode == Mode::ray && options.features.texture)
             ? LoadDepth::with_all_assets
             : LoadDepth::with_meshes;
}

void check_picture(LoadedScene& scene) {
  if (scene.usable()) {
    ViewQuestion question;
    question.paths = lit_by_faces_only(scene);
    ask(scene, question);
  }
}

void check_picture(LoadedScene& scene, const RenderOptions& options) {
  if (!scene.usable()) {
    return;
  }
  ViewQuestion question;
  question.aspect = static_cast<double>(options.width) / options.height;
  question.shadows =
      options.mode == Mode::path || (options.mode == Mode::ray && options.features.shadows);
  question.paths = options.mode == Mode::path;
  ask(scene, question);
  if (lit_by_faces_only(scene) && (options.mode == Mode::ray || options.mode == Mode::intersect)) {
    scene.diagnostics.report(
        "scene.no-light"_code, {},
        "the scene has no light but the faces of meshes that emit light (Ke in their .mtl file), "
        "which only --mode path draws");
  }
  if (dark_in_caster(options, scene.ready.scene)) {
    scene.diagnostics.report(
        "render.no-directional-light"_code, {},
        "the scene has no directional light, and the course's ray caster uses no other");
  }
  if (!guesses_transparency(options)) {
    drop("global.transparent-default"_code, scene.diagnostics);
  }
}

std::string shown_name(const std::string& path) {
  return path == "-" ? "<stdin>" : path;
}

}  // namespace scenefile
