// The C functions that the page calls. Each worker has one instance, which keeps the scene that it
// opened last. Files are in memory; the scene and the files that it names are below /files.
//  Functions that answer in JSON or text return its first byte, and page_answer_size() its length;
// the answer is valid until the next call. Pictures are RGBA with row 0 at the top, and equally
// valid until the next call.

#include "page.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/scene/summary.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

namespace scenefile {

Page& page() {
  static Page instance;
  return instance;
}

namespace {

void add_camera(Json& json, const RenderCamera& camera) {
  json.begin_object("camera");
  json.add("position", camera.position);
  json.add("u", camera.u);
  json.add("v", camera.v);
  json.add("w", camera.w);
  json.add("fov_y", camera.fov_y);
  json.end_object();
}

void add_files(Json& json, const LoadedScene& scene) {
  json.begin_array("files");
  for (const AssetFile& file : locate_files(scene, access_of_page(), Limits{})) {
    json.begin_object();
    json.add("name", file.reference.name);
    json.add("kind", word_of(file.kind));
    json.add("found", !file.resolved.path.empty());
    add_location(json, file.from.empty() ? file.reference.location : Location());
    json.end_object();
  }
  json.end_array();
}

void add_counts(Json& json, const LoadedScene& scene) {
  const SceneSummary counts = summarize(scene.written);
  json.begin_object("counts");
  std::size_t primitives = 0;
  for (const std::size_t n : counts.primitives) {
    primitives += n;
  }
  std::size_t lights = 0;
  for (const std::size_t n : counts.lights) {
    lights += n;
  }
  json.add("primitives", primitives);
  json.add("drawn", counts.virtual_primitives);
  json.add("lights", lights);
  json.end_object();
}

std::string opened_json(const LoadedScene& scene) {
  Json json;
  json.begin_object();
  json.key("scene");
  add_scene(json, scene);
  json.add("usable", scene.usable());
  json.add("lit_by_faces", scene.usable() && lit_by_faces_only(scene));
  if (!scene.unreadable) {
    add_files(json, scene);
  }
  if (scene.usable()) {
    add_camera(json, scene.ready.scene.camera);
    add_counts(json, scene);
  }
  json.end_object();
  return json.text();
}

}  // namespace

extern "C" {

const char* page_answer() {
  return page().answer.c_str();
}

std::size_t page_answer_size() {
  return page().answer.size();
}

/// The findings about a scene, and which files it names. `depth`: 0 without opening these files, 1
/// with all of them. Does not change the open scene.
const char* page_check(const char* path, int depth, int compat_course) {
  return answered([&] {
    LoadedScene scene =
        load_scene_file(path,
                        load_settings(depth == 0 ? LoadDepth::prepared : LoadDepth::with_all_assets,
                                      compat_course != 0),
                        access_of_page());
    if (depth != 0 && scene.usable()) {
      check_picture(scene);
    }
    return opened_json(scene);
  });
}

/// Opens a scene with all its files for the functions below; answers like page_check().
/// `materials`: also those of mesh faces where the scene has lights, for mode path.
const char* page_open(const char* path, int compat_course, int materials) {
  ++page().opened;
  page().paths.reset();
  page().traced.reset();
  LoadedScene none;
  page().scene = std::move(none);  // frees its memory before the next scene is loaded
  return answered([&] {
    LoadedScene& scene = page().scene;
    scene = load_scene_file(
        path, load_settings(LoadDepth::with_all_assets, compat_course != 0, materials != 0),
        access_of_page());
    page().written_camera = scene.ready.scene.camera;
    if (scene.usable()) {
      check_picture(scene);
    }
    return opened_json(scene);
  });
}

/// Changes the camera of the open scene: position, u, v, w, and the full angle fov_y in radians, as
/// in RenderCamera. Null: the camera of the file.
void page_look(const double* camera) {
  page().paths.reset();
  RenderCamera& now = page().scene.ready.scene.camera;
  now = page().written_camera;
  if (camera != nullptr) {
    const auto vector = [&](int i) { return glm::dvec3(camera[i], camera[i + 1], camera[i + 2]); };
    now.position = vector(0);
    now.u = vector(3);
    now.v = vector(6);
    now.w = vector(9);
    now.fov_y = camera[12];
  }
}

/// Decodes a picture file. The answer contains the size; null if the answer is an error.
const std::uint8_t* page_decode(const char* path) {
  const std::uint8_t* pixels = nullptr;
  answered([&] {
    const Result<DecodedPicture> loaded = load_picture_file(path);
    if (!loaded) {
      return error_json(loaded.error().text);
    }
    const Texture& picture = loaded->texture;
    pixels = show(picture);
    return fmt::format("{{\"width\":{},\"height\":{}}}", picture.width, picture.height);
  });
  return pixels;
}

/// The help text of a diagnostic code.
const char* page_help(const char* code) {
  return answered([&] {
    const Code* const found = find_code(code);
    if (found == nullptr) {
      return error_json("unknown code");
    }
    Json json;
    json.begin_object();
    json.add("summary", found->summary);
    json.add("help", found->help);
    json.end_object();
    return json.text();
  });
}
}

}  // namespace scenefile
