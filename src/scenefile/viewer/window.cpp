#include "scenefile/viewer/window.h"

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/memory.h"
#include "scenefile/viewer/canvas.h"
#include "scenefile/viewer/frame_log.h"
#include "scenefile/viewer/gui.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <memory>
#include <utility>

namespace scenefile::viewer {

namespace {

// ImGui needs a few frames to settle after an event.
constexpr int frames_after_event = 3;

struct NamedKey {
  int code;
  const char* name;
};
constexpr std::array named_keys{
    NamedKey{GLFW_KEY_HOME, "Home"},
    NamedKey{GLFW_KEY_ESCAPE, "Escape"},
    NamedKey{GLFW_KEY_ENTER, "Enter"},
    NamedKey{GLFW_KEY_KP_ENTER, "Enter"},
    NamedKey{GLFW_KEY_DELETE, "Delete"},
    NamedKey{GLFW_KEY_INSERT, "Insert"},
    NamedKey{GLFW_KEY_UP, "Up"},
    NamedKey{GLFW_KEY_DOWN, "Down"},
    NamedKey{GLFW_KEY_LEFT, "Left"},
    NamedKey{GLFW_KEY_RIGHT, "Right"},
    NamedKey{GLFW_KEY_TAB, "Tab"},
    NamedKey{GLFW_KEY_PAGE_UP, "Page Up"},
    NamedKey{GLFW_KEY_PAGE_DOWN, "Page Down"},
    NamedKey{GLFW_KEY_EQUAL, "+"},
    NamedKey{GLFW_KEY_KP_ADD, "+"},
    NamedKey{GLFW_KEY_KP_SUBTRACT, "-"},
    NamedKey{GLFW_KEY_SPACE, "Space"},
    NamedKey{GLFW_KEY_LEFT_CONTROL, "Control"},
    NamedKey{GLFW_KEY_RIGHT_CONTROL, "Control"},
    NamedKey{GLFW_KEY_LEFT_SHIFT, "Shift"},
    NamedKey{GLFW_KEY_RIGHT_SHIFT, "Shift"},
};

// Letters by the character on the key, for other keyboard layouts.
std::string key_name(int key, int scancode) {
  const auto found = std::find_if(named_keys.begin(), named_keys.end(),
                                  [&](const NamedKey& named) { return named.code == key; });
  if (found != named_keys.end()) {
    return found->name;
  }
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) {
    return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  }
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
    return std::string(1, static_cast<char>('0' + key - GLFW_KEY_0));
  }
  const char* const name = glfwGetKeyName(key, scancode);
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') {
    return {};
  }
  return std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
}

KeyPress key_press(int key, int scancode, int modifiers) {
  KeyPress press{key_name(key, scancode), (modifiers & GLFW_MOD_CONTROL) != 0,
                 (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_ALT) != 0};
  if (press.shift && press.name == "/") {
    press = {"?", press.control};
  } else if (press.name == "+") {
    press.shift = false;
  }
  return press;
}

thread_local std::string last_glfw_error;

void remember_error(int /*code*/, const char* text) {
  last_glfw_error = text;
}

// Pixels per pixel of a normal-density screen.
double screen_density(GLFWwindow* window) {
  float density = 1;
  glfwGetWindowContentScale(window, &density, nullptr);
  return density > 0 ? static_cast<double>(density) : 1;
}

/// GLFW, ImGui and the canvas, from opening to closing the window.
class Window {
 public:
  explicit Window(const WindowOptions& options) : options_(options) {}
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  WindowResult open();
  WindowResult run();

 private:
  bool create_window();
  Result<std::unique_ptr<ScenePainter>> create_painter();
  void start_fonts(double scale);
  void create_gui();
  void install_callbacks();
  void open_files();

  // Input from the user or the script.
  void pass_key(int key, int scancode, int action, int modifiers);
  void release_keys();
  bool types_in_field() const;
  void on_key(const KeyPress& key, bool down);
  void do_shortcuts();
  void on_pointer(const glm::dvec2& at);
  void on_button(int button, bool down, const KeyPress& with);
  void on_wheel(double steps, bool into_picture);
  void stir() { frames_due_ = frames_after_event; }

