// Reading and writing the session's files.

#include "scenefile/asset/image_file.h"
#include "scenefile/base/text.h"
#include "scenefile/format/recognize.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/placement/bounds.h"
#include "scenefile/viewer/drawing_choices.h"
#include "scenefile/viewer/playlist.h"
#include "scenefile/viewer/recent_files.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

constexpr std::uint32_t rows_open_at_first = 40;

// Bright enough to be visible.
std::vector<glm::vec3> colors_of(const Prepared& ready) {
  std::vector<glm::vec3> colors(ready.sources.size(), glm::vec3(0.5F));
  for (const RenderGroup& group : ready.scene.groups) {
    for (const RenderPrimitive& primitive : group.primitives) {
      const RenderMaterial& m = ready.scene.materials[primitive.material];
      colors[primitive.source] =
          glm::clamp(m.diffuse + m.transparent + 0.5F * m.reflective, 0.12F, 1.0F);
    }
  }
  return colors;
}

// Runs on another thread.
std::shared_ptr<SceneOnShow> load(const LoadScene& load_scene, const SceneRequest& request,
                                  std::uint64_t version) {
  auto scene = std::make_shared<SceneOnShow>();
  scene->opened = load_scene(request);
  scene->text_version = version;
  scene->from_file = !request.text;
  const OpenedScene& opened = scene->opened;
  if (opened.usable()) {
    scene->outline = make_outline(opened.written, opened.ready);
    scene->names.emplace(opened.written, opened.ready.sources);
    scene->colors = colors_of(opened.ready);
    scene->bounds = scene_bounds(opened.ready.scene, opened.assets);
    scene->picker = std::make_unique<Picker>(opened.ready.scene, opened.assets);
  }
  return scene;
}

void start_loading(Session& session, bool from_file) {
  session.load_file = session.load_file || from_file;
  if (session.loading.busy()) {
    session.load_again = true;
    return;
  }
  session.load_again = false;
  SceneRequest request{session.path, session.editing.text,
                       session.setup.trace_paths.value_or(false)};
  if (std::exchange(session.load_file, false)) {
    request.text.reset();
  }
  session.loading.start(
      [load_scene = session.setup.load, request = std::move(request),
       version = session.editing.version] { return load(load_scene, request, version); },
      session.setup.wake);
}

void watch_files(Session& session, const SceneOnShow& scene) {
  std::vector<std::string> paths = scene.opened.files;
  if (session.path != "-") {
    paths.push_back(session.path);
  }
  for (const OtherPicture* const picture : {&session.reference, &session.mine}) {
    if (picture->exists()) {
      paths.push_back(picture->path);
    }
  }
  session.watch.watch(std::move(paths));
}

ViewCamera home_of(const SceneOnShow& scene) {
  const Camera camera = scene.opened.camera();
  ViewCamera home = view_of(camera, pivot_distance(camera, scene.bounds));
  const Ray middle = ray_through(render_camera(home), {0.5, 0.5}, 1);
  if (const std::optional<Pick> pick = scene.picker->pick(middle)) {
    home = view_of(camera, pick->distance);
  }
  return home;
}

