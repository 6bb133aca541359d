// What the page rarely needs, in a second module that is loaded on demand: comparing, converting,
// writing.

#include "page.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/compare/sheet.h"
#include "scenefile/edit/edits.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/export/face_materials.h"
#include "scenefile/export/write_gltf.h"
#include "scenefile/export/write_obj.h"
#include "scenefile/export/write_pov.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/import/read_gltf.h"
#include "scenefile/import/read_obj_scene.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace scenefile {

namespace {

struct Maps {
  Texture heat;
  Texture flip;
};

Maps& maps() {
  static Maps instance;
  return instance;
}

// Drops the reader's notes, which do not matter for conversion, before the writer adds its notes.
void drop_notes(Diagnostics& diagnostics) {
  diagnostics.rewrite([](const Code&, Severity severity) {
    return severity == Severity::note ? std::nullopt : std::optional(severity);
  });
}

// Writes the files of the format `to` to /out and adds their names to the answer.
std::vector<std::string> convert(LoadedScene& scene, std::string_view to,
                                 const RenderOptions& options) {
  const auto one = [&](std::string name, const std::string& bytes) {
    write_out(name, bytes);
    return std::vector<std::string>{std::move(name)};
  };
  if (to == "xml" || to == "json") {
    return one(fmt::format("scene.{}", to),
               write_scene(scene.written, to == "xml" ? SceneFormat::xml : SceneFormat::json,
                           Limits{}, scene.diagnostics));
  }
  constexpr float transparent = 0.5f;  // as in the fine profile
  const bool path = lit_by_faces_only(scene);
  if (path) {
    use_face_materials(scene.ready.scene, scene.assets, transparent, to != "pov",
                       scene.diagnostics);
  }
  if (to == "pov") {
    std::vector<std::string> textures;
    for (const FileReference& file : scene.ready.scene.texture_files) {
      textures.push_back(file.name);
    }
    const Features& on = options.features;
    return one("scene.pov", write_pov(scene.ready.scene, scene.assets, textures,
                                      {.bounces = options.max_depth,
                                       .transparent = transparent,
                                       .shadows = on.shadows,
                                       .reflect = on.reflect,
                                       .refract = on.refract,
                                       .texture = on.texture,
                                       .texture_filter = on.texture_filter,
                                       .lens = on.depthoffield,
                                       .path = path},
                                      scene.diagnostics));
  }
  if (to == "glb" || to == "gltf") {
    return one(fmt::format("scene.{}", to),
               write_gltf(scene.written, scene.ready, scene.assets,
                          {.binary = to == "glb", .transparent = transparent, .path = path},
                          scene.diagnostics));
  }
  ObjScene obj = write_obj(scene.ready.scene, scene.assets,
                           {.transparent = transparent, .path = path}, scene.diagnostics);
  write_out("scene.obj", obj.obj);
  write_out("scene.mtl", obj.mtl);
  std::vector<std::string> names{"scene.obj", "scene.mtl"};
  for (std::size_t i = 0; i < obj.pictures.size(); ++i) {
    names.push_back(fmt::format("scene-{}.png", i + 1));
    write_out(names.back(), obj.pictures[i]);
  }
  return names;
}

}  // namespace

