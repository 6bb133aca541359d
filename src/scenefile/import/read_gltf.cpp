#include "scenefile/import/read_gltf.h"

#include "scenefile/base/components.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/import/codes.h"
#include "scenefile/import/complete_scene.h"
#include "scenefile/import/gltf_accessor.h"
#include "scenefile/import/gltf_file.h"
#include "scenefile/import/gltf_material.h"
#include "scenefile/import/mesh_text.h"
#include "scenefile/scene/transforms.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

using std::numbers::pi;
// Upper bounds for the text of an OBJ file, per vertex with all attributes and per triangle.
constexpr std::uint64_t bytes_of_vertex = 100;
constexpr std::uint64_t bytes_of_triangle = 100;

// A list of triangles in a file next to the scene; an empty name means nothing to draw.
struct MeshFile {
  std::string name;
  Bounds box;
  bool repeats = false;  // uvs leave the range 0 to 1
};

// Identifies a mesh file: accessors, mode, and the material's uv transform.
using MeshKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t,
                           std::uint32_t, std::vector<float>>;

class GltfReader {
 public:
  GltfReader(const ImportOptions& options, Diagnostics& diagnostics)
      : options_(options),
        diagnostics_(diagnostics),
        materials_(file_, options, result_.files, diagnostics),
        triangles_left_(options.limits.mesh_triangles),
        bytes_left_(options.limits.mesh_bytes) {}

  ImportedScene read(std::string_view bytes) {
    if (open_gltf(bytes, options_, file_, diagnostics_) && find_tree()) {
      report_left_out();
      result_.scene.global = {1, 1, 1, 1.0f, {}};
      add_nodes();
      if (is_orthographic_) {
        diagnostics_.report("import.left-out"_code, {},
                            "the orthographic camera becomes a perspective camera of 45 degrees");
      }
      complete_scene(result_.scene, box_, diagnostics_);
    }
    return std::move(result_);
  }

 private:
  struct NodeLinks {
    std::uint32_t parent = no_item;
    std::vector<std::uint32_t> children;
    bool used = false;  // this node or a descendant contains triangles
  };

  void fail(std::string message) {
    diagnostics_.report("import.value"_code, {}, std::move(message));
    failed_ = true;
  }

  // An optional index into a table; no_item if it is missing or invalid.
  std::uint32_t index(const JsonValue& value, std::size_t size, std::string_view where) {
    if (!value) {
      return no_item;
    }
    const std::uint64_t number = value.whole().value_or(no_item);
    if (number >= size) {
      fail(fmt::format("{} refers to an element that does not exist", where));
      return no_item;
    }
    return static_cast<std::uint32_t>(number);
  }

