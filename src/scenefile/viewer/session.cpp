#include "scenefile/viewer/session.h"

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/view/draw_options.h"
#include "scenefile/viewer/hidden.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scenefile::viewer {

namespace {

constexpr double rest = 0.25;  // the camera must rest this long before ray tracing starts
constexpr double notice_seconds = 4;

void start_trace(Session& session) {
  TraceRequest request;
  request.scene =
      without_hidden(session.shown->opened.ready.scene, session.hidden, session.only_light);
  request.scene.camera = render_camera(session.camera);
  request.keep = session.shown;
  request.assets = &session.shown->opened.assets;
  request.hidden = session.hidden;
  request.options = trace_options(session);
  request.noise = session.setup.path_noise;
  request.wake = session.setup.wake;
  session.trace.start(std::move(request));
  session.trace_started = true;
}

bool tick_trace(Session& session) {
  if (!wants_trace(session)) {
    return false;
  }
  const bool sized = picture_size(session) != glm::ivec2(1);
  if (!session.trace_started && (traces_paths(session) ? sized : at_rest(session))) {
    start_trace(session);
  }
  std::optional<TracedPicture> picture = session.trace.take();
  if (!picture) {
    return false;
  }
  if (!picture->failed.empty()) {
    say(session, picture->failed, true);
    return true;
  }
  session.traced = std::move(picture);
  ++session.traced_version;
  return true;
}

// `ours`: null if ours is not one of the two.
void start_comparison(Session& session, std::shared_ptr<const Texture> ours) {
  session.compare_started = true;
  const Sides sides = sides_of(session);
  const auto picture_as = [&](Role role) {
    const OtherPicture* const picture = picture_of(session, role);
    return picture == nullptr ? std::make_shared<const DecodedPicture>(DecodedPicture{*ours})
                              : picture->decoded;
  };
  session.comparing.start(
      [sides, left = picture_as(sides.left), right = picture_as(sides.right)] {
        return compare_pictures(sides, *left, *right);
      },
      session.setup.wake);
}

bool wants_comparison(const Session& session) {
  return session.compare != CompareView::off && is_comparable(session) &&
         session.shown != nullptr && !session.compare_started && !session.comparing.busy();
}

bool has_ours(const Session& session) {
  return sides_of(session).left == Role::ours;
}

bool tick_comparison(Session& session) {
  if (wants_comparison(session) && !has_ours(session)) {
    start_comparison(session, nullptr);
  } else if (wants_comparison(session) && shows_traced(session) && session.traced->complete) {
    compare_ours(session, session.traced->picture);
  }
  std::optional<Comparison> done = session.comparing.take();
  if (!done) {
    return false;
  }
  session.comparison = std::move(done);
  ++session.comparison_version;
  return true;
}

bool tick_flicker(Session& session) {
  const bool right = session.compare == CompareView::flicker &&
                     static_cast<std::int64_t>(session.now / flicker_seconds) % 2 != 0;
  return std::exchange(session.flicker_right, right) != right;
}

bool tick_flight(Session& session, double seconds) {
  if (session.held.empty() || session.shown == nullptr) {
    return false;
  }
  const auto pressed = [&](const char* up, const char* down) {
    return (session.held.contains(up) ? 1.0 : 0.0) - (session.held.contains(down) ? 1.0 : 0.0);
  };
  glm::dvec3 by{pressed("D", "A"), pressed("E", "Q"), pressed("W", "S")};
  double rise = 0;
  double speed = 5;
  if (uses_assignment_keys(session)) {
    // From its handout: W A S D move along the view, Space and Control along the world's y axis, at
    // 5 world units per second.
    rise = pressed("Space", "Control");
    by.y = 0;
  } else {
    const Bounds& box = session.shown->bounds;
    const double size = box.empty() ? 1 : glm::length(box.max - box.min);
    const double reach = glm::length(session.camera.pivot - session.camera.position);
    speed = 0.5 * std::clamp(reach, 0.02 * size, size) * (session.fast ? 4 : 1);
  }
  const double distance = speed * std::min(seconds, 0.1);
  ViewCamera camera = moved(session.camera, by * distance);
  camera.position.y += rise * distance;
  camera.pivot.y += rise * distance;
  set_camera(session, camera);
  return true;
}

bool tick_notice(Session& session) {
  if (session.notice && session.now >= session.notice->until) {
    session.notice.reset();
    return true;
  }
  return false;
}

std::string name_of_scene(const std::string& path) {
  return path.empty() ? "" : path == "-" ? "<stdin>" : file_name_of(path);
}

// The largest box with the picture's aspect ratio in the center of the available space.
Box picture_box(const Session& session, const Box& room) {
  const bool free = picture_of(session, sides_of(session).right) == nullptr;
  const glm::dvec2 size = picture_size(session);
  const double aspect = free ? room.size.x / room.size.y : size.x / size.y;
  Box box = room;
  if (aspect * room.size.y > room.size.x) {
    box.size.y = std::max(1.0, room.size.x / aspect);
  } else {
    box.size.x = std::max(1.0, room.size.y * aspect);
  }
  box.size = glm::max(glm::floor(box.size), glm::dvec2(1));
  box.at = glm::floor(room.at + (room.size - box.size) * 0.5);
  return box;
}

}  // namespace

