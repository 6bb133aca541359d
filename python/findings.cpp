// Diagnostics, reports of them, and reading scenes.

#include "scenefile/verbs/findings.h"

#include "scenefile/base/report.h"
#include "scenefile/io/parallel.h"
#include "scenefile/verbs/codes.h"
#include "scenefile/verbs/scene_json.h"
#include "state.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <utility>
#include <vector>

namespace scenefile::python {

namespace {

using Paths = std::vector<FilePath>;

std::optional<std::uint32_t> known(std::uint32_t place) {
  return place != 0 ? std::optional(place) : std::nullopt;
}

py::tuple list_of(const Diagnostics& diagnostics) {
  py::list list;
  for (const Diagnostic* const d : by_place(diagnostics)) {
    list.append(*d);
  }
  return py::tuple(list);
}

std::string text_of(const Diagnostic& d) {
  std::string place = d.file;
  if (d.location.known()) {
    place += fmt::format("{}{}:{}", place.empty() ? "" : ":", d.location.line, d.location.column);
  }
  return fmt::format("{}{}{}: {} [{}]", place, place.empty() ? "" : ": ", severity_name(d.severity),
                     d.message, d.code->name);
}

struct Report {
  std::shared_ptr<const LoadedScene> scene;
};

std::vector<std::string> known_codes(std::vector<std::string> names) {
  for (const std::string& name : names) {
    if (find_code(name) == nullptr) {
      throw py::value_error(
          fmt::format("\"{}\" is not a code; \"scenefile help codes\" lists them", name));
    }
  }
  return names;
}

SharedState new_state(std::string path, bool compat_course, bool allow_missing, const Paths& roots,
                      bool allow_outside) {
  auto state = std::make_shared<SceneState>();
  state->path = std::move(path);
  state->settings.compat_course = compat_course;
  state->settings.allow_missing = allow_missing;
  state->settings.for_each = [](std::size_t count, const std::function<void(std::size_t)>& work) {
    for_each_index(count, 0, work);
  };
  for (const FilePath& root : roots) {
    state->access.roots.push_back(root.text);
  }
  state->access.allow_outside = allow_outside;
  return state;
}

// Makes the loaded scene the one to edit. Raises an exception if it cannot be used.
SharedState opened(SharedState state, LoadedScene loaded) {
  if (!loaded.usable()) {
    raise_unusable(loaded);
  }
  state->scene = loaded.written;
  state->loaded = std::make_shared<const LoadedScene>(std::move(loaded));
  return state;
}

SharedState read(const FilePath& path, bool compat_course, bool allow_missing,
                 const Paths& asset_roots, bool allow_outside) {
  SharedState state =
      new_state(path.text, compat_course, allow_missing, asset_roots, allow_outside);
  LoadedScene loaded;
  {
    const py::gil_scoped_release release;
    loaded = load_scene_file(state->path, state->settings, state->access);
  }
  return opened(std::move(state), std::move(loaded));
}

std::string name_in(const FilePath& folder) {
  return folder.text + "/scene";
}

SharedState read_text(std::string text, const FilePath& folder, bool compat_course,
                      bool allow_missing, const Paths& asset_roots, bool allow_outside) {
  SharedState state =
      new_state(name_in(folder), compat_course, allow_missing, asset_roots, allow_outside);
  LoadedScene loaded;
  {
    const py::gil_scoped_release release;
    AssetRoots roots(asset_roots_options(state->path, state->access, state->settings.limits));
    const FetchFile fetch = [&](const std::string& name) { return roots.read(name); };
    loaded = load_scene(state->path, std::move(text), fetch, state->settings);
  }
  return opened(std::move(state), std::move(loaded));
}

Report report_of(LoadedScene scene, const FindingPolicy& policy) {
  {
    const py::gil_scoped_release release;
    check_picture(scene);
    apply_policy(policy, scene.diagnostics);
  }
  return {std::make_shared<const LoadedScene>(std::move(scene))};
}

Report check(const FilePath& path, bool strict, bool deny_warnings, std::vector<std::string> deny,
             std::vector<std::string> allow, bool assets, bool compat_course, bool allow_missing,
             const Paths& asset_roots, bool allow_outside) {
  const FindingPolicy policy{strict, deny_warnings, known_codes(std::move(deny)),
                             known_codes(std::move(allow))};
  const SharedState state =
      new_state(path.text, compat_course, allow_missing, asset_roots, allow_outside);
  state->settings.depth = assets ? LoadDepth::with_all_assets : LoadDepth::prepared;
  LoadedScene loaded;
  {
    const py::gil_scoped_release release;
    loaded = load_scene_file(state->path, state->settings, state->access);
  }
  if (loaded.unreadable && loaded.unreadable->kind == ErrorKind::environment) {
    raise_error(*loaded.unreadable);
  }
  return report_of(std::move(loaded), policy);
}

struct CountedMaterial : FaceMaterial {
  std::size_t triangles = 0;
};

py::dict face_materials(SceneState& state) {
  read_materials(state);
  const std::shared_ptr<const LoadedScene> loaded = look_at(state);
  py::dict result;
  for (std::size_t i = 0; i < loaded->assets.mesh_materials.size(); ++i) {
    const MeshMaterials& mesh = loaded->assets.mesh_materials[i];
    const std::vector<std::size_t> triangles = triangles_of_materials(mesh);
    py::list materials;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      materials.append(CountedMaterial{mesh.materials[k], triangles[k]});
    }
    result[py::str(loaded->ready.scene.mesh_files[i].name)] = py::tuple(materials);
  }
  return result;
}

}  // namespace