  bool find_tree() {
    const std::size_t count = file_.nodes.size();
    links_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const JsonValue& child : file_.nodes[i]["children"].elements()) {
        const std::uint32_t c = index(child, count, fmt::format("nodes[{}].children", i));
        if (c == no_item || links_[c].parent != no_item || c == i) {
          fail(fmt::format("nodes[{}].children: each node has one parent", i));
          return false;
        }
        links_[c].parent = i;
        links_[i].children.push_back(c);
      }
    }
    const std::vector<JsonValue> scenes = file_.root["scenes"].elements();
    const std::uint32_t chosen =
        file_.root["scene"] ? index(file_.root["scene"], scenes.size(), "scene") : 0;
    std::set<std::uint32_t> seen;
    if (chosen < scenes.size()) {
      for (const JsonValue& root : scenes[chosen]["nodes"].elements()) {
        const std::uint32_t r = index(root, count, "scenes.nodes");
        if (r == no_item || links_[r].parent != no_item || !seen.insert(r).second) {
          fail("scenes.nodes: each is a node without a parent, named once");
          return false;
        }
        roots_.push_back(r);
      }
    } else {
      for (std::uint32_t i = 0; i < count; ++i) {
        if (links_[i].parent == no_item) {
          roots_.push_back(i);
        }
      }
    }
    mark_used();
    return !failed_;
  }

  // Marks the ancestors of each mesh; stopping at marked nodes ends loops.
  void mark_used() {
    for (std::uint32_t i = 0; i < links_.size(); ++i) {
      if (file_.nodes[i]["mesh"]) {
        for (std::uint32_t at = i; at != no_item && !links_[at].used; at = links_[at].parent) {
          links_[at].used = true;
        }
      }
    }
  }

  void report_left_out() {
    const std::pair<std::string_view, std::string_view> parts[] = {
        {"animations", "animations are left out: the model is shown at rest"},
        {"skins", "skins are left out: meshes are shown in their rest pose"}};
    for (const auto& [member, message] : parts) {
      if (!file_.root[member].elements().empty()) {
        diagnostics_.report("import.left-out"_code, {}, std::string(message));
      }
    }
  }

  // Parents before children, siblings in order, without recursion.
  void add_nodes() {
    struct Waiting {
      std::uint32_t index;
      NodeId parent;
      DAffine world_from_parent;
    };
    std::vector<Waiting> waiting;
    for (auto root = roots_.rbegin(); root != roots_.rend(); ++root) {
      waiting.push_back({*root, result_.scene.root, {}});
    }
    while (!waiting.empty() && !failed_) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const JsonValue& json = file_.nodes[next.index];
      const std::vector<Transform> transforms = read_transforms(json, next.index);
      const DAffine world = composed(next.world_from_parent, transforms);
      NodeId id = next.parent;
      if (links_[next.index].used) {
        id = add_child(result_.scene, next.parent);
        const std::string name = json["name"].string().value_or("");
        result_.scene.nodes[id].name = name == "root" ? "" : node_name(name);
        result_.scene.nodes[id].transforms = transforms;
        add_mesh(json, next.index, id, world);
      }
      add_camera(json, next.index, world);
      add_light(json, next.index, world);
      const auto& children = links_[next.index].children;
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        waiting.push_back({*child, id, world});
      }
    }
  }

  std::vector<Transform> read_transforms(const JsonValue& json, std::uint32_t index) {
    std::vector<Transform> list;
    const auto wrong = [&](std::string_view member, std::size_t count) {
      const std::vector<JsonValue> given = json[member].elements();
      const bool numbers = given.size() == count &&
                           std::all_of(given.begin(), given.end(),
                                       [](const JsonValue& value) { return value.is_number(); });
      fail(numbers ? fmt::format("nodes[{}].{} has a number that is too large", index, member)
                   : fmt::format("nodes[{}].{} should be {} numbers", index, member, count));
    };
    if (const JsonValue matrix = json["matrix"]) {
      const auto m = matrix.numbers(16);
      if (!m) {
        wrong("matrix", 16);
        return list;
      }
      glm::mat4 columns(1);
      for (int i = 0; i < 16; ++i) {
        columns[i / 4][i % 4] = static_cast<float>((*m)[i]);
      }
      if (columns != glm::mat4(1)) {
        list.push_back({Matrix(columns), {}});
      }
      return list;
    }
    if (const JsonValue value = json["translation"]) {
      const auto v = value.color();
      v ? list.push_back({Translate{*v}, {}}) : wrong("translation", 3);
    }
    if (const JsonValue value = json["rotation"]) {
      const auto q = value.numbers(4);
      q ? add_rotation(glm::dquat((*q)[3], (*q)[0], (*q)[1], (*q)[2]), list) : wrong("rotation", 4);
    }
    if (const JsonValue value = json["scale"]) {
      const auto v = value.color();
      v ? list.push_back({Scale{*v}, {}}) : wrong("scale", 3);
    }
    return list;
  }

  static void add_rotation(const glm::dquat& q, std::vector<Transform>& list) {
    const glm::dvec3 axis(q.x, q.y, q.z);
    const double sine = glm::length(axis);
    if (sine > 0) {
      list.push_back({Rotate{glm::vec3(axis / sine),
                             static_cast<float>(glm::degrees(2 * std::atan2(sine, q.w)))},
                      {}});
    }
  }

  void add_mesh(const JsonValue& node, std::uint32_t number, NodeId id, const DAffine& world) {
    const std::uint32_t mesh =
        index(node["mesh"], file_.meshes.size(), fmt::format("nodes[{}].mesh", number));
    if (mesh == no_item) {
      return;
    }
    const std::vector<JsonValue> primitives = file_.meshes[mesh]["primitives"].elements();
    for (std::size_t i = 0; i < primitives.size() && !failed_; ++i) {
      const JsonValue& json = primitives[i];
      const std::string where = fmt::format("meshes[{}].primitives[{}]", mesh, i);
      const std::uint32_t material_index =
          index(json["material"], file_.materials.size(), where + ".material");
      const GltfMaterial& material = materials_.get(material_index);
      const MeshFile& file = mesh_file(json, material, where);
      if (file.name.empty()) {
        continue;
      }
      if (file.repeats && !material.repeats) {
        leave_out("wrap modes of textures other than repeat");
      }
      Primitive primitive;
      primitive.shape = Shape::mesh;
      primitive.mesh_file = file.name;
      primitive.material = material.material;
      result_.scene.nodes[id].primitives.push_back(std::move(primitive));
      box_ = unite(box_, transform(world, file.box));
    }
  }

  const MeshFile& mesh_file(const JsonValue& json, const GltfMaterial& material,
                            const std::string& where) {
    const JsonValue attributes = json["attributes"];
    const std::size_t accessors = file_.accessors.size();
    const auto attribute = [&](const std::string& name) {
      return index(attributes[name], accessors, where + "." + name);
    };
    const std::uint32_t uvs = attribute(fmt::format("TEXCOORD_{}", material.uv_set));
    const glm::mat3x2& map = material.uv_map;
    const MeshKey key{attribute("POSITION"),
                      attribute("NORMAL"),
                      uvs,
                      index(json["indices"], accessors, where + ".indices"),
                      static_cast<std::uint32_t>(std::min<std::uint64_t>(
                          json["mode"] ? json["mode"].whole().value_or(99) : 4, 99)),
                      {map[0].x, map[0].y, map[1].x, map[1].y, map[2].x, map[2].y}};
    if (attributes["COLOR_0"]) {
      leave_out("colors of vertices");
    }
    const auto [entry, is_new] = mesh_files_.try_emplace(key);
    if (is_new) {
      if (!json["targets"].elements().empty()) {
        leave_out("morph targets");
      }
      entry->second = make_mesh(key, map, where);
    }
    return entry->second;
  }

  void leave_out(std::string_view what) {
    if (left_out_.emplace(what).second) {
      diagnostics_.report("import.left-out"_code, {}, fmt::format("{} are left out", what));
    }
  }

  MeshFile make_mesh(const MeshKey& key, const glm::mat3x2& uv_map, const std::string& where) {
    const auto& [positions, normals, uvs, indices, mode, map] = key;
    if (failed_ || mode < 4) {
      leave_out("points and lines");
      return {};
    }
    if (positions == no_item || mode > 6) {
      fail(fmt::format("{} has no POSITION, or an unknown mode", where));
      return {};
    }
    const std::uint64_t vertices = element_count(file_, positions);
    const std::uint64_t corners = indices == no_item ? vertices : element_count(file_, indices);
    // Strips and fans have nearly one triangle per corner.
    const std::uint64_t triangles = mode == 4 ? corners / 3 : corners;
    constexpr std::uint64_t most = std::uint64_t{1} << 40;
    const bool absurd = vertices > most || triangles > most;
    const std::uint64_t bytes =
        absurd ? 0 : vertices * bytes_of_vertex + triangles * bytes_of_triangle;
    if (absurd || triangles > triangles_left_ || bytes > bytes_left_) {
      diagnostics_.report(
          "import.limit"_code, {},
          fmt::format(
              "{}: {} triangles of {} vertices exceed what is left of the limit for all meshes",
              where, triangles, vertices));
      failed_ = true;
      return {};
    }
    triangles_left_ -= triangles;
    bytes_left_ -= bytes;
    TriangleList list;
    if (!read_vertices(key, uv_map, list, where) || !read_corners(indices, mode, list, where) ||
        list.indices.empty()) {
      return {};
    }
    MeshFile file;
    for (const glm::vec3& p : list.positions) {
      file.box = unite(file.box, glm::dvec3(p));
    }
    file.repeats = std::any_of(list.uvs.begin(), list.uvs.end(), [](const glm::vec2& uv) {
      constexpr float rounding = 1e-4f;
      return glm::any(glm::greaterThan(glm::abs(uv - 0.5f), glm::vec2(0.5f + rounding)));
    });
    file.name = fmt::format("{}-{}.obj", options_.stem, result_.files.size() + 1);
    result_.files.push_back({file.name, obj_text(list)});
    return file;
  }

  bool floats(std::uint32_t accessor, std::size_t components, std::size_t count,
              std::vector<float>& values, const std::string& where) {
    Result<std::vector<float>> read = read_floats(file_, accessor, components);
    if (!read) {
      fail(fmt::format("{}: accessors[{}]{}", where, accessor, read.error().text));
      return false;
    }
    values = *std::move(read);
    if (count != 0 && values.size() != count * components) {
      fail(fmt::format("{}: its attributes do not have as many elements as POSITION", where));
      return false;
    }
    return true;
  }

  bool read_vertices(const MeshKey& key, const glm::mat3x2& uv_map, TriangleList& list,
                     const std::string& where) {
    const auto& [positions, normals, uvs, indices, mode, map] = key;
    std::vector<float> values;
    if (!floats(positions, 3, 0, values, where)) {
      return false;
    }
    const std::size_t count = values.size() / 3;
    for (std::size_t i = 0; i < count; ++i) {
      list.positions.emplace_back(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    }
    if (normals != no_item) {
      if (!floats(normals, 3, count, values, where)) {
        return false;
      }
      for (std::size_t i = 0; i < count; ++i) {
        list.normals.emplace_back(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
      }
    }
    if (uvs != no_item) {
      if (!floats(uvs, 2, count, values, where)) {
        return false;
      }
      for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 uv = uv_map * glm::vec3(values[2 * i], values[2 * i + 1], 1);
        list.uvs.push_back(finite(uv) ? glm::vec2(uv.x, 1 - uv.y) : glm::vec2(0));
      }
    }
    return true;
  }

  static bool finite(const glm::vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

  // Converts strips and fans to lists. (Specification, section 3.7.2.1.)
  bool read_corners(std::uint32_t accessor, std::uint32_t mode, TriangleList& list,
                    const std::string& where) {
    std::vector<std::uint32_t> corners;
    if (accessor == no_item) {
      for (std::uint32_t i = 0; i < list.positions.size(); ++i) {
        corners.push_back(i);
      }
    } else if (Result<std::vector<std::uint32_t>> read = read_indices(file_, accessor)) {
      corners = *std::move(read);
    } else {
      fail(fmt::format("{}: accessors[{}]{}", where, accessor, read.error().text));
      return false;
    }
    for (const std::uint32_t corner : corners) {
      if (corner >= list.positions.size()) {
        fail(fmt::format("{}: index {} of {} vertices", where, corner, list.positions.size()));
        return false;
      }
    }
    constexpr std::uint32_t strip = 5;
    constexpr std::uint32_t fan = 6;
    if (mode != strip && mode != fan) {
      corners.resize(corners.size() / 3 * 3);
      list.indices = std::move(corners);
      return true;
    }
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      const std::size_t odd = mode == strip ? i % 2 : 0;
      list.indices.push_back(corners[mode == fan ? 0 : i]);
      list.indices.push_back(corners[i + 1 + odd]);
      list.indices.push_back(corners[i + 2 - odd]);
    }
    return true;
  }

  void add_camera(const JsonValue& node, std::uint32_t number, const DAffine& world) {
    const std::uint32_t camera =
        index(node["camera"], file_.cameras.size(), fmt::format("nodes[{}].camera", number));
    if (camera == no_item) {
      return;
    }
    const JsonValue perspective = file_.cameras[camera]["perspective"];
    if (result_.scene.camera) {
      leave_out(is_orthographic_ == !perspective ? "cameras after the first"
                                                 : "orthographic cameras");
      if (!is_orthographic_ || !perspective) {
        return;
      }
    }
    is_orthographic_ = !perspective;
    double angle = pi / 4;
    if (perspective) {
      angle = perspective["yfov"].number().value_or(0);
      if (!(angle > 0 && angle < pi)) {
        fail(fmt::format("cameras[{}].perspective.yfov is an angle below pi", camera));
        return;
      }
    }
    Camera& c = result_.scene.camera.emplace();
    c.position = glm::vec3(world.offset);
    c.look = direction(-world.linear[2], {0, 0, -1});
    c.up = direction(world.linear[1], {0, 1, 0});
    c.height_angle_deg = static_cast<float>(glm::degrees(angle));
  }

  static glm::vec3 direction(const glm::dvec3& v, const glm::vec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : otherwise;
  }

  void add_light(const JsonValue& node, std::uint32_t number, const DAffine& world) {
    const std::uint32_t at =
        index(node["extensions"]["KHR_lights_punctual"]["light"], file_.lights.size(),
              fmt::format("nodes[{}].extensions.KHR_lights_punctual.light", number));
    if (at == no_item) {
      return;
    }
    const JsonValue& json = file_.lights[at];
    Light light;
    light.position = glm::vec3(world.offset);
    light.direction = direction(-world.linear[2], {0, 0, -1});
    const double intensity = std::clamp(json["intensity"].number().value_or(1), 0.0, 1e30);
    double factor = pi;
    light.attenuation = {0, 0, 1};
    const std::string type = json["type"].string().value_or("");
    if (type == "directional") {
      light.type = LightType::directional;
      light.attenuation = {1, 0, 0};
    } else if (type == "spot") {
      light.type = LightType::spot;
      const double outer = json["spot"]["outerConeAngle"].number().value_or(pi / 4);
      const double inner = json["spot"]["innerConeAngle"].number().value_or(0);
      light.angle_deg = static_cast<float>(glm::degrees(std::clamp(outer, 0.0, pi / 2)));
      light.penumbra_deg =
          static_cast<float>(glm::degrees(std::clamp(outer - inner, 0.0, std::min(outer, pi / 2))));
    } else if (type != "point") {
      fail(fmt::format("lights[{}].type is not directional, point or spot", at));
      return;
    }
    add_own(json["extras"]["scenefile"], light, factor);
    light.color = glm::vec3(glm::dvec3(glm::clamp(json["color"].color().value_or(glm::vec3(1)),
                                                  glm::vec3(0), glm::vec3(1))) *
                            (intensity / factor));
    if (light.type == LightType::directional) {
      light.position = glm::vec3(0);
    }
    result_.scene.nodes[result_.scene.root].lights.push_back(std::move(light));
  }

  // Applies the values that write_gltf() stored next to glTF's own.
  static void add_own(const JsonValue& own, Light& light, double& factor) {
    const auto attenuation = own["attenuation"].color();
    const auto candela = own["candela"].number();
    if (light.type == LightType::directional || !attenuation || !candela || !(*candela > 0) ||
        glm::any(glm::lessThan(*attenuation, glm::vec3(0))) || largest(*attenuation) <= 0) {
      return;
    }
    light.attenuation = *attenuation;
    factor = *candela;
    const auto width = own["width"].number();
    const auto height = own["height"].number();
    if (light.type == LightType::point && width && height && *width > 0 && *height > 0) {
      light.type = LightType::area;
      light.width = static_cast<float>(*width);
      light.height = static_cast<float>(*height);
    }
  }

  const ImportOptions& options_;
  Diagnostics& diagnostics_;
  GltfFile file_;
  ImportedScene result_;
  GltfMaterials materials_;
  std::uint64_t triangles_left_;
  std::uint64_t bytes_left_;
  bool failed_ = false;
  bool is_orthographic_ = false;  // the camera of the scene
  std::vector<NodeLinks> links_;
  std::vector<std::uint32_t> roots_;
  std::map<MeshKey, MeshFile> mesh_files_;
  std::set<std::string, std::less<>> left_out_;
  Bounds box_;
};

}  // namespace

ImportedScene read_gltf(std::string_view bytes, const ImportOptions& options,
                        Diagnostics& diagnostics) {
  return GltfReader(options, diagnostics).read(bytes);
}

}  // namespace scenefile