extern "C" {

/// Compares a picture with its reference as `scenefile diff --json` does; if the open scene can be
/// drawn, it is used to find the mistakes. `realtime`: the settings of that profile, or null.
const char* page_compare(const std::uint8_t* reference, int width, int height,
                         const std::uint8_t* test, int test_width, int test_height, int profile,
                         int mode, int features, const double* realtime) {
  return answered([&] {
    Page& p = page();
    const Texture a = texture_of(reference, width, height);
    const Texture b = texture_of(test, test_width, test_height);
    CompareSettings settings;
    if (realtime != nullptr) {
      settings.ways = {realtime_way(realtime_options(realtime), {})};
    } else {
      settings.ways =
          possible_ways(std::array{picture_options(profile, mode, features, width, height, 0, -1)},
                        features >= 0);
    }
    const PictureComparison found =
        compare_pictures(a, b, p.scene.usable() ? &p.scene : nullptr, settings);
    maps().heat = heat_map(a, b);
    maps().flip = flip_picture(found.flip_errors, a.width, a.height);
    Json json;
    json.begin_object();
    add_comparison(json, found);
    json.end_object();
    return json.text();
  });
}

/// The maps of the last comparison: 0 largest difference, 1 FLIP. Null if there was none.
const std::uint8_t* page_map(int which) {
  const Texture& map = which == 0 ? maps().heat : maps().flip;
  return map.empty() ? nullptr : show(map);
}

/// Writes the scene in another format to /out: `to` is xml, json, pov, glb, gltf or obj. The answer
/// lists the files, and what the format cannot express.
const char* page_convert(const char* path, const char* to, int profile, int features,
                         int compat_course) {
  return answered([&] {
    LoadedScene scene = load_scene_file(
        path, load_settings(LoadDepth::with_all_assets, compat_course != 0), access_of_page());
    if (!scene.usable()) {
      return error_json("the scene has errors");
    }
    drop_notes(scene.diagnostics);
    const std::vector<std::string> names =
        convert(scene, to, picture_options(profile, 0, features, 1, 1, 0, -1));
    Json json;
    json.begin_object();
    json.begin_array("files");
    for (const std::string& name : names) {
      json.value(name);
    }
    json.end_array();
    json.key("scene");
    add_scene(json, scene);
    json.end_object();
    return json.text();
  });
}

/// Reads a glTF or OBJ file as a scene, and writes it as XML with its meshes and textures to /out.
/// The answer lists the files, the scene first, and what was left out.
const char* page_import(const char* path) {
  return answered([&] {
    const Limits limits;
    const Result<std::string> bytes = read_file(path, limits.file_bytes);
    if (!bytes) {
      return error_json(bytes.error().text);
    }
    LoadedScene scene;
    scene.path = path;
    AssetRoots roots(asset_roots_options(path, access_of_page(), limits));
    const ImportOptions options{
        .stem = "model",
        .fetch = [&](const std::string& name) { return roots.read(name); },
        .limits = limits,
    };
    ImportedScene imported = lower_case(scene.path).ends_with(".obj")
                                 ? read_obj_scene(*bytes, options, scene.diagnostics)
                                 : read_gltf(*bytes, options, scene.diagnostics);
    scene.written = std::move(imported.scene);
    const std::string text =
        scene.diagnostics.has_errors()
            ? std::string()
            : write_scene(scene.written, SceneFormat::xml, limits, scene.diagnostics);
    Json json;
    json.begin_object();
    json.begin_array("files");
    if (!scene.diagnostics.has_errors()) {
      write_out("scene.xml", text);
      json.value(std::string_view("scene.xml"));
      for (const ImportedFile& file : imported.files) {
        write_out(file.name, file.bytes);
        json.value(file.name);
      }
    }
    json.end_array();
    json.key("scene");
    add_scene(json, scene);
    json.end_object();
    return json.text();
  });
}

/// Writes a picture as /out/picture.png.
const char* page_png(const std::uint8_t* rgba, int width, int height) {
  return answered([&] {
    const Result<std::string> bytes = encode_image(to_float(texture_of(rgba, width, height)),
                                                   ImageFormat::png8, Rounding::nearest);
    if (!bytes) {
      return error_json(bytes.error().text);
    }
    write_out("picture.png", *bytes);
    return std::string(R"({"files":["picture.png"]})");
  });
}

/// Writes the formatted file as /out/scene.
const char* page_format(const char* path) {
  return answered([&] {
    const Limits limits;
    const Result<std::string> text = read_file(path, limits.file_bytes);
    if (!text) {
      return error_json(text.error().text);
    }
    Diagnostics diagnostics(limits);
    const std::optional<std::string> laid_out = lay_out(*text, limits, diagnostics);
    if (!laid_out) {
      return error_json(diagnostics.list().empty() ? "the file cannot be formatted"
                                                   : diagnostics.list().front().message);
    }
    write_out("scene", *laid_out);
    return std::string(R"({"files":["scene"]})");
  });
}

/// Writes the file with another camera as /out/scene: position, look, up, and the full vertical
/// angle in degrees.
const char* page_edit_camera(const char* path, const double* values) {
  return answered([&] {
    const Result<std::string> text = read_file(path, Limits{}.file_bytes);
    if (!text) {
      return error_json(text.error().text);
    }
    const LoadedScene scene =
        load_scene_file(path, load_settings(LoadDepth::prepared, /*compat_course=*/false));
    Camera camera = scene.written.camera.value_or(Camera{});
    const auto vector = [&](int i) {
      return glm::vec3(glm::dvec3(values[i], values[i + 1], values[i + 2]));
    };
    camera.position = vector(0);
    camera.look = vector(3);
    camera.up = vector(6);
    camera.height_angle_deg = static_cast<float>(values[9]);
    const Result<Document> document = Document::open(*text, {});
    const Result<Edit> edit = document ? set_camera(*document, camera) : document.error();
    if (!edit) {
      return error_json(edit.error().text);
    }
    write_out("scene", applied(*text, *edit));
    return std::string(R"({"files":["scene"]})");
  });
}
}

}  // namespace scenefile