void bind_findings(py::module_& m) {
  py::class_<Diagnostic>(m, "Diagnostic", "A finding about a scene.")
      .def_property_readonly("code", [](const Diagnostic& d) { return d.code->name; })
      .def_property_readonly("severity",
                             [](const Diagnostic& d) { return severity_name(d.severity); })
      .def_property_readonly("message", [](const Diagnostic& d) { return d.message; })
      .def_property_readonly("file", [](const Diagnostic& d) { return d.file; })
      .def_property_readonly("line", [](const Diagnostic& d) { return known(d.location.line); })
      .def_property_readonly("column", [](const Diagnostic& d) { return known(d.location.column); })
      .def_property_readonly("help", [](const Diagnostic& d) { return d.code->help; })
      .def_property_readonly(
          "correction",
          [](const Diagnostic& d) -> py::object {
            return d.correction
                       ? py::object(py::make_tuple(d.correction->written, d.correction->instead))
                       : py::object(py::none());
          },
          "What is written and what to write instead, if a better word is known; else None.")
      .def("__str__", &text_of)
      .def("__repr__",
           [](const Diagnostic& d) { return fmt::format("<Diagnostic {}>", text_of(d)); });

  py::class_<Report>(m, "Report", "The findings about a scene. True if the scene can be used.")
      .def_property_readonly("verdict",
                             [](const Report& r) { return verdict_word(verdict_of(*r.scene)); })
      .def_property_readonly("diagnostics",
                             [](const Report& r) { return list_of(r.scene->diagnostics); })
      .def_property_readonly(
          "errors", [](const Report& r) { return r.scene->diagnostics.count(Severity::error); })
      .def_property_readonly(
          "warnings", [](const Report& r) { return r.scene->diagnostics.count(Severity::warning); })
      .def_property_readonly(
          "data",
          [](const Report& r) {
            return py::module_::import("json").attr("loads")(scene_json(*r.scene));
          })
      .def("__bool__", [](const Report& r) { return r.scene->usable(); })
      .def("__str__", [](const Report& r) { return findings_text(*r.scene, Verbosity::all); })
      .def("__repr__", [](const Report& r) {
        return fmt::format("<Report: {}, {} errors, {} warnings>",
                           verdict_word(verdict_of(*r.scene)),
                           r.scene->diagnostics.count(Severity::error),
                           r.scene->diagnostics.count(Severity::warning));
      });

  m.def("read", &read, "Reads a scene from a file. Raises SceneError if it has errors.",
        py::arg("path"), py::kw_only(), py::arg("compat_course") = false,
        py::arg("allow_missing") = false, py::arg("asset_roots") = Paths(),
        py::arg("allow_outside") = false);
  m.def("read_text", &read_text,
        "Reads a scene from its text. Textures and meshes are looked up as if the file were in "
        "`folder`.",
        py::arg("text"), py::kw_only(), py::arg("folder") = FilePath{"."},
        py::arg("compat_course") = false, py::arg("allow_missing") = false,
        py::arg("asset_roots") = Paths(), py::arg("allow_outside") = false);
  m.def("check", &check, "Reports everything that is wrong with the scene in a file.",
        py::arg("path"), py::kw_only(), py::arg("strict") = false, py::arg("deny_warnings") = false,
        py::arg("deny") = std::vector<std::string>(), py::arg("allow") = std::vector<std::string>(),
        py::arg("assets") = true, py::arg("compat_course") = false,
        py::arg("allow_missing") = false, py::arg("asset_roots") = Paths(),
        py::arg("allow_outside") = false);

  py::class_<CountedMaterial>(m, "FaceMaterial", "A material of mesh faces, from a .mtl file.")
      .def_property_readonly("name", [](const CountedMaterial& m) { return m.name; })
      .def_property_readonly(
          "diffuse", [](const CountedMaterial& m) { return m.diffuse; }, "Kd")
      .def_property_readonly(
          "specular", [](const CountedMaterial& m) { return m.specular; }, "Ks")
      .def_property_readonly(
          "emission", [](const CountedMaterial& m) { return m.emission; }, "Ke")
      .def_property_readonly(
          "transmission", [](const CountedMaterial& m) { return m.transmission; }, "Tf")
      .def_property_readonly(
          "shininess", [](const CountedMaterial& m) { return shown(m.shininess); }, "Ns")
      .def_property_readonly(
          "ior", [](const CountedMaterial& m) { return shown(m.ior); }, "Ni")
      .def_property_readonly("illum", [](const CountedMaterial& m) { return m.illum; })
      .def_property_readonly(
          "triangles", [](const CountedMaterial& m) { return m.triangles; },
          "how many triangles of the mesh have it")
      .def("__repr__",
           [](const CountedMaterial& m) { return fmt::format("<FaceMaterial {}>", m.name); });

  auto scene = py::reinterpret_borrow<py::class_<SceneState, SharedState>>(m.attr("Scene"));
  scene
      .def(py::init([](const FilePath& folder) {
             SharedState state = new_state(name_in(folder), false, false, {}, false);
             state->scene.nodes[state->scene.root].name = "root";
             return state;
           }),
           "An empty scene. Textures and meshes are looked up in `folder`.", py::kw_only(),
           py::arg("folder") = FilePath{"."})
      .def(
          "check",
          [](SceneState& state, bool strict, bool deny_warnings, std::vector<std::string> deny,
             std::vector<std::string> allow) {
            const FindingPolicy policy{strict, deny_warnings, known_codes(std::move(deny)),
                                       known_codes(std::move(allow))};
            return report_of(*look_at(state), policy);
          },
          "Reports everything that is wrong with the current scene.", py::kw_only(),
          py::arg("strict") = false, py::arg("deny_warnings") = false,
          py::arg("deny") = std::vector<std::string>(),
          py::arg("allow") = std::vector<std::string>())
      .def_property_readonly("face_materials", &face_materials,
                             "The materials of mesh faces by the mesh's file name.")
      .def_property_readonly(
          "diagnostics", [](SceneState& state) { return list_of(look_at(state)->diagnostics); });
}

}  // namespace scenefile::python
