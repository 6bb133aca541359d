#pragma once
// The scene behind its Python object, and references from its parts.

#include "scenefile/verbs/load_file.h"
#include "values.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::python {

/// A scene that can be edited, and what was last derived from it. Its parts in Python share it.
/// Derived data is never changed, only replaced, so that other threads can keep using it without
/// the interpreter's lock.
struct SceneState {
  std::string path;  ///< as given; for a scene in memory a name in its folder, or "-"
  LoadSettings settings;
  AssetAccess access;
  Scene scene;
  std::shared_ptr<const LoadedScene> loaded;  ///< null: `scene` is another since
  std::uint64_t edits = 0;
  std::uint32_t removals = 0;  ///< how often a part was taken away, which moves the others
};
using SharedState = std::shared_ptr<SceneState>;

/// The current scene: checked, prepared, with its files and all findings. Releases the
/// interpreter's lock while loading.
std::shared_ptr<const LoadedScene> look_at(SceneState& state);

/// The same, for work that needs a usable scene; raises SceneError or OSError if it is not.
std::shared_ptr<const LoadedScene> usable(SceneState& state);

/// From now on, the materials of mesh faces are read even if the scene has lights.
void read_materials(SceneState& state);

/// Raises SceneError, or OSError if the file cannot be read.
[[noreturn]] void raise_unusable(const LoadedScene& scene);
[[noreturn]] void raise_error(const Error& error);
/// Raises ValueError if an output would replace an input or another output (io/used_files.h).
void refuse_replacing(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs);

/// A reference to a part of a scene. Every edit goes through edit().
struct Part {
  SharedState state;
  NodeId node = 0;
  std::uint32_t index = 0;  ///< among the primitives or lights of the node
  std::uint32_t removals = 0;

  bool operator==(const Part& other) const {
    return state == other.state && node == other.node && index == other.index;
  }
};

struct NodePart : Part {
  Node& get() const;
};
struct LightPart : Part {
  Light& get() const;
};
struct PrimitivePart : Part {
  Primitive& get() const;
};
struct MaterialPart : Part {
  Material& get() const;
};
struct CameraPart : Part {
  Camera& get() const;  ///< of a scene without one: a default camera, which becomes the scene's
};
struct GlobalsPart : Part {
  Global& get() const;
};

/// Returns a part for changing; discards what was derived from the scene.
template <typename SomePart>
auto& edit(const SomePart& part) {
  part.state->loaded.reset();
  ++part.state->edits;
  return part.get();
}

void bind_findings(py::module_& m);
void bind_scene(py::module_& m);
void bind_pictures(py::module_& m);
void bind_comparisons(py::module_& m);

}  // namespace scenefile::python
