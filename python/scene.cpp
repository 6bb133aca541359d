// Scenes and their parts, for reading and editing.

#include "scenefile/base/shape.h"
#include "scenefile/base/text.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"
#include "state.h"

#include <fmt/format.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace scenefile::python {

namespace {

// Converts members to Python values.
double to_python(float value) {
  return shown(value);
}
std::optional<double> to_python(std::optional<float> value) {
  return value ? std::optional(shown(*value)) : std::nullopt;
}
template <typename T>
T to_python(const T& value) {
  return value;
}
std::string to_python(const RareText& value) {
  return value.str();
}

template <typename T>
struct Given {
  using Type = T;
};
template <>
struct Given<RareText> {
  using Type = std::string;
};

// A property for a member of the struct that the part refers to.
template <typename Class, typename Struct, typename T>
void member(Class& c, const char* name, T Struct::*at, const char* doc) {
  using SomePart = typename Class::type;
  c.def_property(
      name, [at](const SomePart& part) { return to_python(part.get().*at); },
      [at](const SomePart& part, typename Given<T>::Type value) {
        edit(part).*at = std::move(value);
      },
      doc);
}

template <typename Class>
void identity(Class& c) {
  using SomePart = typename Class::type;
  c.def(
      "__eq__", [](const SomePart& a, const SomePart& b) { return a == b; }, py::is_operator());
  c.def("__hash__", [](const SomePart& part) {
    return std::hash<const void*>()(part.state.get()) ^ (std::size_t{part.node} << 16) ^ part.index;
  });
}

NodePart node_at(const SharedState& state, NodeId id) {
  return {{state, id, 0, state->removals}};
}

template <typename SomePart>
py::tuple parts_of(const NodePart& node, std::size_t count) {
  py::tuple parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    parts[i] =
        SomePart{{node.state, node.node, static_cast<std::uint32_t>(i), node.state->removals}};
  }
  return parts;
}

// All nodes of the scene, parents first: those of the root, then those of the templates.
std::vector<NodeId> all_nodes(const Scene& scene) {
  std::vector<NodeId> result;
  std::vector<NodeId> open(scene.templates.rbegin(), scene.templates.rend());
  open.push_back(scene.root);
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    result.push_back(id);
    const std::vector<NodeId>& children = scene.nodes[id].children;
    open.insert(open.end(), children.rbegin(), children.rend());
  }
  return result;
}

// The parts of all nodes, in the order of all_nodes().
template <typename SomePart, typename List>
py::tuple parts_of_all(const SharedState& state, List Node::*list) {
  py::list parts;
  for (const NodeId id : all_nodes(state->scene)) {
    parts += parts_of<SomePart>(node_at(state, id), (state->scene.nodes[id].*list).size());
  }
  return py::tuple(parts);
}

void remove_node(const NodePart& part) {
  Scene& scene = part.state->scene;
  if (part.node == scene.root) {
    throw py::value_error("the root of a scene cannot be removed");
  }
  std::erase(scene.templates, part.node);
  for (Node& node : scene.nodes) {
    std::erase(node.children, part.node);
  }
  edit(part);
}

// Removes the part from the list of its node.
template <typename SomePart, typename T>
void remove_from(const SomePart& part, std::vector<T> Node::*list) {
  edit(part);
  std::vector<T>& parts = part.state->scene.nodes[part.node].*list;
  parts.erase(parts.begin() + part.index);
  ++part.state->removals;
}

using Transforms = std::vector<std::variant<Translate, Rotate, Scale, Matrix>>;

Transforms transforms_of(const NodePart& part) {
  Transforms result;
  for (const Transform& transform : part.get().transforms) {
    result.push_back(transform.map);
  }
  return result;
}

void set_transforms(const NodePart& part, const Transforms& maps) {
  std::vector<Transform> transforms;
  for (const auto& map : maps) {
    transforms.push_back({map, {}});
  }
  edit(part).transforms = std::move(transforms);
}

using Rows = std::array<std::array<double, 4>, 4>;

Rows rows_of(const Matrix& matrix) {
  Rows rows{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      rows[row][column] = shown(matrix.m()[column][row]);
    }
  }
  return rows;
}

Matrix matrix_of(const Rows& rows) {
  glm::mat4 m(1);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      m[column][row] = static_cast<float>(rows[row][column]);
    }
  }
  return Matrix(m);
}