// A new version of the same file: keeps the state of unchanged objects.
void keep_state(Session& session, const SceneOnShow& before, const SceneOnShow& after) {
  const std::vector<std::uint32_t> rows = match_rows(before.outline, after.outline);
  const auto row_of = [&](std::uint32_t row) { return rows[row]; };
  const auto source_of = [&](std::uint32_t source) {
    const std::uint32_t old = before.outline.row_of_source[source];
    const std::uint32_t now = old == no_index ? no_index : rows[old];
    return now == no_index ? no_index : after.outline.rows[now].source;
  };
  const auto keep_all = [](std::set<std::uint32_t>& kept, const auto& successor) {
    std::set<std::uint32_t> now;
    for (const std::uint32_t one : kept) {
      now.insert(successor(one));
    }
    now.erase(no_index);
    kept = std::move(now);
  };
  keep_all(session.open_rows, row_of);
  keep_all(session.hidden, source_of);
  if (session.selected) {
    const std::uint32_t row = row_of(*session.selected);
    session.selected = row == no_index ? std::nullopt : std::optional(row);
  }
  std::vector<std::uint32_t>& copy = session.selected_copy;
  std::transform(copy.begin(), copy.end(), copy.begin(), source_of);
  if (!session.selected || std::find(copy.begin(), copy.end(), no_index) != copy.end()) {
    copy.clear();
  }
  if (session.only_light) {
    const std::vector<RenderLight>& lights = after.opened.ready.scene.lights;
    const std::uint32_t source =
        source_of(before.opened.ready.scene.lights[*session.only_light].source);
    const auto found = std::find_if(lights.begin(), lights.end(), [&](const RenderLight& light) {
      return light.source == source;
    });
    session.only_light.reset();
    if (source != no_index && found != lights.end()) {
      session.only_light = static_cast<std::uint32_t>(found - lights.begin());
    }
  }
}

void start_state(Session& session) {
  session.hidden.clear();
  session.selected.reset();
  session.selected_copy.clear();
  session.open_rows.clear();
  session.only_light.reset();
}

void open_first_rows(Session& session) {
  const Outline& outline = session.shown->outline;
  for (std::uint32_t row = 0; row < outline.rows.size(); ++row) {
    if (outline.rows[row].depth == 0 || outline.rows.size() <= rows_open_at_first) {
      session.open_rows.insert(row);
    }
  }
}

// After an edit, in the outline.
void select_edited_item(Session& session) {
  if (const std::optional<std::uint32_t> row = row_of_selected_item(session);
      row && row != session.selected) {
    session.selected = row;
    session.selected_copy.clear();
    reveal_selection(session);
  }
  describe_selection(session);
}

void show(Session& session, std::shared_ptr<const SceneOnShow> scene) {
  const bool same_file = shows_edited_scene(session);
  const bool at_home = session.shown == nullptr || session.camera == session.home;
  if (same_file) {
    keep_state(session, *session.shown, *scene);
  } else {
    start_state(session);
  }
  session.shown = std::move(scene);
  select_edited_item(session);
  ++session.version;
  session.home = home_of(*session.shown);
  if (!same_file || at_home) {
    session.camera = session.home;
  }
  if (session.open_rows.empty()) {
    open_first_rows(session);
  }
  session.broken = nullptr;
  session.comparison.reset();
  if (!same_file) {
    session.drawing_notes.clear();
    session.trace.stop();
    session.traced.reset();
    read_pixel(session, std::nullopt);
    session.fit_wanted = session.reference.exists() || session.mine.exists();
  }
  forget_cause(session);
  picture_changed(session);
}

void close_opened_panel(Session& session) {
  if (!session.start.opening) {
    return;
  }
  close_start_panel(session);
  if (session.path == "-") {
    return;
  }
  const std::string error =
      add_recent_file(session.setup.recent_files, absolute_path(session.path));
  if (!error.empty()) {
    say(session, "cannot save the list of recent files: " + error, true);
  }
}

// The file was read. Returns false if it is not to be shown.
bool take_text(Session& session, SceneOnShow& scene) {
  if (!scene.opened.unreadable.empty()) {
    return true;
  }
  if (has_unsaved_edits(session)) {
    if (scene.opened.text != session.editing.saved) {
      ask_about_changed_file(session, scene.opened.text);
    } else {
      start_loading(session, false);  // other files have changed
    }
    return false;
  }
  start_editing(session, scene.opened.text);
  scene.text_version = session.editing.version;
  return true;
}

