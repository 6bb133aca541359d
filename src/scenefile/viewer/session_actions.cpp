// The table of what the window can do, and the functions that do it.

#include "scenefile/base/text.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/collect_views.h"
#include "scenefile/viewer/playlist.h"
#include "scenefile/viewer/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace scenefile::viewer {

namespace {

void frame(Session& session) {
  const Bounds& box = session.selected_box;
  const double aspect = session.picture.size.x / session.picture.size.y;
  set_camera(session, framing(session.camera, box.empty() ? session.shown->bounds : box, aspect));
}

// Shows a notice if there is none.
const Document* document_or_notice(Session& session) {
  const Document* const document = edited_document(session);
  if (document == nullptr) {
    say(session, "this scene cannot be edited: " + refusal_to_edit(session), true);
  }
  return document;
}

// Makes an edit of the selected item.
void edit_selection(Session& session,
                    const std::function<Result<Edit>(const Document&, ItemId)>& edit) {
  const Document* const document = document_or_notice(session);
  if (document == nullptr) {
    return;
  }
  const std::optional<ItemId> item = selected_item(session);
  make_edit(session, item ? edit(*document, *item)
                          : input_error("what is selected is not in the text of the file"));
}

void use_view(Session& session) {
  const Document* const document = document_or_notice(session);
  if (document == nullptr) {
    return;
  }
  const Camera camera = camera_of(session.camera, session.shown->opened.camera());
  const Result<Edit> edit = set_camera(*document, camera);
  if (edit && edit->changes.empty()) {
    say(session, scene_name(session) + " already has this camera");
    return;
  }
  session.home = session.camera;  // the view follows the camera of the scene
  make_edit(session, edit);
  if (edit) {
    say(session, "the scene has this camera now; Ctrl+S saves it");
  }
}

void open_list_to_add(Session& session) {
  session.adding = true;
  session.settings.outline = true;
  session.picture_only = false;
  session.keyboard_in_fields = true;
}

void duplicate(Session& session) {
  const bool block = selected_item(session) && session.editing.part->block;
  edit_selection(session, [&](const Document& document, ItemId item) {
    return duplicate_item(document, item, viewpoint_of(session));
  });
  if (block) {
    session.editing.part->block = true;
  }
}

void enter_group(Session& session) {
  edit_selection(session, [](const Document& document, ItemId item) -> Result<Edit> {
    if (const std::optional<ItemId> group = group_to_enter(document, item)) {
      return move_into(document, item, *group);
    }
    const Result<Edit> wrapped = wrap_in_group(document, item);
    return wrapped ? input_error("no group beside it can take it; Ctrl+G makes one") : wrapped;
  });
}

void leave_group(Session& session) {
  edit_selection(session, [](const Document& document, ItemId item) -> Result<Edit> {
    const std::optional<ItemId> group = group_outside(document, item);
    return group ? move_into(document, item, *group)
                 : Result<Edit>(input_error("it is not in a group"));
  });
}

template <Result<Edit> (*edit)(const Document&, ItemId)>
void edit_selected(Session& session) {
  edit_selection(session, edit);
}

template <int step>
void reorder(Session& session) {
  edit_selection(session, [](const Document& document, ItemId item) {
    return reorder_item(document, item, step);
  });
}

// The visible row of the outline before or after the selected one.
template <int step>
void select_neighbor(Session& session) {
  const std::vector<std::uint32_t>& rows = visible_rows(session);
  const auto now =
      session.selected ? std::find(rows.begin(), rows.end(), *session.selected) : rows.end();
  const auto count = static_cast<std::ptrdiff_t>(rows.size());
  const std::ptrdiff_t next = now == rows.end() ? 0 : now - rows.begin() + step;
  select(session, rows[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, count - 1))]);
}

// Adds the view to the path of the scene's views, or removes the last one.
template <bool adds>
void change_path(Session& session) {
  const std::string path = views_file(session.path);
  const Camera scene = session.shown->opened.camera();
  const Result<std::size_t> views =
      change_views(path, adds ? std::optional(camera_of(session.camera, scene)) : std::nullopt,
                   scene, session.setup.read.limits);
  if (!views) {
    say(session, fmt::format("cannot change the path of views: {}", views.error().text), true);
  } else {
    say(session, fmt::format("view {} is {} {}", *views + (adds ? 0 : 1),
                             adds ? "added to" : "removed from", escaped(path)));
  }
}