void bind_values(py::module_& m) {
  py::class_<Translate>(m, "Translate", "Moves by a vector.")
      .def(py::init([](const glm::vec3& by) { return Translate{by}; }), py::arg("by"))
      .def_readonly("by", &Translate::by)
      .def(py::self == py::self)
      .def("__repr__", [](const Translate& t) {
        return fmt::format("Translate(({:g}, {:g}, {:g}))", t.by.x, t.by.y, t.by.z);
      });
  py::class_<Rotate>(m, "Rotate", "Rotates about an axis, right-handed, in degrees.")
      .def(py::init([](const glm::vec3& axis, float angle) {
             return Rotate{axis, angle};
           }),
           py::arg("axis"), py::arg("angle_deg"))
      .def_readonly("axis", &Rotate::axis)
      .def_property_readonly("angle_deg", [](const Rotate& r) { return shown(r.angle_deg); })
      .def(py::self == py::self)
      .def("__repr__", [](const Rotate& r) {
        return fmt::format("Rotate(({:g}, {:g}, {:g}), {:g})", r.axis.x, r.axis.y, r.axis.z,
                           r.angle_deg);
      });
  py::class_<Scale>(m, "Scale", "Scales along the axes.")
      .def(py::init([](const glm::vec3& by) { return Scale{by}; }), py::arg("by"))
      .def_readonly("by", &Scale::by)
      .def(py::self == py::self)
      .def("__repr__", [](const Scale& s) {
        return fmt::format("Scale(({:g}, {:g}, {:g}))", s.by.x, s.by.y, s.by.z);
      });
  py::class_<Matrix>(m, "Matrix", "Any affine map, as the rows of a 4x4 matrix for column vectors.")
      .def(py::init(&matrix_of), py::arg("rows"))
      .def_property_readonly("rows", &rows_of)
      .def(py::self == py::self);
  py::class_<TextureUse>(m, "TextureUse", "An image file on a surface.")
      .def(py::init([](std::string file, float repeat_u, float repeat_v) {
             return TextureUse{std::move(file), repeat_u, repeat_v, {}};
           }),
           py::arg("file"), py::arg("repeat_u") = 1.0F, py::arg("repeat_v") = 1.0F)
      .def_readonly("file", &TextureUse::file)
      .def_property_readonly("repeat_u", [](const TextureUse& t) { return shown(t.repeat_u); })
      .def_property_readonly("repeat_v", [](const TextureUse& t) { return shown(t.repeat_v); })
      .def(py::self == py::self)
      .def("__repr__", [](const TextureUse& t) {
        return fmt::format("TextureUse({}, {:g}, {:g})", quoted(t.file, 200), t.repeat_u,
                           t.repeat_v);
      });
}

void bind_camera_and_globals(py::module_& m) {
  py::class_<CameraPart> camera(m, "Camera");
  identity(camera);
  member(camera, "position", &Camera::position, "where it is");
  member(camera, "look", &Camera::look, "view direction");
  member(camera, "up", &Camera::up, "direction that is up in the picture");
  member(camera, "height_angle_deg", &Camera::height_angle_deg, "full vertical field of view");
  member(camera, "aperture", &Camera::aperture, "size of the lens; 0 is a pinhole");
  member(camera, "focal_length", &Camera::focal_length, "distance of the plane in focus");
  camera.def(
      "look_at",
      [](const CameraPart& part, const glm::vec3& point) {
        Camera& c = edit(part);
        c.look = point - c.position;
      },
      "Points the camera at a point.", py::arg("point"));

  py::class_<GlobalsPart> globals(m, "Globals");
  identity(globals);
  member(globals, "ambient", &Global::ambient, "coefficient of ambient light");
  member(globals, "diffuse", &Global::diffuse, "coefficient of diffuse light");
  member(globals, "specular", &Global::specular, "coefficient of highlights and reflections");
  member(globals, "transparent", &Global::transparent, "coefficient of refraction, or None");
}

void bind_light(py::module_& m) {
  py::class_<LightPart> light(m, "Light");
  identity(light);
  light.def_property(
      "type", [](const LightPart& part) { return word_of(part.get().type); },
      [](const LightPart& part, std::string_view word) {
        edit(part).type = from_word<LightType>("type", word, light_words);
      },
      "point, directional, spot or area");
  member(light, "color", &Light::color, "red, green and blue; 1 is full intensity");
  member(light, "position", &Light::position, "in the space of its node");
  member(light, "direction", &Light::direction, "in which the light travels");
  member(light, "attenuation", &Light::attenuation, "constant, linear and quadratic coefficient");
  member(light, "angle_deg", &Light::angle_deg, "spot: half-angle of the outer cone");
  member(light, "penumbra_deg", &Light::penumbra_deg, "spot: from full light to none");
  member(light, "width", &Light::width, "area: in world units");
  member(light, "height", &Light::height, "area: in world units");
  member(light, "name", &Light::name, "without effect");
  light.def_property_readonly("node", [](const LightPart& l) { return node_at(l.state, l.node); })
      .def("remove", [](const LightPart& part) { remove_from(part, &Node::lights); })
      .def("__repr__", [](const LightPart& part) {
        const glm::vec3& color = part.get().color;
        return fmt::format("<Light {} {:g} {:g} {:g}>", word_of(part.get().type), color.r, color.g,
                           color.b);
      });
}