bool tick_files(Session& session);  // session_files.cpp
bool tick_pixel(Session& session);  // session_pixel.cpp
void keep_place(Session& session);  // session_pixel.cpp

bool wants_trace(const Session& session) {
  // OpenGL leaves reflections out.
  const bool compares = session.compare != CompareView::off && is_comparable(session);
  return traces_paths(session) ||
         ((session.settings.ray_tracing || compares) && session.shown != nullptr &&
          !session.realtime && session.mode == DrawMode::shaded);
}

bool at_rest(const Session& session) {
  return session.pointer.drag == Drag::none && session.held.empty() &&
         session.now - session.moved_at >= rest;
}

bool traces_paths(const Session& session) {
  return session.shown != nullptr && !session.realtime && session.mode == DrawMode::shaded &&
         session.setup.trace_paths.value_or(session.shown->opened.lit_by_faces_only());
}

RenderOptions trace_options(const Session& session) {
  const bool paths = traces_paths(session);
  RenderOptions options = paths ? session.setup.paths : session.setup.trace;
  const glm::ivec2 size = picture_size(session);
  options.width = size.x;
  options.height = size.y;
  if (paths) {
    return options;
  }
  options.samples = session.setup.samples.value_or(session.settings.samples);
  options.features.shadows = options.features.shadows && session.settings.shadows;
  options.features.texture = options.features.texture && session.settings.textures;
  return options;
}

bool tick(Session& session, double now) {
  const double seconds = now - session.now;
  session.now = now;
  bool news = tick_files(session);
  news = tick_flight(session, seconds) || news;
  news = tick_trace(session) || news;
  news = tick_comparison(session) || news;
  news = tick_flicker(session) || news;
  news = tick_pixel(session) || news;
  return tick_notice(session) || news;
}

bool settled(const Session& session) {
  const bool tracing = wants_trace(session) && !(session.trace_started && !session.trace.busy() &&
                                                 session.traced && session.traced->complete);
  const bool comparing = session.compare != CompareView::off && session.shown != nullptr &&
                         is_comparable(session) &&
                         (!session.compare_started || session.comparing.busy());
  return !session.loading.busy() && !session.load_again && !session.reading_document.busy() &&
         session.pictures.empty() && !session.fitting.busy() &&
         !(session.fit_wanted && session.shown != nullptr) && !tracing && !comparing &&
         !session.readout.explaining.busy() && !session.cause.finding.busy() &&
         (!session.readout.at || session.readout.asked) && session.held.empty();
}