  bool scripted() const { return !options_.script.steps.empty(); }
  bool do_step();
  bool do_step(const ScriptStep& step);
  void script_key(const KeyPress& key, bool down);
  bool copy_file(const ScriptStep& step);

  void wait();
  void follow_session();
  void draw_frame(bool best);
  void begin_gui_frame();
  GuiFrame gui_frame() const;
  bool write_screenshot(const std::string& path);
  void remember_settings();

  static Window& of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
  }

  const WindowOptions& options_;
  std::atomic<bool> awake_{false};  // whether GLFW can be woken
  std::shared_ptr<void> glfw_;      // ends after the session's threads, which wake the window
  Session session_;
  GLFWwindow* window_ = nullptr;
  GLFWwindow* painter_window_ = nullptr;  // never shown; for the context of the painter
  bool gui_ready_ = false;
  std::unique_ptr<Canvas> canvas_;
  const std::unique_ptr<ImFontAtlas> fonts_ = std::make_unique<ImFontAtlas>();
  Background<std::string> building_fonts_;  // while the window is being created
  double fonts_scale_ = 0;
  double gui_scale_ = 0;
  glm::ivec2 framebuffer_{1};
  int frames_due_ = frames_after_event;
  double frame_seconds_ = 0;
  bool full_screen_ = false;
  std::array<int, 4> windowed_{};  // position and size before full screen
  std::size_t step_ = 0;
  int step_frames_ = 0;
  std::uint64_t step_looks_ = 0;  // Session::looks when the step began
  std::array<bool, 3> buttons_{};
  std::vector<int> pressed_keys_;                  // since the last frame
  std::vector<std::array<int, 3>> released_keys_;  // of these: key, scancode, modifiers
  std::vector<KeyPress> shortcuts_;                // see do_shortcuts()
  glm::dvec2 pointer_{-1};
  std::string clipboard_;  // what was copied last
  FrameLog log_;           // of scripts
  std::string failure_;
};

Window::~Window() {
  canvas_.reset();
  if (gui_ready_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  for (GLFWwindow* const window : {painter_window_, window_}) {
    if (window != nullptr) {
      glfwDestroyWindow(window);
    }
  }
}

bool Window::create_window() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_VISIBLE, options_.hidden ? GLFW_FALSE : GLFW_TRUE);
  const Settings& settings = session_.settings;
  window_ = glfwCreateWindow(settings.window_width, settings.window_height, "scenefile", nullptr,
                             nullptr);
  return window_ != nullptr;
}

Result<std::unique_ptr<ScenePainter>> Window::create_painter() {
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  painter_window_ = glfwCreateWindow(16, 16, "scenefile", nullptr, nullptr);
  if (painter_window_ == nullptr) {
    return Error{"cannot create a second OpenGL context: " + last_glfw_error};
  }
  const auto begin = [window = painter_window_]() -> Result<GetProcAddress> {
    glfwMakeContextCurrent(window);
    if (glfwGetCurrentContext() != window) {
      return Error{"cannot use the OpenGL context: " + last_glfw_error};
    }
    return glfwGetProcAddress;
  };
  return ScenePainter::create(own_threads({begin, [] { glfwMakeContextCurrent(nullptr); }}),
                              glfwPostEmptyEvent);
}

void Window::start_fonts(double scale) {
  fonts_scale_ = scale;
  building_fonts_.start([scale, &fonts = *fonts_] { return build_fonts(fonts, scale); });
}

void Window::create_gui() {
  if (const std::string note = building_fonts_.take(true).value_or(""); !note.empty()) {
    say(session_, note, true);
  }
  IMGUI_CHECKVERSION();
  ImGui::CreateContext(fonts_.get());
  ImGui::GetIO().IniFilename = nullptr;  // the window keeps its own settings
  ImGui::GetIO().ConfigDragClickToInputText = true;
  install_callbacks();
  ImGui_ImplGlfw_InitForOpenGL(window_, false);
  ImGui_ImplOpenGL3_Init("#version 410 core");
  gui_ready_ = true;
}

