#include "scenefile/export/write_gltf.h"

#include "scenefile/base/base64.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/export/codes.h"
#include "scenefile/export/flat_mesh.h"
#include "scenefile/export/gltf_buffer.h"
#include "scenefile/export/gltf_light.h"
#include "scenefile/export/gltf_material.h"
#include "scenefile/export/report_once.h"
#include "scenefile/export/scene_box.h"
#include "scenefile/export/trs.h"
#include "scenefile/format/write_text.h"
#include "scenefile/geometry/tessellate.h"
#include "scenefile/scene/transforms.h"

#include <fmt/format.h>

#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

constexpr std::uint32_t none = mesh_no_index;

struct GltfNode {
  Trs place = {};
  std::string_view name;
  std::string_view extra = {};  // the name of an additional member, such as "mesh"
  std::uint32_t value = none;   // its value
  std::uint32_t last_child = none;
  std::uint32_t next_sibling = none;  // circular list: the last sibling links to the first
};

std::string list(const glm::dvec3& v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

std::string list(const glm::dquat& q) {
  return fmt::format("[{},{},{},{}]", q.x, q.y, q.z, q.w);
}

// The rotation that maps -z to `direction`, a unit vector.
glm::dquat looking_along(const glm::dvec3& direction) {
  const glm::dvec3 w = -direction;
  const glm::dvec3 side = std::abs(w.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(side, w));
  return glm::normalize(glm::quat_cast(glm::dmat3(u, glm::cross(w, u), w)));
}

// The drawn contents of a node, in the order of the file.
struct Contents {
  std::vector<const RenderPrimitive*> primitives;
  const RenderInstance* instance = nullptr;
};

class GltfWriter {
 public:
  GltfWriter(const Scene& scene, const Prepared& ready, const Assets& assets,
             const GltfOptions& options, Diagnostics& diagnostics)
      : scene_(scene),
        ready_(ready.scene),
        sources_(ready.sources),
        assets_(assets),
        options_(options),
        diagnostics_(diagnostics),
        textures_(assets.textures, PictureEncoding::srgb),
        box_(scene_box(ready.scene, assets.meshes)) {}

  std::string write() {
    // A cheap lower bound: at least one node for each instance of a primitive.
    too_large_ = count_virtual_primitives(ready_) > static_cast<double>(options_.max_nodes);
    if (too_large_) {
      return refuse();
    }
    find_contents();
    mark_drawn();
    add_camera();
    add_lights();
    add_tree();
    if (too_large_) {
      return refuse();
    }
    if (textures_.clipped()) {
      report_once("export.approximate"_code, "colors over 1 are clamped to 1", diagnostics_);
    }
    return assemble();
  }

 private:
  std::string refuse() {
    diagnostics_.report(
        "export.size-limit"_code, {},
        fmt::format("with all instances of its templates the scene has more than {} nodes",
                    options_.max_nodes));
    return {};
  }

  void find_contents() {
    for (const RenderGroup& group : ready_.groups) {
      for (const RenderPrimitive& p : group.primitives) {
        if (p.shape != Shape::mesh || !assets_.meshes[p.mesh].triangles.empty()) {
          contents_[sources_[p.source].node].primitives.push_back(&p);
        }
      }
      for (const RenderInstance& instance : group.instances) {
        contents_[sources_[instance.source].node].instance = &instance;
      }
    }
  }

  // Leaves out nodes that contain nothing, directly or in their descendants.
  void mark_drawn() {
    std::vector<NodeId> parent(scene_.nodes.size(), none);
    for (NodeId id = 0; id < scene_.nodes.size(); ++id) {
      for (const NodeId child : scene_.nodes[id].children) {
        if (child < parent.size()) {
          parent[child] = id;
        }
      }
    }
    drawn_.resize(scene_.nodes.size());
    for (const auto& [id, contents] : contents_) {
      for (NodeId at = id; at != none && !drawn_[at]; at = parent[at]) {
        drawn_[at] = true;
      }
    }
    for (const NodeId id : scene_.templates) {
      templates_.try_emplace(scene_.nodes[id].name.str(), id);
    }
  }

  std::uint32_t add_node(std::uint32_t parent, GltfNode node) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    node.next_sibling = index;
    nodes_.push_back(node);
    std::uint32_t& last = parent == none ? last_root_ : nodes_[parent].last_child;
    if (last != none) {
      nodes_[index].next_sibling = std::exchange(nodes_[last].next_sibling, index);
    }
    last = index;
    too_large_ = too_large_ || nodes_.size() > options_.max_nodes;
    return index;
  }

  void add_camera() {
    const RenderCamera& c = ready_.camera;
    GltfNode node{.name = "camera", .extra = "camera", .value = 0};
    node.place.translation = c.position;
    node.place.rotation = glm::normalize(glm::quat_cast(glm::dmat3(c.u, c.v, c.w)));
    add_node(none, node);
    if (c.aperture > 0 && c.focal_length > 0) {
      report_once("export.lost"_code, "the lens of the camera is left out: everything is in focus",
                  diagnostics_);
    }
  }

  void add_lights() {
    for (std::uint32_t i = 0; i < ready_.lights.size(); ++i) {
      const RenderLight& light = ready_.lights[i];
      lights_ += (i == 0 ? "" : ",\n") + gltf_light(light, box_, diagnostics_);
      GltfNode node{.name = word_of(light.type), .extra = "light", .value = i};
      node.place.rotation = looking_along(glm::dvec3(light.direction));
      if (has_position(light.type)) {
        node.place.translation = glm::dvec3(light.position);
      }
      add_node(none, node);
    }
  }

  // Depth-first without recursion, entering the template at each instance.
  void add_tree() {
    struct Waiting {
      NodeId id;
      std::uint32_t parent;
    };
    std::vector<Waiting> waiting;
    if (drawn_[scene_.root]) {
      waiting.push_back({scene_.root, none});
    }
    while (!waiting.empty() && !too_large_) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const Node& node = scene_.nodes[next.id];
      const std::uint32_t at = add_written(node, next.parent);
      if (const auto found = contents_.find(next.id); found != contents_.end()) {
        add_primitives(found->second, at);
        if (found->second.instance != nullptr) {
          waiting.push_back({templates_.at(node.instance_of.str()), at});
          continue;
        }
      }
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        if (drawn_[*child]) {
          waiting.push_back({*child, at});
        }
      }
    }
  }

  // Adds the node, as two nodes if it has shear. Returns the inner one, the parent of its contents.
  std::uint32_t add_written(const Node& node, std::uint32_t parent) {
    const TrsPair pair = decompose(composed(DAffine(), node.transforms));
    const std::uint32_t outer = add_node(parent, {.place = pair.outer, .name = node.name.str()});
    if (!pair.inner) {
      return outer;
    }
    GltfNode inner;
    inner.place.rotation = *pair.inner;
    return add_node(outer, inner);
  }

  void add_primitives(const Contents& contents, std::uint32_t at) {
    for (const RenderPrimitive* p : contents.primitives) {
      const std::uint32_t mesh = mesh_of(*p);
      if (contents.primitives.size() == 1 && nodes_[at].value == none) {
        nodes_[at].extra = "mesh";
        nodes_[at].value = mesh;
      } else {
        add_node(at, {.name = word_of(p->shape), .extra = "mesh", .value = mesh});
      }
    }
  }

  std::uint32_t mesh_of(const RenderPrimitive& p) {
    const std::uint32_t shape = p.shape == Shape::mesh
                                    ? static_cast<std::uint32_t>(shape_count) + p.mesh
                                    : static_cast<std::uint32_t>(p.shape);
    const auto [entry, is_new] = mesh_numbers_.try_emplace(
        {shape, p.material}, static_cast<std::uint32_t>(mesh_numbers_.size()));
    if (is_new) {
      const RenderMaterial& material = ready_.materials[p.material];
      glm::vec2 repeat(1);
      const bool textured = textures_.shows(material);
      if (textured) {
        repeat = {material.texture.repeat_u, material.texture.repeat_v};
      }
      add_mesh(p, geometry_of(p, shape, repeat, textured), material_of(p.material));
    }
    return entry->second;
  }

  void add_mesh(const RenderPrimitive& p, const GltfGeometry& g, std::uint32_t material) {
    fmt::format_to(std::back_inserter(meshes_),
                   R"({}{{"name":"{}","primitives":[{{"attributes":{{"POSITION":{}{}{}}},)"
                   R"("indices":{},"material":{}}}]}})",
                   meshes_.empty() ? "" : ",\n", word_of(p.shape), g.positions,
                   g.normals == none ? "" : fmt::format(R"(,"NORMAL":{})", g.normals),
                   g.uvs == none ? "" : fmt::format(R"(,"TEXCOORD_0":{})", g.uvs), g.indices,
                   material);
  }

  // A texture needs coordinates; those of a mesh without any are 0, as in the ray tracer.
  GltfGeometry geometry_of(const RenderPrimitive& p, std::uint32_t shape, const glm::vec2& repeat,
                           bool textured) {
    const bool adds_uvs =
        textured && p.shape == Shape::mesh && assets_.meshes[p.mesh].triangle_uvs.empty();
    const auto [entry, is_new] = geometries_.try_emplace({shape, repeat.x, repeat.y, adds_uvs});
    if (is_new) {
      FlatMesh mesh = flatten(p.shape == Shape::mesh ? assets_.meshes[p.mesh]
                                                     : tessellate(p.shape, options_.segments));
      if (adds_uvs) {
        mesh.uvs.resize(mesh.positions.size(), glm::vec2(0));
      }
      entry->second = buffer_.add(mesh, repeat);
    }
    return entry->second;
  }

  std::uint32_t material_of(std::uint32_t index) {
    const auto [entry, is_new] =
        material_numbers_.try_emplace(index, static_cast<std::uint32_t>(material_numbers_.size()));
    if (is_new) {
      materials_ += (entry->second == 0 ? "" : ",\n") +
                    gltf_material(ready_.materials[index], ready_.global, options_.transparent,
                                  options_.path, textures_, extensions_, diagnostics_);
    }
    return entry->second;
  }

  std::string children(std::uint32_t last) const {
    std::string text;
    for (std::uint32_t child = nodes_[last].next_sibling;; child = nodes_[child].next_sibling) {
      fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : ",", child);
      if (child == last) {
        return text;
      }
    }
  }

  void append_node(std::string& json, const GltfNode& node) const {
    std::string text;
    const auto member = [&](std::string_view name, const std::string& value) {
      fmt::format_to(std::back_inserter(text), R"({}"{}":{})", text.empty() ? "" : ",", name,
                     value);
    };
    if (!node.name.empty()) {
      std::string name;
      append_json(name, node.name);
      member("name", name);
    }
    if (node.place.translation != glm::dvec3(0)) {
      member("translation", list(node.place.translation));
    }
    if (node.place.rotation != glm::dquat(1, 0, 0, 0)) {
      member("rotation", list(node.place.rotation));
    }
    if (node.place.scale != glm::dvec3(1)) {
      member("scale", list(node.place.scale));
    }
    if (node.value != none && node.extra == "light") {
      member("extensions", fmt::format(R"({{"KHR_lights_punctual":{{"light":{}}}}})", node.value));
    } else if (node.value != none) {
      member(node.extra, fmt::format("{}", node.value));
    }
    if (node.last_child != none) {
      member("children", fmt::format("[{}]", children(node.last_child)));
    }
    json += "{" + text + "}";
  }

  // Near enough to show everything, far enough for the precision of a depth buffer.
  double near_plane() const {
    return box_.empty() ? 0.01 : 1e-3 * std::max(1e-6, glm::distance(box_.min, box_.max));
  }

  std::string assemble() {
    std::string images;
    for (const std::string& file : textures_.files()) {
      fmt::format_to(std::back_inserter(images), R"({}{{"mimeType":"image/png","bufferView":{}}})",
                     images.empty() ? "" : ",\n", buffer_.add(file));
    }
    std::string json = R"({"asset":{"version":"2.0","generator":"scenefile"},"scene":0,)";
    json +=
        "\n"
        R"("scenes":[{"nodes":[)" +
        children(last_root_) + "]}],\n\"nodes\":[\n";
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      json += i == 0 ? "" : ",\n";
      append_node(json, nodes_[i]);
    }
    fmt::format_to(std::back_inserter(json),
                   "],\n\"cameras\":[{{\"type\":\"perspective\",\"perspective\":{{\"yfov\":{},"
                   "\"znear\":{}}}}}]",
                   ready_.camera.fov_y, near_plane());
    array(json, "meshes", meshes_);
    array(json, "materials", materials_);
    array(json, "images", images);
    if (!images.empty()) {
      std::string textures;
      for (std::size_t i = 0; i < textures_.files().size(); ++i) {
        textures += fmt::format(R"({}{{"sampler":0,"source":{}}})", i == 0 ? "" : ",", i);
      }
      array(json, "textures", textures);
      array(json, "samplers", R"({"magFilter":9729,"minFilter":9987})");
    }
    array(json, "accessors", buffer_.accessors());
    array(json, "bufferViews", buffer_.views());
    if (!lights_.empty()) {
      extensions_.insert("KHR_lights_punctual");
      json += ",\n\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[\n" + lights_ + "]}}";
    }
    std::string names;
    for (const std::string_view name : extensions_) {
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ",", name);
    }
    array(json, "extensionsUsed", names);
    return options_.binary ? glb(std::move(json)) : text(std::move(json));
  }

  static void array(std::string& json, std::string_view name, const std::string& contents) {
    if (!contents.empty()) {
      fmt::format_to(std::back_inserter(json), ",\n\"{}\":[\n{}]", name, contents);
    }
  }

  std::string text(std::string json) const {
    if (!buffer_.bytes().empty()) {
      array(json, "buffers",
            fmt::format(R"({{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}})",
                        buffer_.bytes().size(), base64(buffer_.bytes())));
    }
    return json + "}\n";
  }

  // A header and two chunks, each padded to four bytes. (glTF 2.0 Specification, section 4.4.)
  std::string glb(std::string json) {
    std::string bytes = buffer_.bytes();
    if (!bytes.empty()) {
      array(json, "buffers", fmt::format(R"({{"byteLength":{}}})", bytes.size()));
    }
    json += "}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::uint64_t total =
        12 + 8 + std::uint64_t{json.size()} + (bytes.empty() ? 0 : 8 + bytes.size());
    if (total > 0xffffffffu) {
      diagnostics_.report("export.size-limit"_code, {},
                          fmt::format("the file would have {} MB, and the limit of GLB is 4,294",
                                      total / 1'000'000));
      return {};
    }
    std::string file = "glTF";
    const auto number = [&](std::uint64_t n) {
      for (int shift = 0; shift < 32; shift += 8) {
        file += static_cast<char>(n >> shift & 255);
      }
    };
    number(2);
    number(total);
    number(json.size());
    file += "JSON" + json;
    if (!bytes.empty()) {
      number(bytes.size());
      file += std::string_view("BIN\0", 4);
      file += bytes;
    }
    return file;
  }

  const Scene& scene_;
  const RenderScene& ready_;
  const std::vector<Source>& sources_;
  const Assets& assets_;
  const GltfOptions& options_;
  Diagnostics& diagnostics_;
  BakedTextures textures_;
  Bounds box_;
  std::unordered_map<NodeId, Contents> contents_;
  std::unordered_map<std::string, NodeId> templates_;
  std::vector<bool> drawn_;
  std::vector<GltfNode> nodes_;
  std::uint32_t last_root_ = none;
  bool too_large_ = false;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> mesh_numbers_;
  std::map<std::tuple<std::uint32_t, float, float, bool>, GltfGeometry> geometries_;
  std::unordered_map<std::uint32_t, std::uint32_t> material_numbers_;
  std::set<std::string_view> extensions_;
  std::string meshes_;
  std::string materials_;
  std::string lights_;
  GltfBuffer buffer_;
};

}  // namespace

std::string write_gltf(const Scene& scene, const Prepared& ready, const Assets& assets,
                       const GltfOptions& options, Diagnostics& diagnostics) {
  return GltfWriter(scene, ready, assets, options, diagnostics).write();
}

}  // namespace scenefile