double next_tick(const Session& session) {
  double seconds = watch_interval;
  if (!session.held.empty()) {
    return 0;
  }
  if (traces_paths(session) && !session.trace_started) {
    return 0;
  }
  const bool waits = (wants_trace(session) && !session.trace_started) ||
                     (session.readout.at && !session.readout.asked);
  if (waits) {
    seconds = std::min(seconds, session.moved_at + rest - session.now);
  }
  if (session.notice) {
    seconds = std::min(seconds, session.notice->until - session.now);
  }
  if (session.compare == CompareView::flicker) {
    seconds = std::min(seconds, flicker_seconds - std::fmod(session.now, flicker_seconds));
  }
  if (session.comparing.busy() || session.loading.busy() || session.reading.busy() ||
      session.reading_document.busy() || session.fitting.busy() ||
      session.readout.explaining.busy() || session.cause.finding.busy()) {
    seconds = std::min(seconds, 0.05);
  }
  return std::max(seconds, 0.01);
}

void picture_changed(Session& session) {
  session.moved_at = session.now;
  session.trace_started = false;
  if (traces_paths(session) && session.traced) {
    session.traced->complete = false;  // it stays until there is a new one
  } else {
    session.trace.stop();
    session.traced.reset();
  }
  session.compare_started = false;
  session.compared.reset();
  session.readout.asked = false;
  session.readout.terms.clear();
  keep_place(session);
}

void set_pixels(Session& session, const glm::ivec2& pixels) {
  const glm::ivec2 before = session.pixels;
  session.pixels = glm::max(pixels, glm::ivec2(1));
  // With a picture from a file, traced pictures have its size.
  if (session.pixels != before && picture_size(session) == session.pixels) {
    picture_changed(session);
  }
}

void set_camera(Session& session, const ViewCamera& camera) {
  const glm::dvec3 away = camera.pivot - camera.position;
  const bool finite = std::isfinite(glm::length(camera.position)) && glm::length(away) > 0;
  if (finite && !(camera == session.camera)) {
    session.camera = camera;
    picture_changed(session);
  }
}

void say(Session& session, std::string text, bool bad) {
  session.notice = Notice{std::move(text), bad, session.now + (bad ? 2 : 1) * notice_seconds};
}

void show_only_light(Session& session, std::optional<std::uint32_t> light) {
  session.only_light = light;
  picture_changed(session);
}

void select(Session& session, std::optional<std::uint32_t> row, std::vector<std::uint32_t> copy) {
  finish_edit(session);
  session.editing.part.reset();
  session.editing.light_fields.clear();
  session.keyboard_in_fields = session.keyboard_in_fields && row;
  session.selected = row;
  session.selected_copy = std::move(copy);
  describe_selection(session);
  if (row && session.shown != nullptr) {
    reveal_selection(session);
  }
}

void describe_selection(Session& session) {
  session.selected_box = selected_bounds(session);
  session.selected_path.clear();
  if (!session.selected || session.shown == nullptr) {
    return;
  }
  const OutlineRow& row = session.shown->outline.rows[*session.selected];
  if (row.source != no_index && row.kind != RowKind::light) {
    session.selected_path = session.shown->names->text({row.source, session.selected_copy});
  }
}

void reveal_selection(Session& session) {
  for (const std::uint32_t around : rows_around(session.shown->outline, *session.selected)) {
    session.open_rows.insert(around);
  }
  session.reveal_selected = true;
}

const std::vector<std::uint32_t>& visible_rows(Session& session) {
  VisibleRows& visible = session.visible_rows;
  if (visible.version != session.version || visible.open != session.open_rows) {
    visible = {session.version, session.open_rows,
               visible_rows(session.shown->outline, session.open_rows)};
  }
  return visible.rows;
}

Bounds selected_bounds(const Session& session) {
  if (!session.selected || session.shown == nullptr) {
    return {};
  }
  const SceneOnShow& scene = *session.shown;
  const RenderScene& ready = scene.opened.ready.scene;
  const OutlineRow& row = scene.outline.rows[*session.selected];
  return session.selected_copy.empty()
             ? bounds_of(ready, scene.opened.assets, sources_in(scene.outline, *session.selected))
             : bounds_of_copy(ready, scene.opened.assets, row.source, session.selected_copy);
}