// The scene is read, fonts are prepared and shaders compiled by other threads, while this one waits
// for the display.
WindowResult Window::open() {
  std::string note;
  session_.settings = load_settings(options_.settings, note);
  if (options_.size) {
    session_.settings.window_width = options_.size->x;
    session_.settings.window_height = options_.size->y;
  }
  session_.settings.ray_tracing = options_.ray_tracing.value_or(session_.settings.ray_tracing);
  session_.setup = options_.setup;
  session_.realtime = options_.setup.realtime.has_value();
  session_.realtime_panel = options_.setup.realtime.value_or(RealtimeOptions());
  session_.setup.wake = [this] {
    if (awake_) {
      glfwPostEmptyEvent();
    }
  };
  if (!note.empty()) {
    say(session_, note, true);
  }
  open_files();
  glfwSetErrorCallback(remember_error);
  if (glfwInit() != GLFW_TRUE) {
    return {WindowStatus::no_display, "no window can be opened: " + last_glfw_error};
  }
  glfw_ = std::shared_ptr<void>(nullptr, [](void*) { glfwTerminate(); });
  awake_ = true;
  if (!create_window()) {
    return {WindowStatus::failed, "no window with OpenGL 4.1 can be opened: " + last_glfw_error};
  }
  start_fonts(screen_density(window_) * session_.settings.text_scale);
  glfwSetWindowUserPointer(window_, this);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(scripted() ? 0 : 1);
  Result<std::unique_ptr<ScenePainter>> painter = create_painter();
  if (!painter) {
    return {WindowStatus::failed, painter.error().text};
  }
  canvas_ = std::make_unique<Canvas>(*std::move(painter));
  canvas_->warm_up(session_);
  create_gui();
  return {};
}

void Window::open_files() {
  if (!options_.reference.empty()) {
    open_picture(session_, options_.reference, Role::reference);
  }
  if (!options_.mine.empty()) {
    open_picture(session_, options_.mine, Role::mine);
  }
  if (!options_.picture.empty()) {
    open_picture(session_, options_.picture);
  }
  if (options_.scene.empty()) {
    open_start_panel(session_);
  } else if (options_.scene != "-" && !stamp_of(options_.scene).exists) {
    new_scene(session_, options_.scene);
  } else {
    open_scene(session_, options_.scene);
  }
}

void Window::install_callbacks() {
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    of(w).pass_key(key, scancode, action, modifiers);
    const bool arrow = key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP;  // repeats
    if (action != GLFW_REPEAT || arrow) {
      of(w).on_key(key_press(key, scancode, modifiers), action != GLFW_RELEASE);
    }
  });
  glfwSetCharCallback(window_, ImGui_ImplGlfw_CharCallback);
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w).on_pointer({x, y});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
    ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
    of(w).on_button(button, action == GLFW_PRESS, key_press(0, 0, modifiers));
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    ImGui_ImplGlfw_ScrollCallback(w, x, y);
    of(w).on_wheel(y, ImGui::GetIO().KeyCtrl);
  });
  glfwSetCursorEnterCallback(window_, ImGui_ImplGlfw_CursorEnterCallback);
  glfwSetWindowFocusCallback(window_, ImGui_ImplGlfw_WindowFocusCallback);
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    of(w).stir();
    drop(of(w).session_, {paths, paths + count});
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).stir(); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { of(w).stir(); });
}

// Older versions of ImGui only look at which keys are down when a frame begins: a key that is
// pressed and released between two frames must stay down until then.
void Window::pass_key(int key, int scancode, int action, int modifiers) {
  // In the lists of this version of ImGui only Space chooses.
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
    if (action == GLFW_RELEASE) {
      pass_key(GLFW_KEY_SPACE, 0, action, modifiers);
    } else if (!ImGui::GetIO().WantTextInput && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
      key = GLFW_KEY_SPACE;
    }
  }
  const bool pressed =
      std::find(pressed_keys_.begin(), pressed_keys_.end(), key) != pressed_keys_.end();
  if (action == GLFW_RELEASE && pressed) {
    released_keys_.push_back({key, scancode, modifiers});
    return;
  }
  if (action == GLFW_PRESS) {
    pressed_keys_.push_back(key);
  }
  ImGui_ImplGlfw_KeyCallback(window_, key, scancode, action, modifiers);
}

// After a frame.
void Window::release_keys() {
  pressed_keys_.clear();
  for (const auto& [key, scancode, modifiers] : std::exchange(released_keys_, {})) {
    ImGui_ImplGlfw_KeyCallback(window_, key, scancode, GLFW_RELEASE, modifiers);
    stir();
  }
}