void accept(Session& session, std::shared_ptr<SceneOnShow> scene) {
  if (scene->opened.path != session.path) {
    return;  // another scene was requested in the meantime
  }
  watch_files(session, *scene);
  if (scene->from_file && !take_text(session, *scene)) {
    return;
  }
  if (scene->opened.usable()) {
    close_opened_panel(session);
    show(session, std::move(scene));
  } else {
    session.broken = std::move(scene);
  }
}

// Runs on another thread.
ReadPicture read_picture(const std::string& path, const std::string& layer) {
  ReadPicture read;
  const Limits limits;
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  if (!bytes) {
    read.error = bytes.error().text;
    return read;
  }
  read.is_picture = is_image(*bytes);
  if (Result<DecodedPicture> picture = decode_picture(*bytes, layer, limits)) {
    read.picture = std::make_shared<const DecodedPicture>(*std::move(picture));
  } else if (!read.is_picture && is_scene_name(path)) {
    read.error = fmt::format("{} is a scene, not a picture", path);
  } else {
    read.error = fmt::format("{}: {}", path, picture.error().text);
  }
  return read;
}

void read_next_picture(Session& session) {
  if (!session.pictures.empty() && !session.reading.busy()) {
    session.reading.start([path = session.pictures.front().path,
                           layer = session.setup.layer] { return read_picture(path, layer); },
                          session.setup.wake);
  }
}

void read_picture_later(Session& session, PictureRequest request) {
  session.pictures.push_back(std::move(request));
  read_next_picture(session);
}

void pictures_changed(Session& session) {
  session.comparison.reset();
  forget_cause(session);
  picture_changed(session);
  if (session.broken != nullptr || session.shown != nullptr) {
    watch_files(session, session.broken != nullptr ? *session.broken : *session.shown);
  }
}

OtherPicture& picture_with(Session& session, Role role) {
  return role == Role::mine ? session.mine : session.reference;
}

void accept(Session& session, const PictureRequest& request, const ReadPicture& read) {
  if (request.or_scene && !read.is_picture) {
    open_scene(session, request.path);
    return;
  }
  if (read.picture == nullptr) {
    if (!request.changed) {
      say(session, read.error, true);
    }
    return;
  }
  const Role role = request.role.value_or(Role::mine);
  OtherPicture& picture = picture_with(session, role);
  if (request.changed && request.path != picture.path) {
    return;  // another one was opened in the meantime
  }
  picture = {request.path, read.picture, ++session.pictures_read};
  if (!request.changed) {
    session.role_open = !session.reference.exists() && (session.role_open || !request.role);
    session.fit_wanted =
        session.fit_wanted || role == Role::reference || !session.reference.exists();
    session.sides = 0;
    if (session.compare == CompareView::off) {
      session.compare = CompareView::split;
    }
  }
  pictures_changed(session);
}

void start_fit(Session& session) {
  session.fit_wanted = false;
  const bool right = session.reference.exists();
  const OtherPicture& picture = right ? session.reference : session.mine;
  if (!session.setup.fit_picture || !picture.exists() || traces_paths(session)) {
    return;
  }
  session.fit_version = picture.version;
  session.fitting.start(
      [question =
           FitQuestion{
               {session.shown, &session.shown->opened}, picture.path, picture.decoded, right},
       fit = session.setup.fit_picture] { return fit(question); },
      session.setup.wake);
}

void accept(Session& session, const PictureFit& fit) {
  const bool right = session.reference.exists();
  const OtherPicture& picture = right ? session.reference : session.mine;
  if (picture.version != session.fit_version) {
    return;  // another one was opened in the meantime
  }
  draw_like(session, fit);
  const std::string name = escaped(file_name_of(picture.path), 60);
  if (std::exchange(session.role_open, false) && fit.equal) {
    std::swap(session.reference, session.mine);
    say(session,
        fmt::format("{} equals our picture: it is the reference, drawn with {}", name, fit.words));
  } else if (!right) {
    say(session, fmt::format("{} {} our picture: it is mine; ours is drawn with {}", name,
                             fit.equal ? "equals" : "differs from", fit.words));
  } else {
    say(session,
        fmt::format("{}, the reference, {} our picture, drawn with {}", name,
                    fit.equal ? "equals" : "differs from", fit.words),
        !fit.equal);
  }
  pictures_changed(session);
}

}  // namespace