bool is_hidden(const Session& session, std::uint32_t row) {
  const Outline& outline = session.shown->outline;
  const auto first = outline.rows.begin() + row;
  const auto end = outline.rows.begin() + outline.rows[row].end;
  return has_sources(outline, row) && std::all_of(first, end, [&](const OutlineRow& inner) {
           return inner.source == no_index || session.hidden.contains(inner.source);
         });
}

void toggle_hidden(Session& session, std::uint32_t row) {
  const bool show = is_hidden(session, row);
  for (const std::uint32_t source : sources_in(session.shown->outline, row)) {
    if (show) {
      session.hidden.erase(source);
    } else {
      session.hidden.insert(source);
    }
  }
  picture_changed(session);
}

bool wants_picture(const Session& session) {
  return wants_comparison(session) && has_ours(session) && !wants_trace(session) &&
         at_rest(session);
}

void compare_ours(Session& session, Texture ours) {
  if (wants_comparison(session) && has_ours(session)) {
    session.compared = std::make_shared<const Texture>(std::move(ours));
    start_comparison(session, session.compared);
  }
}

std::vector<Sides> possible_sides(const Session& session) {
  const auto size = [](const OtherPicture& picture) {
    return glm::ivec2(picture.decoded->texture.width, picture.decoded->texture.height);
  };
  const bool mine = session.mine.exists();
  const bool reference =
      session.reference.exists() && (!mine || size(session.reference) == size(session.mine));
  std::vector<Sides> all;
  if (reference && mine) {
    all.push_back({Role::reference, Role::mine});
  }
  if (mine) {
    all.push_back({Role::ours, Role::mine});
  }
  if (reference) {
    all.push_back({Role::ours, Role::reference});
  }
  return all;
}

Sides sides_of(const Session& session) {
  const std::vector<Sides> all = possible_sides(session);
  return all.empty() ? Sides() : all[session.sides % all.size()];
}

bool is_comparable(const Session& session) {
  return sides_of(session) != Sides() && session.camera == session.home;
}

const OtherPicture* picture_of(const Session& session, Role role) {
  const OtherPicture& picture = role == Role::mine ? session.mine : session.reference;
  return role == Role::ours || !picture.exists() ? nullptr : &picture;
}

std::string role_name(const Session& session, Role role) {
  const OtherPicture* const picture = picture_of(session, role);
  return picture == nullptr
             ? std::string(role_word(role))
             : fmt::format("{}: {}", role_word(role), escaped(file_name_of(picture->path), 60));
}

Role role_in_front(const Session& session) {
  const Sides sides = sides_of(session);
  if (session.compare == CompareView::off ||
      (!is_comparable(session) && session.compare != CompareView::other)) {
    return Role::ours;
  }
  const bool right = session.compare == CompareView::other || session.flicker_right;
  return right ? sides.right : sides.left;
}

glm::ivec2 picture_size(const Session& session) {
  for (const Role role : {Role::mine, Role::reference}) {
    if (const OtherPicture* const picture = picture_of(session, role)) {
      return {picture->decoded->texture.width, picture->decoded->texture.height};
    }
  }
  return glm::max(session.pixels, glm::ivec2(1));
}

void place_pictures(Session& session, const Box& room) {
  session.picture = session.beside = picture_box(session, room);
  if (session.compare != CompareView::side_by_side || sides_of(session) == Sides()) {
    return;
  }
  constexpr double gap = 4;
  double largest = 0;
  for (const int axis : {0, 1}) {
    Box first = room;
    first.size[axis] = std::max(1.0, (room.size[axis] - gap) / 2);
    Box second = first;
    second.at[axis] += first.size[axis] + gap;
    if (const Box box = picture_box(session, first); box.size.x > largest) {
      largest = box.size.x;
      session.picture = box;
      session.beside = picture_box(session, second);
    }
  }
}