// A texture of a material, or None.
void texture(py::class_<MaterialPart>& material, const char* name, Rare<TextureUse> Material::*at) {
  material.def_property(
      name,
      [at](const MaterialPart& part) {
        const Rare<TextureUse>& use = part.get().*at;
        return use ? std::optional(*use) : std::nullopt;
      },
      [at](const MaterialPart& part, const std::optional<TextureUse>& use) {
        edit(part).*at = use ? Rare<TextureUse>(*use) : Rare<TextureUse>();
      });
}

void bind_primitive(py::module_& m) {
  py::class_<MaterialPart> material(m, "Material");
  identity(material);
  member(material, "ambient", &Material::ambient, "color");
  member(material, "diffuse", &Material::diffuse, "color");
  member(material, "specular", &Material::specular, "color of highlights");
  member(material, "reflective", &Material::reflective, "color of reflections");
  member(material, "transparent", &Material::transparent, "color of refracted light");
  member(material, "shininess", &Material::shininess, "exponent; 0 means no highlight");
  member(material, "ior", &Material::ior, "index of refraction");
  member(material, "blend", &Material::blend, "share of the texture in the diffuse color");
  texture(material, "texture", &Material::texture);
  texture(material, "bump_map", &Material::bump_map);

  py::class_<PrimitivePart> primitive(m, "Primitive");
  identity(primitive);
  primitive.def_property(
      "shape", [](const PrimitivePart& part) { return word_of(part.get().shape); },
      [](const PrimitivePart& part, std::string_view word) {
        edit(part).shape = from_word<Shape>("shape", word, shape_words);
      },
      "the word of the format, such as cube");
  member(primitive, "mesh_file", &Primitive::mesh_file, "only for meshes");
  primitive
      .def_property_readonly("material",
                             [](const PrimitivePart& p) {
                               return MaterialPart{{p.state, p.node, p.index, p.removals}};
                             })
      .def_property_readonly("node",
                             [](const PrimitivePart& p) { return node_at(p.state, p.node); })
      .def("remove", [](const PrimitivePart& part) { remove_from(part, &Node::primitives); })
      .def("__repr__", [](const PrimitivePart& part) {
        return fmt::format("<Primitive {} of {}>", word_of(part.get().shape),
                           node_path(part.state->scene, part.node));
      });
}

void bind_node(py::module_& m) {
  py::class_<NodePart> node(m, "Node");
  identity(node);
  member(node, "name", &Node::name, "may be empty");
  member(node, "instance_of", &Node::instance_of, "name of a template; empty: not an instance");
  node.def_property(
          "transforms",
          [](const NodePart& part) { return py::tuple(py::cast(transforms_of(part))); },
          &set_transforms, "their product places the node; the last one acts first")
      .def_property_readonly(
          "path", [](const NodePart& part) { return node_path(part.state->scene, part.node); },
          "names from the root down to it")
      .def_property_readonly("children",
                             [](const NodePart& part) {
                               py::list list;
                               for (const NodeId child : part.get().children) {
                                 list.append(node_at(part.state, child));
                               }
                               return py::tuple(list);
                             })
      .def_property_readonly(
          "lights",
          [](const NodePart& part) { return parts_of<LightPart>(part, part.get().lights.size()); })
      .def_property_readonly("primitives",
                             [](const NodePart& part) {
                               return parts_of<PrimitivePart>(part, part.get().primitives.size());
                             })
      .def(
          "add_child",
          [](const NodePart& part, std::string name) {
            edit(part);
            const NodeId child = add_child(part.state->scene, part.node);
            part.state->scene.nodes[child].name = std::move(name);
            return node_at(part.state, child);
          },
          py::arg("name") = "")
      .def(
          "add_primitive",
          [](const NodePart& part, std::string_view shape, std::string mesh_file) {
            Primitive primitive;
            primitive.shape = from_word<Shape>("shape", shape, shape_words);
            primitive.mesh_file = std::move(mesh_file);
            std::vector<Primitive>& all = edit(part).primitives;
            all.push_back(std::move(primitive));
            return PrimitivePart{{part.state, part.node, static_cast<std::uint32_t>(all.size() - 1),
                                  part.state->removals}};
          },
          py::arg("shape"), py::arg("mesh_file") = "")
      .def(
          "add_light",
          [](const NodePart& part, std::string_view type) {
            Light light;
            light.type = from_word<LightType>("type", type, light_words);
            std::vector<Light>& all = edit(part).lights;
            all.push_back(std::move(light));
            return LightPart{{part.state, part.node, static_cast<std::uint32_t>(all.size() - 1),
                              part.state->removals}};
          },
          py::arg("type"))
      .def("remove", &remove_node, "Removes the node and its descendants from the scene.")
      .def("__repr__", [](const NodePart& part) {
        const Node& n = part.get();
        return fmt::format("<Node {}: {} primitives, {} lights, {} children>",
                           node_path(part.state->scene, part.node), n.primitives.size(),
                           n.lights.size(), n.children.size());
      });
}

