#pragma once
// The complete state of the window, without the window: plain data, and functions for events. A
// window (window.h) draws it and forwards user input; tests do the same directly.
//
// Positions are in pixels of the window in mouse coordinates (screen coordinates), from its top
// left. Times are seconds of any monotonic clock.

#include "scenefile/explain/object_names.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/trace/render.h"
#include "scenefile/view/draw.h"
#include "scenefile/viewer/actions.h"
#include "scenefile/viewer/background.h"
#include "scenefile/viewer/camera_control.h"
#include "scenefile/viewer/comparison.h"
#include "scenefile/viewer/editing.h"
#include "scenefile/viewer/file_watch.h"
#include "scenefile/viewer/handles.h"
#include "scenefile/viewer/live_trace.h"
#include "scenefile/viewer/opened_scene.h"
#include "scenefile/viewer/outline.h"
#include "scenefile/viewer/picker.h"
#include "scenefile/viewer/pixel_question.h"
#include "scenefile/viewer/pixel_readout.h"
#include "scenefile/viewer/settings.h"
#include "scenefile/viewer/start_panel.h"

#include <glm/glm.hpp>

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace scenefile::viewer {

inline constexpr double watch_interval = 0.25;  ///< seconds between checks of the watched files

/// Set by the program before the window opens.
struct SessionSetup {
  LoadScene load;
  ReadOptions read;       ///< how `load` reads, for editing
  RenderOptions trace;    ///< for the ray tracer; the window sets size and samples
  RenderOptions paths{};  ///< for path tracing; the window sets the size
  /// Whether to trace paths; if not set, only of scenes that are lit by faces alone.
  std::optional<bool> trace_paths{};
  std::optional<int> samples{};               ///< of the ray tracer; if not set, as in the settings
  double path_noise = viewer::path_noise;     ///< TraceRequest::noise
  std::optional<RealtimeOptions> realtime{};  ///< start with the assignment's picture
  std::function<void()> wake{};               ///< called from other threads when tick() has work
  ExplainPixel explain_pixel{};               ///< empty: pixels are not explained
  FindCause find_cause{};                     ///< empty: causes are not looked for
  FitPicture fit_picture{};    ///< empty: pictures from files are mine, and not fitted
  std::string layer{};         ///< of pictures that are EXR files with layers
  std::string recent_files{};  ///< path of the recent files; empty: not kept
};

/// A drawable scene, with derived data.
struct SceneOnShow {
  OpenedScene opened;
  std::uint64_t text_version = 0;  ///< Editing::version of its text
  bool from_file = false;          ///< its text was read from the file
  Outline outline;
  std::optional<ObjectNames> names;  ///< of its objects
  std::vector<glm::vec3> colors;     ///< of the materials of primitives, by source; for the outline
  Bounds bounds;
  std::unique_ptr<const Picker> picker;
};

/// The visible rows of an outline, and of what they were computed.
struct VisibleRows {
  std::uint64_t version = 0;  ///< Session::version
  std::set<std::uint32_t> open;
  std::vector<std::uint32_t> rows;
};

/// A picture file to read.
struct PictureRequest {
  std::string path;
  std::optional<Role> role{};  ///< not set: see open_picture()
  bool or_scene = false;       ///< if it is not a picture, it is opened as a scene
  bool changed = false;        ///< the picture has changed: errors wait for its next change
};

struct ReadPicture {
  std::shared_ptr<const DecodedPicture> picture;  ///< null: see `error`
  std::string error;                              ///< one line
  bool is_picture = false;                        ///< as far as its first bytes tell
};

/// A message that is shown for a short time.
struct Notice {
  std::string text;
  bool bad = false;
  double until = 0;
};

struct Box {
  glm::dvec2 at{0};    ///< top left
  glm::dvec2 size{1};  ///< positive

  bool holds(const glm::dvec2& p) const {
    return p.x >= at.x && p.y >= at.y && p.x < at.x + size.x && p.y < at.y + size.y;
  }
};

/// What dragging does until the button is released.
enum class Drag : std::uint8_t { none, orbit, pan, look, zoom, scroll, split, handle };

struct Pointer {
  glm::dvec2 at{0};
  bool explains = false;  ///< a click explains the pixel
  glm::dvec2 pressed_at{0};
  Drag drag = Drag::none;
  bool moved = false;     ///< since the press: no longer a click
  glm::dvec3 grasped{0};  ///< world-space point under the pointer, for zooming
};

struct Session {
  SessionSetup setup;
  Settings settings;
  double now = 0;

  // The scene.
  std::string path;                           ///< of the scene requested last; empty: none
  std::shared_ptr<const SceneOnShow> shown;   ///< the last drawable scene; null before the first
  std::uint64_t version = 0;                  ///< changes with each scene shown
  std::shared_ptr<const SceneOnShow> broken;  ///< the newest version, if it cannot be drawn
  Background<std::shared_ptr<SceneOnShow>> loading;
  bool load_again = false;  ///< once the current load is done
  bool load_file = false;   ///< the next load reads the file, not the edited text
  FileWatch watch;
  double watched_at = 0;
  std::uint64_t looks = 0;  ///< how often the files were checked

  // The view.
  ViewCamera home;
  ViewCamera camera;
  double moved_at = 0;        ///< when the picture last changed
  Box picture;                ///< position of the picture; set by the window
  glm::ivec2 pixels{1};       ///< its size in framebuffer pixels; set_pixels()
  Texture drawn;              ///< the last picture from OpenGL
  double zoom = 1;            ///< into the pictures; 1 shows all of them
  glm::dvec2 zoom_at{0.5};    ///< the middle of what is visible, by fractions of their size
  glm::dvec2 looked_at{0.5};  ///< the place under the pointer, or where keys moved it
  bool magnifier = false;     ///< around that place
  Pointer pointer;
  std::set<std::string> held;  ///< flying keys that are down
  bool fast = false;           ///< Shift is down

  // What is shown.
  DrawMode mode = DrawMode::shaded;
  std::optional<std::uint32_t> only_light;  ///< into RenderScene::lights
  Hidden hidden;
  std::optional<std::uint32_t> selected;     ///< row of the outline
  std::string selected_path;                 ///< of objects and groups: ObjectNames::text()
  std::vector<std::uint32_t> selected_copy;  ///< sources of instances around it, after clicks
  Bounds selected_box;                       ///< selected_bounds()
  std::set<std::uint32_t> open_rows;         ///< rows of the outline that show their contents
  bool reveal_selected = false;              ///< scroll the outline to the selection
  VisibleRows visible_rows;                  ///< visible_rows() caches it

  // The assignment Realtime.
  bool realtime = false;           ///< show its picture and panel
  RealtimeOptions realtime_panel;  ///< the settings in the panel

  // Ray tracing.
  LiveTrace trace;
  bool trace_started = false;           ///< for the current picture
  std::optional<TracedPicture> traced;  ///< of the current picture
  std::uint64_t traced_version = 0;     ///< changes with each picture in `traced`

  // Pictures from files.
  OtherPicture reference;
  OtherPicture mine;
  std::deque<PictureRequest> pictures;  ///< the first one is being read
  Background<ReadPicture> reading;
  std::uint64_t pictures_read = 0;
  bool role_open = false;         ///< nobody has said yet that it is `mine`: its fit will tell
  bool fit_wanted = false;        ///< of the reference, or else of mine
  std::uint64_t fit_version = 0;  ///< of the picture that is being fitted
  Background<std::optional<PictureFit>> fitting;
  std::size_t sides = 0;  ///< into possible_sides()
  CompareView compare = CompareView::off;
  Box beside;                    ///< the place of the right picture; set by the window
  double split = 0.5;            ///< fraction of the picture that shows the left one
  bool flicker_right = false;    ///< which of both is shown now
  bool compare_started = false;  ///< for the current pictures
  Background<Comparison> comparing;
  std::optional<Comparison> comparison;  ///< of the current or previous pictures
  std::uint64_t comparison_version = 0;
  std::shared_ptr<const Texture> compared;  ///< our picture in the comparison; null: none
  CauseSearch cause;

  bool explaining = false;  ///< the panel of the pixel is open; clicks explain
  PixelReadout readout;

  // Editing.
  Editing editing;
  Background<ReadDocument> reading_document;  ///< of a long text
  std::optional<Question> question;
  std::function<void(Session&)> after_saving;  ///< what before_losing_edits() has asked for
  Handles handles = Handles::move;
  std::optional<GraspedHandle> grasped;  ///< while Drag::handle
  bool keyboard_in_fields = false;       ///< the keyboard belongs to the fields of the selection
  bool keyboard_was_in_fields = false;   ///< in the last frame
  bool adding = false;                   ///< the list of what can be added is to be opened

  StartPanel start;

  // The window.
  bool help = false;
  bool palette = false;       ///< the list of all commands, to search in
  std::string palette_typed;  ///< what is searched for
  int palette_row = 0;        ///< the command that Enter performs
  bool full_screen = false;
  bool quit = false;
  bool picture_only = false;    ///< no panels
  bool shows_messages = false;  ///< the panel of them; set by the window
  double messages_height = 0;   ///< of the contents of the messages panel; set by the window
  double gui_scale = 1;         ///< pixels per pixel of a normal-density screen; set by the window
  std::string screenshot;       ///< a file for the window to write; empty: none
  std::string copied;           ///< text for the window to put on the clipboard; empty: none
  std::optional<Notice> notice;
  std::vector<std::string> drawing_notes;  ///< findings of drawing the scene
};

/// Starts loading the scene, or the first scene of a folder. Asks first if edits would be lost.
void open_scene(Session& session, const std::string& path);
/// Shows the panel that opens scenes, at the folder of the scene.
void open_start_panel(Session& session);
void close_start_panel(Session& session);
/// Opens the path that was chosen in the panel, or typed: a folder is listed, a picture compared
/// with, anything else opened as a scene. Shows a notice if there is no such file.
void choose(Session& session, const std::string& path);
/// Starts reading a picture to compare with. Without a role it is mine, unless there is no
/// reference and it equals our picture: then it is the reference. A notice is shown if it is not a
/// picture.
void open_picture(Session& session, const std::string& path, std::optional<Role> role = {});
/// Handles files or folders dropped on the window: pictures are compared with, anything else is
/// opened as a scene.
void drop(Session& session, const std::vector<std::string>& paths);

/// Advances time: takes results from other threads, checks the watched files, flies the camera.
/// Returns true if the window must be drawn again.
bool tick(Session& session, double now);
/// Whether no work is in progress.
bool settled(const Session& session);
/// When to call tick() again, in seconds from now; large if only wake() matters.
double next_tick(const Session& session);

/// Does what row_of(action) says, or shows a notice why that has no effect now.
void perform(Session& session, Action action);

/// Handles a key press. Returns false if the key has no effect.
bool key_pressed(Session& session, const KeyPress& key);
void key_released(Session& session, const std::string& name);

/// 0 left, 1 right, 2 middle.
void pointer_pressed(Session& session, int button, const KeyPress& with);
void pointer_moved(Session& session, const glm::dvec2& to);
void pointer_released(Session& session);
/// `steps` upward; moves toward the point under the pointer, or zooms into the picture there:
/// `into_picture`, and as long as not all of it is visible.
void wheel_turned(Session& session, double steps, bool into_picture = false);

void set_camera(Session& session, const ViewCamera& camera);
/// Sets the size of the picture in framebuffer pixels.
void set_pixels(Session& session, const glm::ivec2& pixels);
/// Call after any change of the picture: discards traced and compared pictures.
void picture_changed(Session& session);
/// `copy`: after a click, the sources of the instances around the object, outermost first.
void select(Session& session, std::optional<std::uint32_t> row,
            std::vector<std::uint32_t> copy = {});
/// Opens the rows around the selected one, and scrolls to it.
void reveal_selection(Session& session);
/// The visible rows of the outline; computed when the scene or the open rows have changed, because
/// large scenes have many.
const std::vector<std::uint32_t>& visible_rows(Session& session);
/// Sets its path and box.
void describe_selection(Session& session);
/// The bounding box of the selection: of the clicked instance, or of all instances; empty if
/// nothing is visible. Takes time linear in the size of the scene; Session::selected_box caches it.
Bounds selected_bounds(const Session& session);
/// Hides or shows a row of the outline with all its contents.
void toggle_hidden(Session& session, std::uint32_t row);
bool is_hidden(const Session& session, std::uint32_t row);
void show_only_light(Session& session, std::optional<std::uint32_t> light);
void say(Session& session, std::string text, bool bad = false);

/// Opens the readout of a pixel, given by fractions of the picture's width and height, or closes
/// it.
void read_pixel(Session& session, const std::optional<glm::dvec2>& at);
/// Finds the pixel of the readout in the current pictures, and its values.
void locate_pixel(Session& session);
/// Call after any change of the pictures or how they are drawn, except of the camera.
void forget_cause(Session& session);
/// The row of the object or light that a line of the readout names: "root/#2 (line 29)".
std::optional<std::uint32_t> row_named_in(const Session& session, std::string_view line);
/// Why mine differs, or that it is not known yet.
std::string cause_text(const Session& session);
/// The readout as text for copying: values, terms and cause, as far as they are known.
std::string readout_text(const Session& session);

/// The comparison needs a picture from OpenGL, because the ray tracer does not provide one. The
/// window should then draw one of the size of picture_size() and pass it to compare_ours().
bool wants_picture(const Session& session);
void compare_ours(Session& session, Texture ours);

/// The pictures that can be compared with each other. Of different sizes, that of mine counts.
std::vector<Sides> possible_sides(const Session& session);
/// The ones that are compared; equal: there are none.
Sides sides_of(const Session& session);
/// Whether they can be compared now: the camera is the scene's own.
bool is_comparable(const Session& session);
/// The file's picture of this role; null: there is none, or it is ours.
const OtherPicture* picture_of(const Session& session, Role role);
/// "mine: b.png".
std::string role_name(const Session& session, Role role);
/// Exchanges reference and mine, one of which may not exist.
void exchange_roles(Session& session);
/// The role of the picture at the place of ours: that of the left one, if two are compared.
Role role_in_front(const Session& session);
/// Of our picture: that of mine or the reference; else as large as the window shows it.
glm::ivec2 picture_size(const Session& session);

/// Sets the places of the pictures in the available space.
void place_pictures(Session& session, const Box& room);
/// The box of the whole picture, of which the box `view` shows the visible part.
Box whole_picture(const Session& session, const Box& view);
/// Converts a place in the window to one in the pictures, in fractions of their size.
glm::dvec2 place_in_picture(const Session& session, const glm::dvec2& at);
/// Shows a `factor` times smaller part, with `at` where it is now.
void zoom_picture(Session& session, double factor, const glm::dvec2& at);
/// Moves what is visible by fractions of the picture.
void scroll_picture(Session& session, const glm::dvec2& by);
/// Looks at another pixel, and keeps it visible: the next one in this direction, or farther if
/// neither magnifier nor values show single pixels.
void look_beside(Session& session, const glm::ivec2& direction);

/// The values of a picture.
struct PixelSource {
  const Texture* bytes = nullptr;  ///< null: there is none
  const Image* linear = nullptr;   ///< null: only 8-bit values are known

  glm::ivec2 size() const {
    return bytes == nullptr ? glm::ivec2(0) : glm::ivec2(bytes->width, bytes->height);
  }
  glm::ivec2 pixel_at(const glm::dvec2& place) const {
    return glm::clamp(glm::ivec2(glm::floor(place * glm::dvec2(size()))), glm::ivec2(0),
                      glm::max(size() - 1, 0));
  }
};
PixelSource pixels_of(const Session& session, Role role);
/// Three numbers: from 0 to 255, or with Settings::linear_values from 0 to 1; these may be larger.
std::array<std::string, 3> value_texts(const Session& session, const PixelSource& source,
                                       const glm::ivec2& pixel);
/// From so many pixels of the window on, a pixel of the picture shows its values.
inline constexpr double pixels_for_values = 36;
/// How large a pixel of the picture is in the window.
double pixel_width(const Session& session, const PixelSource& source);
/// Whether keys and mouse are those of the assignment Realtime.
bool uses_assignment_keys(const Session& session);
/// The box of the camera's view in the window, and its aspect ratio, which differs from that of the
/// picture in the assignment Realtime.
struct CameraView {
  Box box;
  double aspect = 1;
};
CameraView camera_view(const Session& session);
/// The ray through a place in the window.
Ray ray_in_window(const Session& session, const glm::dvec2& at);
/// Where a point of the world is in the window; nullopt: not in front of the camera.
std::optional<glm::dvec2> point_in_window(const Session& session, const glm::dvec3& point);
/// Whether the picture is traced, once the camera rests.
bool wants_trace(const Session& session);
/// Whether the picture is path traced: always, not only when the camera rests.
bool traces_paths(const Session& session);
/// Whether the ray tracer's or path tracer's picture is visible.
bool shows_traced(const Session& session);
/// Whether OpenGL must draw the picture. Not in mode path, whose first picture is ready as soon.
bool needs_drawing(const Session& session);
/// Whether nothing moves, so that longer work may start.
bool at_rest(const Session& session);
/// The options for the ray tracer or path tracer, with the picture's size.
RenderOptions trace_options(const Session& session);
/// The options for drawing with OpenGL.
DrawOptions draw_options(const Session& session);

/// Texts for the title and the status line: the requested scene, and the visible one.
std::string scene_name(const Session& session);
std::string shown_name(const Session& session);
std::string mode_text(const Session& session);

}  // namespace scenefile::viewer