template <int steps>
void go_to_neighbor(Session& session) {
  const bool no_file = session.path.empty() || session.path == "-";
  const std::string path = no_file ? "" : neighbor_of(session.path, steps);
  if (path.empty() || path == session.path) {
    say(session, "there is no other scene in this folder");
    return;
  }
  session.notice.reset();  // about the previous scene
  open_scene(session, path);
}

void next_light(Session& session) {
  const std::size_t count = session.shown->opened.ready.scene.lights.size();
  const std::uint32_t next = session.only_light ? *session.only_light + 1 : 0;
  show_only_light(session, next < count ? std::optional(next) : std::nullopt);
}

// Shows the pictures this way, or only ours again.
template <CompareView view>
void compare_by(Session& session) {
  session.compare = session.compare == view ? CompareView::off : view;
}

void next_sides(Session& session) {
  ++session.sides;
  session.comparison.reset();
  session.compare_started = false;
}

// The first unused name: stem.png, stem-2.png, ...
std::string free_name(const std::string& stem, std::string_view extension) {
  std::string name = fmt::format("{}{}", stem, extension);
  for (int i = 2; stamp_of(name).exists; ++i) {
    name = fmt::format("{}-{}{}", stem, i, extension);
  }
  return name;
}

std::string screenshot_name(const Session& session) {
  const bool no_file = session.path.empty() || session.path == "-";
  const std::string name = no_file ? "scene" : file_name_of(session.path);
  return free_name(name.substr(0, name.rfind('.')) + "-view", ".png");
}

template <DrawMode mode>
void set_mode(Session& session) {
  session.mode = mode;
  picture_changed(session);
}

void scale_text(Session& session, double factor) {
  session.settings.text_scale =
      static_cast<float>(std::clamp(session.settings.text_scale * factor, 0.5, 4.0));
}

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

std::string camera_text(const ViewCamera& camera) {
  return fmt::format("pos {}\nlook {}\nup {}\nheightangle {:.6g}\n", vector_text(camera.position),
                     vector_text(camera.pivot - camera.position), vector_text(camera.up),
                     camera.height_angle_deg);
}

std::string selection_text(Session& session) {
  const OutlineRow& row = session.shown->outline.rows[*session.selected];
  std::string text = row.label;
  if (row.location.known()) {
    text += fmt::format(" {}:{}:{}", session.shown->opened.path, row.location.line,
                        row.location.column);
  }
  text += '\n';
  if (!session.selected_path.empty()) {
    text += session.selected_path + '\n';
  }
  if (const std::optional<ItemId> item = selected_item(session)) {
    for (const FieldView& field : session.editing.document->fields(*item)) {
      if (field.written) {
        text += field.name;
        for (const FieldPart& part : field.parts) {
          text += ' ' + part.value;
        }
        text += '\n';
      }
    }
  }
  return text;
}

// The readout of the clicked pixel, or the selection and its fields, or the window's camera with
// the names of a scene file.
void copy(Session& session) {
  const bool pixel = session.readout.at.has_value();
  session.copied = pixel              ? readout_text(session)
                   : session.selected ? selection_text(session)
                                      : camera_text(session.camera);
  say(session, fmt::format("copied: the {}", pixel              ? "pixel"
                                             : session.selected ? "selection"
                                                                : "camera"));
}

void escape(Session& session) {
  if (session.question) {
    answer_question(session, session.question->answers.size() - 1);
  } else if (session.palette) {
    session.palette = false;
  } else if (session.editing.progress) {
    cancel_edit(session);
    session.pointer.drag = Drag::none;
  } else if (session.keyboard_in_fields) {
    session.keyboard_in_fields = false;
  } else if (session.help) {
    session.help = false;
  } else if (session.start.open) {
    close_start_panel(session);
  } else if (session.full_screen) {
    session.full_screen = false;
  } else if (session.explaining) {
    session.explaining = false;
    read_pixel(session, std::nullopt);
  } else if (session.zoom > 1) {
    zoom_picture(session, 0, session.looked_at);
  } else {
    select(session, std::nullopt);
  }
}

template <Side side>
void look_from(Session& session) {
  set_camera(session, seen_from(session.camera, side));
}

void show_all(Session& session) {
  session.hidden.clear();
  picture_changed(session);
}

void reload(Session& session) {
  if (!session.path.empty()) {
    open_scene(session, session.path);
  }
}

void toggle_tracing(Session& session) {
  session.settings.ray_tracing = !session.settings.ray_tracing;
  picture_changed(session);
}