struct Written {
  std::string text;
  py::list diagnostics;  // what the format could not say
};

Written written(SceneState& state, SceneFormat format) {
  const std::shared_ptr<const LoadedScene> loaded = usable(state);
  LoadedScene said;
  said.path = loaded->path;
  Written result;
  {
    const py::gil_scoped_release release;
    result.text = write_scene(loaded->written, format, state.settings.limits, said.diagnostics);
  }
  if (said.diagnostics.has_errors()) {
    raise_unusable(said);
  }
  for (const Diagnostic& d : said.diagnostics.list()) {
    result.diagnostics.append(d);
  }
  return result;
}

SceneFormat format_of(std::string_view word) {
  static constexpr std::array<std::string_view, 2> words{"xml", "json"};
  return from_word<SceneFormat>("format", word, words);
}

py::list save(SceneState& state, const FilePath& path) {
  const std::string name = lower_case(path.text);
  if (!name.ends_with(".xml") && !name.ends_with(".json")) {
    throw py::value_error(
        fmt::format("cannot save a scene as {}: the name must end in .xml or .json; \"scenefile "
                    "convert\" writes "
                    "other formats",
                    quoted(path.text, 400)));
  }
  std::vector<UsedFile> inputs = used_files(*usable(state), state.access, state.settings.limits);
  inputs.erase(inputs.begin());  // the scene itself: its file may be replaced by an edited scene
  refuse_replacing(inputs, {{path.text, fmt::format("the scene {}", escaped(path.text))}});
  const Written result =
      written(state, name.ends_with(".xml") ? SceneFormat::xml : SceneFormat::json);
  if (const Result<void> done = write_file(path.text, result.text); !done) {
    raise_error(done.error());
  }
  return result.diagnostics;
}

}  // namespace

void bind_scene(py::module_& m) {
  bind_values(m);
  bind_camera_and_globals(m);
  bind_light(m);
  bind_primitive(m);
  bind_node(m);

  auto scene = py::reinterpret_borrow<py::class_<SceneState, SharedState>>(m.attr("Scene"));
  scene
      .def_property(
          "name", [](const SceneState& s) { return s.scene.name; },
          [](SceneState& s, std::string name) {
            s.scene.name = std::move(name);
            s.loaded.reset();
            ++s.edits;
          })
      .def_property_readonly("path", [](const SceneState& s) { return s.path; })
      .def_property_readonly("camera",
                             [](const SharedState& s) {
                               return CameraPart{{s, 0, 0, 0}};
                             })
      .def_property_readonly("globals",
                             [](const SharedState& s) {
                               return GlobalsPart{{s, 0, 0, 0}};
                             })
      .def_property_readonly("root", [](const SharedState& s) { return node_at(s, s->scene.root); })
      .def_property_readonly("templates",
                             [](const SharedState& s) {
                               py::dict result;
                               for (const NodeId id : s->scene.templates) {
                                 result[py::str(s->scene.nodes[id].name.str())] = node_at(s, id);
                               }
                               return result;
                             })
      .def_property_readonly("nodes",
                             [](const SharedState& s) {
                               py::list list;
                               for (const NodeId id : all_nodes(s->scene)) {
                                 list.append(node_at(s, id));
                               }
                               return py::tuple(list);
                             })
      .def_property_readonly(
          "lights", [](const SharedState& s) { return parts_of_all<LightPart>(s, &Node::lights); })
      .def_property_readonly(
          "primitives",
          [](const SharedState& s) { return parts_of_all<PrimitivePart>(s, &Node::primitives); })
      .def(
          "add_template",
          [](const SharedState& s, std::string name) {
            s->loaded.reset();
            ++s->edits;
            return node_at(s, add_template(s->scene, std::move(name)));
          },
          py::arg("name"))
      .def(
          "to_text",
          [](SceneState& s, std::string_view format) { return written(s, format_of(format)).text; },
          "The scene as the text of a file, in XML or JSON.", py::arg("format") = "xml")
      .def("save", &save,
           "Writes a scene file, .xml or .json, atomically. Returns what the format could not "
           "express. "
           "Never replaces a texture or mesh of the scene.",
           py::arg("path"))
      .def("__repr__", [](const SceneState& s) { return fmt::format("<Scene {}>", s.path); });
}

}  // namespace scenefile::python