// Closes all popups, or only the innermost: a menu with its submenus.
void close_popups(bool all) {
  const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
  int level = all ? 0 : open.Size - 1;
  while (level > 0 && open[level].Window != nullptr &&
         (open[level].Window->Flags & ImGuiWindowFlags_ChildMenu) != 0) {
    --level;
  }
  if (open.Size > 0) {
    ImGui::ClosePopupToLevel(level, true);
  }
}

// Of the object's fields, not of a question, the palette or the panel that opens scenes.
bool Window::types_in_field() const {
  return ImGui::GetIO().WantTextInput && !session_.question && !session_.palette &&
         !session_.start.open;
}

// Who gets a key: a question; a field in which text is typed, an open list, the fields of the
// selection, if they have the keyboard, and the panel that opens files; otherwise the window. Keys
// with Ctrl are always the window's, except for those that typing needs, and so are Insert and F1
// to F12.
void Window::on_key(const KeyPress& key, bool down) {
  stir();
  if (!down) {
    key_released(session_, key.name);
    return;
  }
  const bool typing = ImGui::GetIO().WantTextInput;
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (key.name == "Escape") {
    ImGui::ClearActiveID();
    if (types_in_field()) {
      cancel_edit(session_);
    } else if (popup && !session_.question) {
      close_popups(false);
    } else {
      key_pressed(session_, key);
    }
    return;
  }
  constexpr std::array<std::string_view, 4> for_typing{"C", "Z", "Left", "Right"};
  const bool types =
      typing && std::find(for_typing.begin(), for_typing.end(), key.name) != for_typing.end();
  const bool is_function = key.name.size() > 1 && key.name[0] == 'F';
  const bool of_window = key.control ? !types : is_function || key.name == "Insert";
  if (session_.question ||
      !(typing || popup || session_.keyboard_in_fields || session_.start.open)) {
    key_pressed(session_, key);
  } else if (of_window && action_of(key) != nullptr) {
    if (types_in_field()) {
      pass_key(GLFW_KEY_ENTER, 0, GLFW_PRESS, 0);  // the field takes over what was typed
      pass_key(GLFW_KEY_ENTER, 0, GLFW_RELEASE, 0);
    }
    shortcuts_.push_back(key);
  } else if (session_.keyboard_in_fields && !typing && !popup &&
             (key.name.size() == 1 || key.name == "Delete")) {
    say(session_, "the keyboard is in the fields: Escape leaves them");
  }
}

// After a frame, in which fields have taken over what was typed.
void Window::do_shortcuts() {
  for (const KeyPress& key : std::exchange(shortcuts_, {})) {
    close_popups(true);
    key_pressed(session_, key);
    stir();
  }
}

void Window::on_pointer(const glm::dvec2& at) {
  stir();
  pointer_ = at;
  pointer_moved(session_, at);
}

void Window::on_button(int button, bool down, const KeyPress& with) {
  stir();
  if (button > 2) {
    return;
  }
  buttons_[static_cast<std::size_t>(button)] = down;
  if (!down) {
    pointer_released(session_);
    return;
  }
  session_.keyboard_in_fields = false;  // also after a click in a panel
  if (!ImGui::GetIO().WantCaptureMouse) {
    pointer_pressed(session_, button, with);
  }
}

void Window::on_wheel(double steps, bool into_picture) {
  stir();
  if (!ImGui::GetIO().WantCaptureMouse) {
    wheel_turned(session_, steps, into_picture);
  }
}

// Replaces a file like an editor that renames a new one into place.
bool Window::copy_file(const ScriptStep& step) {
  const Result<std::string> bytes = read_file(step.text, options_.setup.read.limits.file_bytes);
  failure_ = bytes ? error_text(write_file(step.other, *bytes)) : bytes.error().text;
  return failure_.empty();
}

// ImGui only needs the keys with a name.
void Window::script_key(const KeyPress& key, bool down) {
  const auto named = std::find_if(named_keys.begin(), named_keys.end(),
                                  [&](const NamedKey& n) { return n.name == key.name; });
  if (named != named_keys.end()) {
    const int with = (key.control ? GLFW_MOD_CONTROL : 0) | (key.shift ? GLFW_MOD_SHIFT : 0);
    pass_key(named->code, 0, down ? GLFW_PRESS : GLFW_RELEASE, with);
  }
  on_key(key, down);
}

