// Drawing the open scene with WebGL2, in a third module, which is loaded on demand. JavaScript
// makes Emscripten's context current before the first call.

#include "page.h"
#include "scenefile/placement/bounds.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/verbs/scene_json.h"
#include "scenefile/view/draw.h"
#include "scenefile/view/draw_options.h"
#include "scenefile/view/helpers.h"
#include "scenefile/view/webgl.h"

#include <memory>
#include <tuple>

namespace scenefile {

namespace {

struct View {
  std::unique_ptr<GlDevice> device;
  std::optional<Drawing> drawing;
  int opened = 0;            ///< Page::opened of the drawing
  bool flat_meshes = false;  ///< of the drawing
  Diagnostics findings;      ///< of upload()
};

View& view() {
  static View instance;
  return instance;
}

struct ViewOptions {
  RenderOptions picture;
  DrawOptions draw;
};

// `draw_mode`: a DrawMode, or -1 for that of `mode`. `realtime`: parameter 1, parameter 2, near,
// far, filter and milestone, or null.
ViewOptions view_options(int profile, int mode, int features, int draw_mode, int width, int height,
                         const double* realtime) {
  ViewOptions options;
  options.picture = picture_options(profile, mode, features, width, height, 0, -1);
  options.draw = draw_options(options.picture);
  if (draw_mode >= 0) {
    options.draw.mode = static_cast<DrawMode>(draw_mode);
  }
  if (realtime != nullptr) {
    options.draw.realtime = realtime_options(realtime);
  }
  return options;
}

// The drawing of the open scene.
Drawing& drawing_for(const ViewOptions& options) {
  View& v = view();
  const Page& p = page();
  if (!p.scene.usable()) {
    throw std::runtime_error("the scene has errors");
  }
  if (!v.device) {
    Result<std::unique_ptr<GlDevice>> device = GlDevice::create(find_webgl_function);
    if (!device) {
      throw std::runtime_error(device.error().text);
    }
    v.device = *std::move(device);
  }
  const UploadOptions upload_with = upload_options(options.picture);
  if (!v.drawing || v.opened != p.opened || v.flat_meshes != upload_with.flat_meshes) {
    v.drawing.reset();
    v.findings = Diagnostics(Limits{});
    v.drawing = upload(*v.device, p.scene.ready.scene, p.scene.assets, upload_with, v.findings);
    v.opened = p.opened;
    v.flat_meshes = upload_with.flat_meshes;
  }
  return *v.drawing;
}

bool in_range(Location at, Location begin, Location end) {
  const auto key = [](Location l) { return std::tuple(l.line, l.column); };
  return key(begin) <= key(at) && key(at) < key(end);
}

// Which sources to draw so that only the objects in this part of the file, and copies of what it
// contains, are visible; empty if there are none.
std::vector<bool> selected_sources(const Drawing& drawing, Location begin, Location end) {
  const LoadedScene& scene = page().scene;
  const std::vector<Source>& sources = scene.ready.sources;
  std::vector<bool> inside;
  for (const Source& source : sources) {
    inside.push_back(source.kind != SourceKind::light &&
                     in_range(place_of(scene.written, source), begin, end));
  }
  std::vector<bool> visible(sources.size(), false);
  bool any = false;
  const auto parent = [&](std::uint32_t i) { return drawing.placements()[i].parent; };
  for (const DrawnObject& object : drawing.objects()) {
    bool selected = inside[object.source];
    for (std::uint32_t i = object.placement; i != no_index && !selected; i = parent(i)) {
      selected = inside[drawing.placements()[i].source];
    }
    if (!selected) {
      continue;
    }
    any = true;
    visible[object.source] = true;
    for (std::uint32_t i = object.placement; i != no_index; i = parent(i)) {
      visible[drawing.placements()[i].source] = true;
    }
  }
  return any ? visible : std::vector<bool>();
}

// Marks pixels next to the black background of a picture.
void trace_outline(const Image& picture, std::vector<std::uint8_t>& rgba) {
  constexpr int reach = 2;  // pixels
  const auto drawn = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < picture.width && y < picture.height &&
           picture.pixel(x, y)[0] + picture.pixel(x, y)[1] + picture.pixel(x, y)[2] > 0;
  };
  rgba.assign(std::size_t{4} * picture.width * picture.height, 0);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!drawn(x, y) ||
          (drawn(x - 1, y) && drawn(x + 1, y) && drawn(x, y - 1) && drawn(x, y + 1))) {
        continue;
      }
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          const int to_x = x + dx;
          const int to_y = y + dy;
          if (dx * dx + dy * dy <= reach * reach + 1 && to_x >= 0 && to_y >= 0 &&
              to_x < picture.width && to_y < picture.height && !drawn(to_x, to_y)) {
            std::uint8_t* const to = &rgba[4 * (std::size_t(to_y) * picture.width + to_x)];
            to[0] = 255;
            to[1] = 153;
            to[2] = 26;
            to[3] = 255;
          }
        }
      }
    }
  }
}

