#include "state.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, m) {
  using namespace scenefile::python;
  m.attr("__version__") = SCENEFILE_VERSION;
  py::class_<SceneState, SharedState>(m, "Scene", "A scene that can be edited and drawn.");
  bind_findings(m);
  bind_scene(m);
  bind_pictures(m);
  bind_comparisons(m);
}