// Returns true if the step is done.
bool Window::do_step(const ScriptStep& step) {
  constexpr std::uint64_t looks_for_change = 2;  // see FileWatch::changed()
  switch (step.kind) {
    case StepKind::key:
      script_key(parse_key(step.text), true);
      script_key(parse_key(step.text), false);
      return true;
    case StepKind::hold:
      script_key(parse_key(step.text), true);
      if (step_frames_ >= step.number) {
        script_key(parse_key(step.text), false);
      }
      return step_frames_ >= step.number;
    case StepKind::move:
      on_pointer({step.x, step.y});
      return true;
    case StepKind::press:
    case StepKind::release:
      on_button(step.number, step.kind == StepKind::press, {});
      return true;
    case StepKind::wheel:
      on_wheel(step.y, false);
      return true;
    case StepKind::drop:
      drop(session_, {step.text});
      return true;
    case StepKind::frames:
      return step_frames_ >= step.number;
    case StepKind::settle:
      return step_frames_ > frames_after_event &&
             session_.looks - step_looks_ >= looks_for_change && settled(session_) &&
             canvas_->settled(session_);
    case StepKind::screenshot:
      draw_frame(true);
      write_screenshot(step.text);
      return true;
    case StepKind::copy:
      return copy_file(step);
    case StepKind::copied:
      failure_ = error_text(write_file(step.text, clipboard_));
      return true;
    case StepKind::times:
      failure_ = error_text(write_file(step.text, log_.text()));
      return true;
    case StepKind::quit:
      session_.quit = true;
      return true;
  }
  return true;
}

// Does one step per frame. Returns false if the script has ended or failed.
bool Window::do_step() {
  const std::vector<ScriptStep>& steps = options_.script.steps;
  if (step_ >= steps.size()) {
    return false;
  }
  const ScriptStep& step = steps[step_];
  const bool done = do_step(step);
  if (!failure_.empty() && step.line != 0) {
    failure_ = fmt::format("the script, line {}: {}", step.line, failure_);
  }
  if (done) {
    ++step_;
    step_frames_ = 0;
    step_looks_ = session_.looks;
  } else {
    ++step_frames_;
  }
  stir();
  return failure_.empty();
}

void Window::wait() {
  if (scripted() || frames_due_ > 0) {
    glfwPollEvents();
  } else {
    glfwWaitEventsTimeout(next_tick(session_));
  }
}

// Only the window changes the title and full screen.
void Window::follow_session() {
  const std::string name = (has_unsaved_edits(session_) ? "\u2022 " : "") + scene_name(session_);
  glfwSetWindowTitle(window_, name.empty() ? "scenefile" : (name + " - scenefile").c_str());
  if (session_.full_screen == full_screen_) {
    return;
  }
  full_screen_ = session_.full_screen;
  if (full_screen_) {
    glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
    glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else {
    glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3],
                         0);
  }
}

void Window::begin_gui_frame() {
  const double scale = screen_density(window_) * session_.settings.text_scale;
  if (scale != gui_scale_) {
    gui_scale_ = scale;
    set_gui_style(scale);
    if (scale != fonts_scale_) {
      fonts_scale_ = scale;
      build_fonts(*fonts_, scale);
      ImGui_ImplOpenGL3_DestroyFontsTexture();
      ImGui_ImplOpenGL3_CreateFontsTexture();
    }
  }
  int& flags = ImGui::GetIO().ConfigFlags;
  flags = session_.keyboard_in_fields ? flags | ImGuiConfigFlags_NavEnableKeyboard
                                      : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  if (scripted()) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(pointer_.x), static_cast<float>(pointer_.y)};
    std::copy(buttons_.begin(), buttons_.end(), io.MouseDown);
    io.DeltaTime = 1.0F / 60;
  }
  ImGui::NewFrame();
}

GuiFrame Window::gui_frame() const {
  GuiFrame frame;
  frame.scale = gui_scale_;
  frame.frame_seconds = frame_seconds_;
  frame.memory = memory_in_use();
  canvas_->describe(frame);
  return frame;
}