void toggle_explaining(Session& session) {
  session.explaining = !session.explaining;
  if (!session.explaining) {
    read_pixel(session, std::nullopt);
  }
}

void toggle_panels(Session& session) {
  session.picture_only = !session.picture_only;
  session.keyboard_in_fields = false;
}

template <int x, int y>
void look_at_next(Session& session) {
  look_beside(session, {x, y});
}

// Reasons why an action has no effect.

std::string never(const Session& /*session*/) {
  return {};
}
std::string no_scene(const Session& session) {
  return session.shown == nullptr ? "no scene is open" : "";
}
std::string not_selected(const Session& session) {
  return session.shown != nullptr && !session.selected ? "nothing is selected" : no_scene(session);
}
std::string other_scene(const Session& session) {
  return session.shown == nullptr || shows_edited_scene(session) ? no_scene(session)
                                                                 : refusal_to_edit(session);
}
std::string not_editable(const Session& session) {
  const std::string other = other_scene(session);
  return other.empty() ? not_selected(session) : other;
}
std::string not_done(const Session& session) {
  const bool done = !session.editing.done.empty() || session.editing.progress;
  return done ? "" : "there is nothing to undo";
}
std::string not_undone(const Session& session) {
  return session.editing.undone.empty() ? "there is nothing to redo" : "";
}
std::string none_hidden(const Session& session) {
  return session.hidden.empty() ? "nothing is hidden" : "";
}
std::string no_picture(const Session& session) {
  return sides_of(session) == Sides() ? "there is no picture to compare with; drop one into the "
                                        "window, or name one: scenefile view SCENE PICTURE.png"
                                      : "";
}
std::string one_picture(const Session& session) {
  return possible_sides(session).size() < 2 ? "for this, give two pictures of the same size: "
                                              "--reference A.png --mine B.png"
                                            : "";
}

bool is_off(const Session& /*session*/) {
  return false;
}

// What an action switches on and off: a member of the session or of its settings.
template <auto member>
auto& flag_of(auto& session) {
  if constexpr (std::is_same_v<decltype(member), bool Settings::*>) {
    return session.settings.*member;
  } else {
    return session.*member;
  }
}
template <auto member>
bool is_set(const Session& session) {
  return flag_of<member>(session);
}
template <auto member>
void toggle(Session& session) {
  flag_of<member>(session) = !flag_of<member>(session);
}
template <auto member>
void toggle_in_picture(Session& session) {
  toggle<member>(session);
  forget_cause(session);
  picture_changed(session);
}

using A = Action;

constexpr ActionRow row(Action action, std::string_view key, std::string_view group,
                        std::string_view what, void (*act)(Session&),
                        std::string (*refusal)(const Session&) = never,
                        bool (*is_on)(const Session&) = is_off) {
  return {action, key, group, what, act, refusal, is_on};
}
template <DrawMode mode>
constexpr ActionRow mode_row(Action action, std::string_view key, std::string_view what) {
  return {action, key, "Show", what, set_mode<mode>, no_scene, [](const Session& s) {
            return s.mode == mode;
          }};
}
template <auto member>
constexpr ActionRow flag_row(Action action, std::string_view key, std::string_view group,
                             std::string_view what, void (*act)(Session&) = toggle<member>) {
  return {action, key, group, what, act, never, is_set<member>};
}
template <CompareView view>
constexpr ActionRow compare_row(Action action, std::string_view key, std::string_view what) {
  return {action, key, "Compare", what, compare_by<view>, no_picture, [](const Session& s) {
            return s.compare == view;
          }};
}