bool uses_assignment_keys(const Session& session) {
  return session.realtime && session.settings.assignment_keys;
}

CameraView camera_view(const Session& session) {
  const Box box = whole_picture(session, session.picture);
  if (!session.realtime) {
    return {box, box.size.x / box.size.y};
  }
  const RealtimeWindow window = realtime_window(session.pixels.x, session.pixels.y);
  const RealtimeWindow frame =
      realtime_frame(session.realtime_panel.milestone, session.pixels.x, session.pixels.y);
  CameraView view{box, double(window.width) / window.height};
  view.box.size *= glm::dvec2(session.pixels) / glm::dvec2(frame.width, frame.height);
  view.box.at.y += box.size.y - view.box.size.y;
  return view;
}

Ray ray_in_window(const Session& session, const glm::dvec2& at) {
  const CameraView view = camera_view(session);
  return ray_through(render_camera(session.camera), (at - view.box.at) / view.box.size,
                     view.aspect);
}

std::optional<glm::dvec2> point_in_window(const Session& session, const glm::dvec3& point) {
  const RenderCamera camera = render_camera(session.camera);
  const CameraView view = camera_view(session);
  const glm::dvec3 to = point - camera.position;
  const double depth = -glm::dot(to, camera.w);
  if (depth <= 0) {
    return std::nullopt;
  }
  const double reach = 2 * std::tan(camera.fov_y / 2) * std::max(depth, 1e-9);
  const glm::dvec2 scale = view.box.size / glm::dvec2(reach * view.aspect, reach);
  const glm::dvec2 middle = view.box.at + view.box.size * 0.5;
  return glm::clamp(middle + glm::dvec2(glm::dot(to, camera.u), -glm::dot(to, camera.v)) * scale,
                    -1e5, 1e5);
}

bool shows_traced(const Session& session) {
  return wants_trace(session) && session.traced && !session.traced->picture.empty();
}

bool needs_drawing(const Session& session) {
  return session.shown != nullptr && !traces_paths(session) && !shows_traced(session);
}

DrawOptions draw_options(const Session& session) {
  DrawOptions options = draw_options(trace_options(session));
  if (session.mode != DrawMode::shaded) {
    options.mode = session.mode;
  }
  if (session.realtime) {
    options.realtime = session.realtime_panel;
  }
  const RenderScene& scene = session.shown->opened.ready.scene;
  options.lights.assign(scene.lights.size(), !session.only_light);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (session.only_light == i) {
      options.lights[i] = true;
    }
    if (session.hidden.contains(scene.lights[i].source)) {
      options.lights[i] = false;
    }
  }
  if (!session.hidden.empty()) {
    options.objects.assign(*session.hidden.rbegin() + std::size_t{1}, true);
    for (const std::uint32_t source : session.hidden) {
      options.objects[source] = false;
    }
  }
  return options;
}

std::string scene_name(const Session& session) {
  return name_of_scene(session.path);
}

std::string shown_name(const Session& session) {
  return name_of_scene(session.shown->opened.path);
}

std::string mode_text(const Session& session) {
  static constexpr std::array<std::string_view, 7> names{
      "shaded", "wireframe", "normals",       "texture coordinates",
      "depth",  "objects",   "bounding boxes"};
  std::string text(names[static_cast<std::size_t>(session.mode)]);
  if (session.realtime) {
    text = session.realtime_panel.milestone == Milestone::action
               ? "Realtime, Action: " + text
               : "Realtime, Lights, Camera: " + text;
  } else if (traces_paths(session)) {
    text += ", mode path";
  } else {
    const RenderOptions& trace = session.setup.trace;
    text += fmt::format(", profile {}", profile_word(trace.profile));
    text += trace.mode == Mode::ray ? "" : fmt::format(", {}", mode_word(trace.mode));
  }
  if (session.only_light) {
    text += fmt::format(", only light {}", *session.only_light + 1);
  }
  return text;
}

}  // namespace scenefile::viewer