void Window::draw_frame(bool best) {
  const double start = glfwGetTime();
  glm::ivec2 size(1);
  glfwGetWindowSize(window_, &size.x, &size.y);
  glfwGetFramebufferSize(window_, &framebuffer_.x, &framebuffer_.y);
  if (best) {
    canvas_->finish(session_);  // so that the panels have its figures
  }
  if (!canvas_->update(session_, best)) {
    stir();
  }
  begin_gui_frame();
  build_gui(session_, gui_frame(), glm::max(size, glm::ivec2(1)));
  ImGui::Render();
  const double scale = static_cast<double>(framebuffer_.x) / std::max(size.x, 1);
  set_pixels(session_, glm::ivec2(glm::round(session_.picture.size * scale)));
  if (best) {
    canvas_->finish(session_);
  } else if (needs_drawing(session_)) {
    canvas_->draw(session_);
  }
  clear_window(framebuffer_.x, framebuffer_.y, 0.09F, 0.094F, 0.106F);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (!best) {
    glfwSwapBuffers(window_);
    frame_seconds_ = glfwGetTime() - start;
  }
}

bool Window::write_screenshot(const std::string& path) {
  const Texture picture = read_window(framebuffer_.x, framebuffer_.y);
  const Result<std::string> bytes =
      encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest);
  const std::string error = bytes ? error_text(write_file(path, *bytes)) : bytes.error().text;
  if (!error.empty()) {
    say(session_, error, true);
    failure_ = scripted() ? error : "";
    return false;
  }
  return true;
}

void Window::remember_settings() {
  Settings settings = session_.settings;
  if (!full_screen_) {
    // On a high-density screen, the window opens larger accordingly.
    glm::ivec2 pixels(0);
    glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
    const glm::dvec2 size = glm::dvec2(pixels) / screen_density(window_);
    settings.window_width = static_cast<int>(std::lround(size.x));
    settings.window_height = static_cast<int>(std::lround(size.y));
  }
  if (!scripted()) {
    save_settings(options_.settings, settings);
  }
}

WindowResult Window::run() {
  while (!session_.quit) {
    wait();
    if (glfwWindowShouldClose(window_) == GLFW_TRUE) {
      glfwSetWindowShouldClose(window_, GLFW_FALSE);
      perform(session_, Action::quit);
    }
    log_.begin();
    const bool painted = canvas_->take(session_);
    const bool refine = frames_due_ == 0 && !canvas_->busy() && !canvas_->settled(session_);
    if (tick(session_, glfwGetTime()) || painted || refine) {
      stir();
    }
    if (scripted() && !do_step()) {
      break;
    }
    if (wants_picture(session_)) {
      canvas_->ask_to_compare(session_);
    }
    if (std::optional<Texture> ours = canvas_->take_to_compare(session_)) {
      compare_ours(session_, *std::move(ours));
    }
    if (frames_due_ > 0) {
      --frames_due_;
      draw_frame(false);
      follow_session();
      release_keys();
      do_shortcuts();
    }
    if (!session_.copied.empty()) {
      clipboard_ = std::exchange(session_.copied, {});
      glfwSetClipboardString(window_, clipboard_.c_str());
    }
    if (!session_.screenshot.empty()) {
      const std::string path = std::exchange(session_.screenshot, {});
      draw_frame(true);
      if (write_screenshot(path)) {
        say(session_, "written: " + absolute_path(path));
      }
      stir();
    }
    if (scripted()) {
      log_.end(!session_.drawn.empty() || session_.traced,
               session_.traced && session_.traced->complete);
    }
  }
  remember_settings();
  WindowResult result;
  result.shown = session_.path.empty() || (session_.shown != nullptr && session_.broken == nullptr);
  if (!failure_.empty()) {
    result.status = WindowStatus::failed;
    result.error = failure_;
  }
  return result;
}

}  // namespace

WindowResult run_window(const WindowOptions& options) {
  Window window(options);
  WindowResult result = window.open();
  if (result.status == WindowStatus::closed) {
    return window.run();
  }
  if (options.failed) {
    options.failed(result);
  }
  return result;
}

}  // namespace scenefile::viewer
