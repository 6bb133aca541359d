#include "scenefile/view/headless.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string_view>

namespace scenefile {

namespace {

#define SCENEFILE_EGL_FUNCTIONS(ROW) \
  ROW(BindAPI)                       \
  ROW(ChooseConfig)                  \
  ROW(CreateContext)                 \
  ROW(DestroyContext)                \
  ROW(GetDisplay)                    \
  ROW(GetPlatformDisplay)            \
  ROW(GetProcAddress)                \
  ROW(Initialize)                    \
  ROW(MakeCurrent)                   \
  ROW(QueryString)                   \
  ROW(Terminate)

/// The library is loaded on demand, because most programs never draw.
struct Egl {
#define ROW(name) decltype(&egl##name) name = nullptr;
  SCENEFILE_EGL_FUNCTIONS(ROW)
#undef ROW
};

// Returns false if the library does not exist. It is never unloaded, because drivers leave threads
// running.
bool load(Egl& egl) {
  void* const library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return false;
  }
#define ROW(name)                                                                 \
  egl.name = reinterpret_cast<decltype(egl.name)>(::dlsym(library, "egl" #name)); \
  if (egl.name == nullptr) {                                                      \
    return false;                                                                 \
  }
  SCENEFILE_EGL_FUNCTIONS(ROW)
#undef ROW
  return true;
}

bool has_extension(const char* list, std::string_view name) {
  std::istringstream words(list == nullptr ? "" : list);
  return std::find(std::istream_iterator<std::string>(words), {}, name) !=
         std::istream_iterator<std::string>();
}

EGLDisplay open_display(const Egl& egl) {
  const char* const extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(extensions, "EGL_MESA_platform_surfaceless")) {
    return egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  if (has_extension(extensions, "EGL_EXT_platform_device") &&
      has_extension(extensions, "EGL_EXT_device_enumeration")) {
    const auto query =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (query != nullptr && query(1, &device, &count) == EGL_TRUE && count > 0) {
      return egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    }
  }
  return egl.GetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext make_context(const Egl& egl, EGLDisplay display) {
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
  // Having no configuration is fine, since no surface is created (EGL_KHR_no_config_context).
  egl.ChooseConfig(display, config_wishes.data(), &config, 1, &count);
  return egl.CreateContext(display, config, EGL_NO_CONTEXT, context_wishes.data());
}

}  // namespace

struct HeadlessContext::State {
  Egl egl;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~State() {
    if (display != EGL_NO_DISPLAY) {
      egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      if (context != EGL_NO_CONTEXT) {
        egl.DestroyContext(display, context);
      }
      egl.Terminate(display);
    }
  }
};

HeadlessContext::HeadlessContext(std::unique_ptr<State> state) : state_(std::move(state)) {}

HeadlessContext::~HeadlessContext() = default;

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  auto state = std::make_unique<State>();
  const Egl& egl = state->egl;
  if (!load(state->egl)) {
    return Error{
        "there is no EGL (libEGL.so.1) to draw with; install Mesa (libegl1, libgl1-mesa-dri)"};
  }
  EGLDisplay display = open_display(egl);
  if (display == EGL_NO_DISPLAY || egl.Initialize(display, nullptr, nullptr) != EGL_TRUE) {
    return Error{"there is no EGL display to draw with; install Mesa (libegl1, libgl1-mesa-dri)"};
  }
  state->display = display;
  if (egl.BindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    return Error{"EGL offers no OpenGL here; install Mesa (libgl1-mesa-dri)"};
  }
  state->context = make_context(egl, display);
  if (state->context == EGL_NO_CONTEXT ||
      egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context) != EGL_TRUE) {
    return Error{"EGL has no OpenGL 4.1 core context without a window"};
  }
  return std::unique_ptr<HeadlessContext>(new HeadlessContext(std::move(state)));
}

GetProcAddress HeadlessContext::get_proc_address() const {
  return state_->egl.GetProcAddress;
}

Result<HeadlessDevice> open_headless_device() {
  Result<std::unique_ptr<HeadlessContext>> context = HeadlessContext::create();
  if (!context) {
    return context.error();
  }
  Result<std::unique_ptr<GlDevice>> device = GlDevice::create((*context)->get_proc_address());
  if (!device) {
    return device.error();
  }
  return HeadlessDevice{*std::move(context), *std::move(device)};
}

}  // namespace scenefile
