#pragma once
// What a scene in Python is, and what its parts hold on to.

#include "scenefile/verbs/load_file.h"
#include "values.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::python {

/// A scene that is being edited, and what was last made of it. Parts in Python share it. What was
/// made is never changed, only replaced, so that threads may go on with it without the
/// interpreter's lock.
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

/// What the scene is now: checked, prepared, with its files; whatever was found. Releases the
/// interpreter's lock while it loads.
std::shared_ptr<const LoadedScene> look_at(SceneState& state);

/// The same, for work that needs a usable scene. Raises SceneError or OSError for any other.
std::shared_ptr<const LoadedScene> usable(SceneState& state);

/// Raises SceneError or OSError, whichever it deserves.
[[noreturn]] void raise_unusable(const LoadedScene& scene);
[[noreturn]] void raise_error(const Error& error);

/// Where a part of a scene is. Every edit goes through edit().
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

/// A part to change: what was made of the scene no longer holds.
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
