#include "scenefile/view/headless.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string_view>

namespace scenefile {

struct HeadlessContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~State() {
    if (display != EGL_NO_DISPLAY) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      if (context != EGL_NO_CONTEXT) {
        eglDestroyContext(display, context);
      }
      eglTerminate(display);
    }
  }
};

namespace {

bool has_extension(const char* list, std::string_view name) {
  std::istringstream words(list == nullptr ? "" : list);
  return std::find(std::istream_iterator<std::string>(words), {}, name) !=
         std::istream_iterator<std::string>();
}

EGLDisplay open_display() {
  const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(extensions, "EGL_MESA_platform_surfaceless")) {
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  if (has_extension(extensions, "EGL_EXT_platform_device") &&
      has_extension(extensions, "EGL_EXT_device_enumeration")) {
    const auto query =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query != nullptr && query(1, &device, &count) == EGL_TRUE && count > 0) {
      return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    }
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext make_context(EGLDisplay display) {
  constexpr std::array<EGLint, 3> config_wishes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> context_wishes{EGL_CONTEXT_MAJOR_VERSION,
                                                 4,
                                                 EGL_CONTEXT_MINOR_VERSION,
                                                 1,
                                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                 EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  // A surface is never made, so no configuration is fine too (EGL_KHR_no_config_context).
  eglChooseConfig(display, config_wishes.data(), &config, 1, &count);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wishes.data());
}

}  // namespace

HeadlessContext::HeadlessContext(std::unique_ptr<State> state) : state_(std::move(state)) {}

HeadlessContext::~HeadlessContext() = default;

std::unique_ptr<HeadlessContext> HeadlessContext::create(std::string& error) {
  auto state = std::make_unique<State>();
  const EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    error = "there is no EGL display to draw with; install Mesa (libegl1, libgl1-mesa-dri)";
    return nullptr;
  }
  state->display = display;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    error = "EGL offers no OpenGL here; install Mesa (libgl1-mesa-dri)";
    return nullptr;
  }
  state->context = make_context(display);
  if (state->context == EGL_NO_CONTEXT ||
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context) != EGL_TRUE) {
    error = "EGL has no OpenGL 4.1 core context without a window";
    return nullptr;
  }
  return std::unique_ptr<HeadlessContext>(new HeadlessContext(std::move(state)));
}

GetProcAddress HeadlessContext::get_proc_address() const {
  return &eglGetProcAddress;
}

}  // namespace scenefile