constexpr std::array action_rows{
    row(
        A::scene_camera, "Home", "Camera", "the scene's own camera",
        [](Session& s) { set_camera(s, s.home); }, no_scene),
    row(A::frame, "F", "Camera", "frame the selection, or everything", frame, no_scene),
    row(A::side_front, "Ctrl+1", "Camera", "from the front", look_from<Side::front>, no_scene),
    row(A::side_back, "Ctrl+Shift+1", "Camera", "from behind", look_from<Side::back>, no_scene),
    row(A::side_right, "Ctrl+3", "Camera", "from the right", look_from<Side::right>, no_scene),
    row(A::side_left, "Ctrl+Shift+3", "Camera", "from the left", look_from<Side::left>, no_scene),
    row(A::side_top, "Ctrl+7", "Camera", "from above", look_from<Side::top>, no_scene),
    row(A::side_bottom, "Ctrl+Shift+7", "Camera", "from below", look_from<Side::bottom>, no_scene),
    row(A::use_view, "C", "Camera", "make this view the scene's camera", use_view, other_scene),
    row(A::collect_view, "V", "Camera", "add the view to a path for frames", change_path<true>,
        other_scene),
    row(A::drop_view, "Shift+V", "Camera", "remove the last view of the path", change_path<false>,
        other_scene),
    row(A::undo, "Ctrl+Z", "Edit", "undo the last edit", undo_edit, not_done),
    row(A::redo, "Ctrl+Shift+Z", "Edit", "redo it", redo_edit, not_undone),
    row(A::add, "Insert", "Edit", "add an object, a light, or a field", open_list_to_add,
        other_scene),
    row(A::duplicate, "Ctrl+D", "Edit", "duplicate the selection", duplicate, not_editable),
    row(A::wrap, "Ctrl+G", "Edit", "put the selection into a new group",
        edit_selected<wrap_in_group>, not_editable),
    row(A::earlier, "Ctrl+Up", "Edit", "move the selection up in its group", reorder<-1>,
        not_editable),
    row(A::later, "Ctrl+Down", "Edit", "move it down", reorder<1>, not_editable),
    row(A::enter_group, "Ctrl+Right", "Edit", "move it into a group beside it", enter_group,
        not_editable),
    row(A::leave_group, "Ctrl+Left", "Edit", "move it out of its group", leave_group, not_editable),
    row(A::remove, "Delete", "Edit", "delete the selection", edit_selected<remove_item>,
        not_editable),
    row(A::correct, "Ctrl+E", "Edit", "correct what is certain", correct_text),
    row(
        A::handles, "B", "Edit", "handles: move, turn, scale, none",
        [](Session& s) { s.handles = static_cast<Handles>((static_cast<int>(s.handles) + 1) % 4); },
        no_scene, [](const Session& s) { return s.handles != Handles::none; }),
    row(A::row_above, "Up", "Edit", "select the row above in the outline", select_neighbor<-1>,
        no_scene),
    row(A::row_below, "Down", "Edit", "select the row below", select_neighbor<1>, no_scene),
    row(
        A::edit_fields, "Enter", "Edit", "go to the fields with the keyboard",
        [](Session& s) { s.keyboard_in_fields = true; }, not_selected),
    mode_row<DrawMode::shaded>(A::shaded, "1", "shaded"),
    mode_row<DrawMode::wireframe>(A::wireframe, "2", "wireframe"),
    mode_row<DrawMode::normals>(A::normals, "3", "normals"),
    mode_row<DrawMode::uv>(A::uv, "4", "texture coordinates"),
    mode_row<DrawMode::depth>(A::depth, "5", "depth"),
    mode_row<DrawMode::object_id>(A::object_id, "6", "objects, each in a color"),
    mode_row<DrawMode::bounding_boxes>(A::bounding_boxes, "7", "overdraw of bounding boxes"),
    flag_row<&Settings::textures>(A::toggle_textures, "T", "Show", "textures",
                                  toggle_in_picture<&Settings::textures>),
    flag_row<&Settings::shadows>(A::toggle_shadows, "K", "Show", "shadows",
                                 toggle_in_picture<&Settings::shadows>),
    row(A::next_light, "L", "Show", "one light at a time", next_light, no_scene,
        [](const Session& s) { return s.only_light.has_value(); }),
    row(
        A::all_lights, "Shift+L", "Show", "all lights",
        [](Session& s) { show_only_light(s, std::nullopt); }, no_scene),
    flag_row<&Settings::axes>(A::axes, "N", "Show", "axes, lights and the scene's camera"),
    row(
        A::hide_selected, "H", "Show", "hide the selection, or show it again",
        [](Session& s) { toggle_hidden(s, *s.selected); }, not_selected),
    row(A::show_all, "Shift+H", "Show", "show everything", show_all, none_hidden),
    flag_row<&Settings::ray_tracing>(A::trace, "R", "Picture", "ray tracing when the camera rests",
                                     toggle_tracing),
    flag_row<&Session::realtime>(A::realtime, "G", "Picture", "the assignment Realtime",
                                 toggle_in_picture<&Session::realtime>),
    row(A::zoom_in, "+", "Picture", "zoom in, up to the values of pixels",
        [](Session& s) { zoom_picture(s, 1.5, s.looked_at); }),
    row(A::zoom_out, "-", "Picture", "zoom out",
        [](Session& s) { zoom_picture(s, 1 / 1.5, s.looked_at); }),
    row(A::zoom_all, "0", "Picture", "all of the picture",
        [](Session& s) { zoom_picture(s, 0, s.looked_at); }),
    row(A::look_left, "Shift+Left", "Picture", "a pixel to the left", look_at_next<-1, 0>),
    row(A::look_right, "Shift+Right", "Picture", "a pixel to the right", look_at_next<1, 0>),
    row(A::look_up, "Shift+Up", "Picture", "a pixel up", look_at_next<0, -1>),
    row(A::look_down, "Shift+Down", "Picture", "a pixel down", look_at_next<0, 1>),
    flag_row<&Session::magnifier>(A::magnifier, "U", "Picture", "magnifier at the pointer"),
    flag_row<&Settings::linear_values>(A::linear_values, "Shift+U", "Picture",
                                       "values from 0 to 1, not to 255"),
    flag_row<&Session::explaining>(A::explain, "Y", "Picture",
                                   "explain the pixels that are clicked", toggle_explaining),
    row(A::screenshot, "F12", "Picture", "screenshot of the window",
        [](Session& s) { s.screenshot = screenshot_name(s); }),
    compare_row<CompareView::split>(A::split, "X", "left and right of a line"),
    compare_row<CompareView::side_by_side>(A::side_by_side, "Shift+X", "side by side"),
    compare_row<CompareView::other>(A::other, "Z", "the other picture in place of the first"),
    compare_row<CompareView::flicker>(A::flicker, "Shift+Z", "flicker: both by turns"),
    compare_row<CompareView::difference>(A::difference, "M", "heat map of the differences"),
    compare_row<CompareView::flip>(A::flip, "Shift+M", "FLIP: visible differences"),
    row(A::next_sides, "J", "Compare", "another two of ours, reference and mine", next_sides,
        one_picture),
    row(A::exchange_roles, "Shift+J", "Compare", "exchange reference and mine", exchange_roles,
        no_picture),
    row(A::open, "Ctrl+O", "Scene", "open a scene: recent files, folders",
        [](Session& s) { s.start.open ? close_start_panel(s) : open_start_panel(s); }),
    row(A::new_scene, "Ctrl+N", "Scene", "start a new scene",
        [](Session& s) { new_scene(s, free_name("scene", ".xml"), true); }),
    row(A::save, "Ctrl+S", "Scene", "save the scene", save_scene, no_scene),
    row(
        A::save_as, "Ctrl+Shift+S", "Scene", "save it under another name",
        [](Session& s) { ask_where_to_save(s, s.path == "-" ? "scene.xml" : s.path); }, no_scene),
    row(A::reload, "F5", "Scene", "read the file again", reload),
    row(A::next_scene, "Page Down", "Scene", "the next scene in the folder", go_to_neighbor<1>),
    row(A::previous_scene, "Page Up", "Scene", "the previous scene in the folder",
        go_to_neighbor<-1>),
    row(A::copy, "Ctrl+C", "Window", "copy pixel, selection or camera", copy, no_scene),
    flag_row<&Settings::outline>(A::outline, "O", "Window", "outline"),
    flag_row<&Settings::messages>(A::messages, "P", "Window", "messages"),
    flag_row<&Settings::statistics>(A::statistics, "I", "Window", "figures"),
    flag_row<&Session::picture_only>(A::panels, "Tab", "Window", "show only the picture",
                                     toggle_panels),
    row(A::larger_text, "Ctrl++", "Window", "larger text", [](Session& s) { scale_text(s, 1.1); }),
    row(A::smaller_text, "Ctrl+-", "Window", "smaller text",
        [](Session& s) { scale_text(s, 1 / 1.1); }),
    flag_row<&Session::full_screen>(A::full_screen, "F11", "Window", "full screen"),
    flag_row<&Session::palette>(A::palette, "Ctrl+Shift+P", "Window", "search in all commands"),
    flag_row<&Session::help>(A::help, "F1", "Window", "this help"),
    row(A::escape, "Escape", "Window", "close a panel, or clear the selection", escape),
    row(A::quit, "Ctrl+Q", "Window", "quit",
        [](Session& s) { before_losing_edits(s, [](Session& now) { now.quit = true; }); }),
};

}  // namespace

std::span<const ActionRow> actions() {
  return action_rows;
}

void perform(Session& session, Action action) {
  const ActionRow& row = row_of(action);
  if (std::string refusal = row.refusal(session); !refusal.empty()) {
    say(session, std::move(refusal));
  } else {
    row.act(session);
  }
}

}  // namespace scenefile::viewer