bool tick_files(Session& session) {
  bool news = false;
  if (std::optional<std::shared_ptr<SceneOnShow>> loaded = session.loading.take()) {
    accept(session, std::move(*loaded));
    news = true;
    if (session.load_again) {
      start_loading(session, false);
    }
  }
  if (tick_document(session)) {
    select_edited_item(session);
    news = true;
  }
  if (std::optional<ReadPicture> read = session.reading.take()) {
    const PictureRequest request = std::move(session.pictures.front());
    session.pictures.pop_front();
    accept(session, request, *read);
    read_next_picture(session);
    news = true;
  }
  if (std::optional<std::optional<PictureFit>> fit = session.fitting.take()) {
    if (*fit && !session.fit_wanted) {
      accept(session, **fit);
    }
    news = true;
  }
  if (session.fit_wanted && session.shown != nullptr && !session.loading.busy() &&
      session.pictures.empty() && !session.fitting.busy()) {
    start_fit(session);
  }
  if (session.now - session.watched_at >= watch_interval) {
    session.watched_at = session.now;
    ++session.looks;
    if (session.watch.changed()) {
      for (const Role role : {Role::reference, Role::mine}) {
        if (const OtherPicture* const picture = picture_of(session, role)) {
          read_picture_later(session, {picture->path, role, false, true});
        }
      }
      start_loading(session, !session.editing.new_file || stamp_of(session.path).exists);
      news = true;
    }
  }
  return news;
}

void open_scene(Session& session, const std::string& path) {
  const std::string scene = path == "-" ? path : scene_at(path);
  if (scene.empty()) {
    say(session, path + ": there is no scene in this folder", true);
    return;
  }
  if (scene == session.path) {
    session.start.opening = true;
    start_loading(session, !session.editing.new_file);
    return;
  }
  before_losing_edits(session, [scene](Session& s) {
    s.path = scene;
    forget_edits(s);
    s.start.opening = true;
    start_loading(s, true);
  });
}

void load_edited_text(Session& session) {
  start_loading(session, false);
}

void open_start_panel(Session& session) {
  session.start.open = true;
  session.start.appears = true;
  session.start.recent = load_recent_files(session.setup.recent_files);
  const bool in_folder = !session.path.empty() && session.path != "-";
  go_to_folder(session.start, in_folder ? folder_of(session.path) : session.start.folder);
}

void close_start_panel(Session& session) {
  session.start.open = false;
  session.start.opening = false;
}

void choose(Session& session, const std::string& path) {
  session.notice.reset();  // about an earlier choice
  if (is_folder(path)) {
    go_to_folder(session.start, path);
  } else if (!stamp_of(path).exists) {
    say(session, path + ": there is no such file", true);
  } else if (!is_scene_name(path)) {
    read_picture_later(session, {.path = path, .or_scene = true});
  } else {
    open_scene(session, path);
  }
}

void open_picture(Session& session, const std::string& path, std::optional<Role> role) {
  read_picture_later(session, {.path = path, .role = role});
}

void exchange_roles(Session& session) {
  std::swap(session.reference, session.mine);
  session.role_open = false;
  session.fit_wanted = true;
  pictures_changed(session);
}

void drop(Session& session, const std::vector<std::string>& paths) {
  session.notice.reset();  // about an earlier drop
  for (const std::string& path : paths) {
    if (!is_folder(path) && !is_scene_name(path)) {
      read_picture_later(session, {.path = path, .or_scene = true});
    } else {
      open_scene(session, path);
    }
  }
}

}  // namespace scenefile::viewer
