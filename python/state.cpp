#include "state.h"

#include "scenefile/base/report.h"
#include "scenefile/verbs/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <utility>

namespace scenefile::python {

py::module_ base_module() {
  // Not a static object: its destructor would run after the interpreter has ended.
  static PyObject* const module = py::module_::import("scenefile._base").release().ptr();
  return py::reinterpret_borrow<py::module_>(module);
}

double shown(float value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double result = 0;
  const auto read = std::from_chars(text, written.ptr, result);
  return read.ec == std::errc() ? result : static_cast<double>(value);
}

std::size_t index_of_word(const char* what, std::string_view word, const std::string_view* words,
                          std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (words[i] == word) {
      return i;
    }
  }
  throw py::value_error(fmt::format("{}: \"{}\" is not one of {}", what, word,
                                    fmt::join(std::span(words, count), ", ")));
}

std::shared_ptr<const LoadedScene> look_at(SceneState& state) {
  if (state.loaded) {
    return state.loaded;
  }
  const std::uint64_t edits = state.edits;
  auto next = std::make_shared<LoadedScene>();
  next->path = state.path;
  next->written = state.scene;
  next->diagnostics = Diagnostics(state.settings.limits);
  const LoadSettings settings = state.settings;
  const AssetAccess access = state.access;
  {
    const py::gil_scoped_release release;
    load_written_file(*next, settings, access);
  }
  if (state.edits == edits) {
    state.loaded = next;
  }
  return next;
}

std::shared_ptr<const LoadedScene> usable(SceneState& state) {
  std::shared_ptr<const LoadedScene> loaded = look_at(state);
  if (!loaded->usable()) {
    raise_unusable(*loaded);
  }
  return loaded;
}

void read_materials(SceneState& state) {
  if (!state.settings.materials) {
    state.settings.materials = true;
    state.loaded.reset();
    ++state.edits;
  }
}

void raise_unusable(const LoadedScene& scene) {
  if (scene.unreadable) {
    raise_error(*scene.unreadable);
  }
  std::string text = findings_text(scene);
  while (text.ends_with('\n')) {
    text.pop_back();
  }
  py::list diagnostics;
  for (const Diagnostic* const d : by_place(scene.diagnostics)) {
    diagnostics.append(*d);
  }
  const py::object type = base_module().attr("SceneError");
  PyErr_SetObject(type.ptr(), type(text, diagnostics).ptr());
  throw py::error_already_set();
}

void raise_error(const Error& error) {
  PyObject* type = PyExc_OSError;
  switch (error.kind) {
    case ErrorKind::environment:
      type = PyExc_OSError;
      break;
    case ErrorKind::limit:
      type = PyExc_MemoryError;
      break;
    case ErrorKind::input:
    case ErrorKind::usage:
      type = PyExc_ValueError;
      break;
    case ErrorKind::cancelled:
      type = PyExc_InterruptedError;
      break;
  }
  PyErr_SetString(type, error.text.c_str());
  throw py::error_already_set();
}

void refuse_replacing(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs) {
  UsedFiles files;
  Result<void> added;
  for (const UsedFile& input : inputs) {
    added = added ? files.read(input) : added;
  }
  for (const UsedFile& output : outputs) {
    added = added ? files.write(output) : added;
  }
  if (!added) {
    raise_error(added.error());
  }
}

namespace {

// The list of primitives or lights of the part's node.
template <typename Parts>
auto& part_at(const Part& part, Parts& parts) {
  if (part.removals != part.state->removals || part.index >= parts.size()) {
    throw std::runtime_error(
        "a part of the scene was removed after this one was looked up: look it up again");
  }
  return parts[part.index];
}

}  // namespace

Node& NodePart::get() const {
  return state->scene.nodes.at(node);
}
Light& LightPart::get() const {
  return part_at(*this, state->scene.nodes.at(node).lights);
}
Primitive& PrimitivePart::get() const {
  return part_at(*this, state->scene.nodes.at(node).primitives);
}
Material& MaterialPart::get() const {
  return part_at(*this, state->scene.nodes.at(node).primitives).material;
}
Camera& CameraPart::get() const {
  std::optional<Camera>& camera = state->scene.camera;
  return camera ? *camera : camera.emplace();
}
Global& GlobalsPart::get() const {
  return state->scene.global;
}

}  // namespace scenefile::python