void add_helper(Json& json, std::string_view kind, Location place,
                const std::vector<WorldLine>& lines) {
  json.begin_object();
  json.add("kind", kind);
  add_location(json, place);
  json.begin_array("lines");
  for (const WorldLine& line : lines) {
    json.begin_array();
    json.value(line.from);
    json.value(line.to);
    json.end_array();
  }
  json.end_array();
  json.end_object();
}

}  // namespace

extern "C" {

/// Draws the open scene into the canvas of the context. The answer: triangles, samples, and in
/// `left_out` what OpenGL does not draw.
const char* page_view_draw(int profile, int mode, int features, int draw_mode, int width,
                           int height, const double* realtime) {
  return answered([&] {
    const ViewOptions options =
        view_options(profile, mode, features, draw_mode, width, height, realtime);
    Drawing& drawing = drawing_for(options);
    const DrawStats stats =
        draw(*view().device, drawing, page().scene.ready.scene.camera, options.draw,
             {.framebuffer = 0, .x = 0, .y = 0, .width = width, .height = height});
    Json json;
    json.begin_object();
    json.add("renderer", view().device->renderer());
    json.add("triangles", stats.triangles);
    json.add("samples", stats.samples);
    json.add("shadowless", stats.shadowless);
    const RealtimeWindow frame =
        options.draw.realtime ? realtime_frame(options.draw.realtime->milestone, width, height)
                              : RealtimeWindow{width, height};
    json.begin_array("viewport");
    json.value(double(width) / frame.width);
    json.value(double(height) / frame.height);
    json.end_array();
    json.begin_array("left_out");
    for (const Diagnostic& finding : view().findings.list()) {
      json.value(finding.message);
    }
    json.end_array();
    json.end_object();
    return json.text();
  });
}

/// The place in the file of the object at a pixel of that picture; no members on the background.
const char* page_view_pick(int profile, int mode, int features, int width, int height,
                           const double* realtime, int x, int y) {
  return answered([&] {
    const ViewOptions options = view_options(profile, mode, features, -1, width, height, realtime);
    Drawing& drawing = drawing_for(options);
    const LoadedScene& scene = page().scene;
    const std::optional<std::uint32_t> found = object_at(
        *view().device, drawing, scene.ready.scene.camera, options.draw, width, height, x, y);
    Json json;
    json.begin_object();
    if (found) {
      const Source& source = scene.ready.sources[drawing.objects()[*found].source];
      json.add("object", node_path(scene.written, source.node));
      add_location(json, place_of(scene.written, source));
    }
    json.end_object();
    return json.text();
  });
}

/// The outline of the objects in a part of the file, RGBA; null if there are none, or if the answer
/// is an error. Lines and columns as in Location; the end is not included.
const std::uint8_t* page_view_outline(int profile, int width, int height, const double* realtime,
                                      int line, int column, int end_line, int end_column) {
  const std::uint8_t* pixels = nullptr;
  answered([&]() -> std::string {
    ViewOptions options = view_options(profile, 0, -1, static_cast<int>(DrawMode::object_id), width,
                                       height, realtime);
    options.draw.samples = 1;
    if (options.draw.realtime) {
      options.draw.realtime->filter = Filter::none;
    }
    Drawing& drawing = drawing_for(options);
    const auto place = [](int l, int c) {
      return Location{static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(c)};
    };
    options.draw.objects =
        selected_sources(drawing, place(line, column), place(end_line, end_column));
    if (options.draw.objects.empty()) {
      return "{}";
    }
    const Result<Image> picture = draw_image(
        *view().device, drawing, page().scene.ready.scene.camera, options.draw, width, height);
    if (!picture) {
      return error_json(picture.error().text);
    }
    trace_outline(*picture, page().pixels);
    pixels = page().pixels.data();
    return "{}";
  });
  return pixels;
}

/// Lines in the world that show the lights and the camera of the file. `aspect`: of the picture.
const char* page_view_helpers(double aspect) {
  return answered([&] {
    const LoadedScene& scene = page().scene;
    const Bounds box = scene_bounds(scene.ready.scene, scene.assets);
    Json json;
    json.begin_object();
    json.begin_array("helpers");
    for (const RenderLight& light : scene.ready.scene.lights) {
      add_helper(json, "light", place_of(scene.written, scene.ready.sources[light.source]),
                 light_helper(light, box));
    }
    add_helper(json, "camera", scene.written.camera ? scene.written.camera->location : Location{},
               camera_helper(page().written_camera, aspect, box));
    json.end_array();
    json.end_object();
    return json.text();
  });
}
}

}  // namespace scenefile
