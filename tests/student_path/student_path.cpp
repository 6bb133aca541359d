// A path tracer as a student of the advanced course would write it from the equations, with
// switchable mistakes: scenefile_student_path SCENE OUT.pfm|OUT.png WIDTHxHEIGHT SAMPLES SEED
// [WORD]... Words are mistakes, conventions, or settings such as p=0.8, lights=4, tone=reinhard2.
// Only reads scenes with the library; what it computes is its own.

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/load_file.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using glm::dot;
using glm::dvec3;
constexpr double pi = 3.14159265358979323846;
constexpr double far_away = 1e30;

std::vector<std::string_view> words;  // few: each is asked for at each surface
bool on(std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}
const char* setting(std::string_view name, const char* otherwise) {
  for (const std::string_view word : words) {
    if (word.size() > name.size() && word[name.size()] == '=' && word.starts_with(name)) {
      return word.data() + name.size() + 1;
    }
  }
  return otherwise;
}

struct Ray {
  dvec3 o, d;
};

struct Material {
  dvec3 kd{0}, ks{0}, ke{0};
  double ns = 1, ni = 1;
  int illum = 2;
};

struct Triangle {
  dvec3 p[3], n[3], flat;
  int material = 0;
};

struct Hit {
  double t = far_away;
  const Triangle* tri = nullptr;
  dvec3 p, n, flat;  // n is interpolated; both as in the file, not turned to the ray
};

struct Box {
  dvec3 low{far_away}, high{-far_away};
  void add(const dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

struct Node {
  Box box;
  int first = 0, count = 0, right = 0;  // count 0: the left child follows
  int axis = 0;
};

std::vector<Material> materials;
std::vector<Triangle> triangles;
std::vector<Triangle> lamps;
std::vector<double> lamp_areas;
std::vector<Node> nodes;
double lamp_area = 0;

int build(int first, int end) {
  const int me = static_cast<int>(nodes.size());
  nodes.emplace_back();
  Box box, centers;
  for (int i = first; i < end; ++i) {
    for (const dvec3& p : triangles[i].p) {
      box.add(p);
    }
    centers.add((triangles[i].p[0] + triangles[i].p[1] + triangles[i].p[2]) / 3.0);
  }
  nodes[me].box = box;
  if (end - first <= 4) {
    nodes[me].first = first;
    nodes[me].count = end - first;
    return me;
  }
  const dvec3 size = centers.high - centers.low;
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int middle = (first + end) / 2;
  std::nth_element(triangles.begin() + first, triangles.begin() + middle, triangles.begin() + end,
                   [axis](const Triangle& a, const Triangle& b) {
                     return a.p[0][axis] + a.p[1][axis] + a.p[2][axis] <
                            b.p[0][axis] + b.p[1][axis] + b.p[2][axis];
                   });
  build(first, middle);
  const int right = build(middle, end);
  nodes[me].right = right;
  nodes[me].axis = axis;
  return me;
}

bool hit_box(const Box& b, const Ray& r, const dvec3& inverse, double most) {
  double near = 0, far = most;
  for (int i = 0; i < 3; ++i) {
    double a = (b.low[i] - r.o[i]) * inverse[i], c = (b.high[i] - r.o[i]) * inverse[i];
    if (a > c) {
      std::swap(a, c);
    }
    near = std::max(near, a);
    far = std::min(far, c * (1 + 1e-12));
  }
  return near <= far;
}

bool intersect(const Ray& r, double least, double most, Hit& hit) {
  hit.t = most;
  hit.tri = nullptr;
  const dvec3 inverse = 1.0 / r.d;
  double bu = 0, bv = 0;
  int stack[64], size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes[stack[--size]];
    if (!hit_box(node.box, r, inverse, hit.t)) {
      continue;
    }
    if (node.count == 0) {
      int near = static_cast<int>(&node - nodes.data()) + 1, far = node.right;
      if (r.d[node.axis] < 0) {
        std::swap(near, far);
      }
      stack[size++] = far;
      stack[size++] = near;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = triangles[i];
      const dvec3 e1 = t.p[1] - t.p[0], e2 = t.p[2] - t.p[0], q = cross(r.d, e2);
      const double det = dot(e1, q);
      if (det == 0) {
        continue;
      }
      const dvec3 s = r.o - t.p[0], w = cross(s, e1);
      const double u = dot(s, q) / det, v = dot(r.d, w) / det, d = dot(e2, w) / det;
      if (u >= 0 && v >= 0 && u + v <= 1 && d > least && d < hit.t) {
        hit.t = d;
        hit.tri = &t;
        bu = u;
        bv = v;
      }
    }
  }
  if (hit.tri == nullptr) {
    return false;
  }
  const Triangle& t = *hit.tri;
  hit.p = r.o + hit.t * r.d;
  hit.flat = t.flat;
  hit.n =
      on("flat-normals") ? t.flat : normalize((1 - bu - bv) * t.n[0] + bu * t.n[1] + bv * t.n[2]);
  return true;
}

class Tracer {
 public:
  explicit Tracer(unsigned seed) : random_(seed) {}
  void seed(unsigned value) { random_.seed(value); }
  double uniform() { return std::min(static_cast<double>(random_()) * 0x1p-32, 1 - 0x1p-32); }

  dvec3 radiance(const Ray& r, int depth, bool count_emission) {
    Hit hit;
    if (depth > 80 || !intersect(r, depth == 0 ? 0 : 1e-5, far_away, hit)) {
      return dvec3(0);
    }
    const Material& m = materials[hit.tri->material];
    const bool front = dot(hit.flat, r.d) < 0;
    dvec3 light(0);
    if ((front || on("two-sided")) && (count_emission || on("emission-always"))) {
      light += emission(m);
    }
    if (on("stop-at-lamps") && m.ke != dvec3(0)) {
      return light;
    }
    const int limit = std::atoi(setting("depth", "1000"));
    double p = continue_probability(m);
    if (m.illum == 5 || m.illum == 7) {
      if (depth >= limit || uniform() >= p) {
        return light;
      }
      return light +
             (m.illum == 5 ? mirror(r, hit, m, depth) : glass(r, hit, m, depth)) / chance(p);
    }
    const dvec3 n = dot(hit.n, r.d) < 0 ? hit.n : -hit.n;
    if (limit == 0) {
      return light;
    }
    if (!on("bsdf-only")) {
      light += direct(hit, n, r.d, m, depth);
    }
    if (on("direct-only") || depth + 1 >= limit || uniform() >= p) {
      return light;
    }
    double pdf = 1;
    const dvec3 to = sample_direction(n, pdf);
    double cosine = on("no-clamp") ? dot(n, to) : std::max(0.0, dot(n, to));
    if (on("no-indirect-cosine") || on("no-cosine")) {
      cosine = cosine > 0 ? 1 : 0;
    }
    if (on("indirect-cosine-twice")) {
      cosine *= cosine;
    }
    if (on("no-direction-pdf")) {
      pdf = 1;
    }
    dvec3 factor = bsdf(m, n, r.d, to, false) * cosine / pdf / chance(p);
    if (on("indirect-half")) {
      factor *= 0.5;
    }
    if (on("gray-throughput") || on("mean-throughput")) {
      factor = dvec3(on("mean-throughput") ? (factor.x + factor.y + factor.z) / 3 : gray(factor));
    }
    const dvec3 next = radiance({hit.p, to}, depth + 1, on("bsdf-only"));
    if (on("throughput-replaced")) {
      replaced_ += factor * next;
      return light;
    }
    return light + factor * next;
  }

  // The light of a path. With a throughput that is replaced, not multiplied, each surface's light
  // has only the factor of the surface before it.
  dvec3 light_of(const Ray& r) {
    replaced_ = dvec3(0);
    const dvec3 first = radiance(r, 0, true);
    return first + replaced_;
  }

 private:
  static double gray(const dvec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

  static dvec3 emission(const Material& m) {
    return on("emission-twice") ? 2.0 * m.ke : on("emission-half") ? 0.5 * m.ke : m.ke;
  }

  static double continue_probability(const Material& m) {
    if (on("p-albedo")) {
      const dvec3 c = m.kd + m.ks;
      return m.illum == 5 || m.illum == 7 ? 0.9 : std::clamp(std::max({c.x, c.y, c.z}), 0.05, 0.95);
    }
    return std::atof(setting("p", "0.8"));
  }
  static double chance(double p) {
    return on("no-roulette-weight") ? 1
           : on("roulette-twice")   ? p * p
           : on("roulette-1-p")     ? 1 - p
                                    : p;
  }

  dvec3 turned(const dvec3& local, const dvec3& n) const {
    const dvec3 x = normalize(cross(std::abs(n.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), n));
    return local.x * x + local.y * cross(n, x) + local.z * n;
  }

  dvec3 sample_direction(const dvec3& n, double& pdf) {
    const double a = uniform(), b = on("same-random-number") ? a : uniform();
    const bool cosine = on("cosine") || on("cosine-uniform-pdf");
    double z = cosine ? std::sqrt(a) : a;
    if (on("polar-uniform")) {  // theta uniform instead of its cosine
      z = std::cos(a * pi / 2);
    }
    if (on("whole-sphere")) {
      z = 2 * a - 1;
    }
    const double s = std::sqrt(std::max(0.0, 1 - z * z));
    const dvec3 local(s * std::cos(2 * pi * b), s * std::sin(2 * pi * b), z);
    pdf = cosine ? z / pi : 1 / (2 * pi);
    if (on("cosine-uniform-pdf")) {
      pdf = 1 / (2 * pi);
    }
    if (on("uniform-cosine-pdf")) {
      pdf = z / pi;
    }
    const dvec3 axis = on("wrong-axis") ? dvec3(0, 1, 0) : n;
    const dvec3 to = turned(local, axis);
    return on("wrong-axis") && dot(to, n) < 0 ? -to : to;
  }

  // Without the cosine. `in` goes to the surface, `to` away from it.
  dvec3 bsdf(const Material& m, const dvec3& n, const dvec3& in, const dvec3& to,
             bool is_direct) const {
    dvec3 kd = m.kd;
    if (on("kd-missing-direct") && is_direct) {
      kd = kd == dvec3(0) ? kd : dvec3(1);
    }
    if ((on("kd-twice-direct") && is_direct) || (on("kd-twice-indirect") && !is_direct) ||
        on("kd-twice")) {
      kd *= kd;
    }
    if (on("kd-missing-indirect") && !is_direct) {
      kd = kd == dvec3(0) ? kd : dvec3(1);
    }
    if (on("lobe-alone") && gray(m.ks) > gray(m.kd)) {
      kd = dvec3(0);
    }
    double inv_pi = 1 / pi;
    if (on("no-pi") || (on("no-pi-direct") && is_direct) || (on("no-pi-indirect") && !is_direct)) {
      inv_pi = 1;
    }
    if (on("pi-twice") || (on("pi-twice-direct") && is_direct)) {
      inv_pi /= pi;
    }
    dvec3 value = kd * inv_pi;
    if (m.ks != dvec3(0) && !on("no-glossy")) {
      const dvec3 back = reflect(in, n);
      double along = std::max(0.0, dot(back, to));
      double exponent = m.ns;
      if (on("blinn")) {
        along = std::max(0.0, dot(normalize(to - in), n));
      }
      if (on("ns-half")) {
        exponent /= 2;
      }
      const double scale = on("no-phong-scale") ? 1 : (exponent + 2) / (2 * pi);
      value += m.ks * scale * std::pow(along, exponent);
    }
    return value;
  }

  dvec3 direct(const Hit& hit, const dvec3& n, const dvec3& in, const Material& m, int depth) {
    const int count = std::atoi(setting("lights", "1"));
    dvec3 sum(0);
    const int all = static_cast<int>(lamps.size());
    for (int i = 0; i < count; ++i) {
      if (on("all-lamps")) {
        for (int k = 0; k < all; ++k) {
          sum += from_lamp(hit, n, in, m, k, 1);
        }
      } else if (on("by-area")) {
        double place = uniform() * lamp_area;
        int k = 0;
        while (k + 1 < all && place >= lamp_areas[k]) {
          place -= lamp_areas[k++];
        }
        sum += from_lamp(hit, n, in, m, k, lamp_area / lamp_areas[k]);
      } else {
        const int k =
            on("first-lamp-only") ? 0 : std::min(all - 1, static_cast<int>(uniform() * all));
        sum += from_lamp(hit, n, in, m, k, on("no-choice-pdf") || on("first-lamp-only") ? 1 : all);
      }
    }
    (void)depth;
    if (on("direct-twice")) {
      sum *= 2.0;
    }
    return on("lights-summed")          ? sum
           : on("lights-divided-twice") ? sum / double(count * count)
                                        : sum / double(count);
  }

  dvec3 from_lamp(const Hit& hit, const dvec3& n, const dvec3& in, const Material& m, int k,
                  double weight) {
    const Triangle& lamp = lamps[k];
    double u = uniform(), v = uniform();
    if (on("triangle-corner")) {
      v *= 1 - u;  // too many near the first edge
    } else if (on("triangle-normalized")) {
      const double w = uniform(), all = u + v + w;
      u /= all;
      v /= all;
    } else if (u + v > 1 && !on("parallelogram")) {
      u = 1 - u;
      v = 1 - v;
    }
    if (on("lamp-center")) {
      u = v = 1.0 / 3;
    }
    const dvec3 at = lamp.p[0] + u * (lamp.p[1] - lamp.p[0]) + v * (lamp.p[2] - lamp.p[0]);
    const dvec3 path = at - hit.p;
    const double d = length(path);
    const dvec3 to = path / d;
    double cosine = dot(n, to), lamp_cosine = -dot(lamp.flat, to);
    if (on("two-sided") || on("lamp-cosine-abs")) {
      lamp_cosine = std::abs(lamp_cosine);
    }
    if (on("no-facing-test")) {
      cosine = std::abs(cosine);
    }
    if (cosine <= 0 || lamp_cosine <= 0) {
      return dvec3(0);
    }
    Hit blocker;
    const double start = on("shadow-self") ? -1e-7 : 1e-5;
    const double end = on("shadow-lamp") ? d * (1 + 1e-7) : d * (1 - 1e-6);
    if (on("shadow-self")) {
      if (intersect({hit.p + 1e-9 * (uniform() - 0.5) * n, to}, 0, end, blocker)) {
        return dvec3(0);
      }
    } else if (!on("no-visibility") && intersect({hit.p, to}, start, end, blocker)) {
      return dvec3(0);
    }
    if (on("no-direct-cosine") || on("no-cosine")) {
      cosine = 1;
    }
    if (on("cosine-twice")) {
      cosine *= cosine;
    }
    if (on("no-lamp-cosine")) {
      lamp_cosine = 1;
    }
    const double falloff = on("falloff-d")    ? d
                           : on("no-falloff") ? 1
                           : on("falloff-d3") ? d * d * d
                                              : d * d;
    const double area = on("no-area")        ? 1
                        : on("area-inverse") ? 1 / lamp_areas[k]
                        : on("area-twice")   ? 2 * lamp_areas[k]
                                             : lamp_areas[k];
    const dvec3 ke = on("no-ke") ? dvec3(1) : emission(materials[lamp.material]);
    return ke * bsdf(m, n, in, to, true) * cosine * lamp_cosine / falloff * area * weight;
  }

  dvec3 mirror(const Ray& r, const Hit& hit, const Material& m, int depth) {
    if (on("mirror-black")) {
      return dvec3(0);
    }
    const dvec3 n = dot(hit.n, r.d) < 0 ? hit.n : -hit.n;
    const dvec3 light =
        radiance({hit.p, normalize(reflect(r.d, n))}, depth + 1,
                 !on("no-emission-after-mirror") && !on("no-emission-after-specular"));
    return (on("mirror-no-ks") ? dvec3(1) : m.ks) * light *
           (on("mirror-cosine") ? -dot(n, r.d) : 1.0);
  }

  dvec3 glass(const Ray& r, const Hit& hit, const Material& m, int depth) {
    const bool enters = dot(hit.n, r.d) < 0;
    const dvec3 n = enters ? hit.n : -hit.n;
    double eta = enters ? 1 / m.ni : m.ni;
    if (on("eta-inverted")) {
      eta = 1 / eta;
    }
    if (on("eta-always-in")) {
      eta = 1 / m.ni;
    }
    const double c = -dot(n, r.d);
    const double k = 1 - eta * eta * (1 - c * c);
    double f = 1;
    if (k > 0) {
      const double ct = std::sqrt(k);
      const double rs = (eta * c - ct) / (eta * c + ct), rp = (c - eta * ct) / (c + eta * ct);
      f = (rs * rs + rp * rp) / 2;
      if (on("schlick")) {
        const double r0 = std::pow((1 - m.ni) / (1 + m.ni), 2);
        f = r0 + (1 - r0) * std::pow(1 - (enters ? c : ct), 5);
      }
      if (on("schlick-inside")) {  // the angle of the ray inside, also when it leaves
        const double r0 = std::pow((1 - m.ni) / (1 + m.ni), 2);
        f = r0 + (1 - r0) * std::pow(1 - c, 5);
      }
    } else if (on("no-total-reflection")) {
      return dvec3(0);
    } else if (on("total-reflection-nan")) {
      return dvec3(std::sqrt(-1.0));
    }
    double choose = f;
    if (on("no-fresnel") && k > 0) {
      choose = f = 0;
    }
    if (on("fresnel-half") && k > 0) {
      choose = 0.5;
    }
    const bool reflects = uniform() < choose;
    double weight = 1;
    if (on("fresnel-twice") && k > 0) {
      weight = reflects ? f : 1 - f;
    }
    const dvec3 to =
        reflects ? reflect(r.d, n) : eta * r.d + (eta * c - std::sqrt(std::max(0.0, k))) * n;
    if (on("glass-half")) {
      weight *= 0.5;
    }
    return weight * radiance({hit.p, normalize(to)}, depth + 1,
                             !on("no-emission-after-glass") && !on("no-emission-after-specular"));
  }

  std::mt19937 random_;
  dvec3 replaced_{0};
};

void add_mesh(const scenefile::Assets& assets, std::uint32_t mesh_index,
              const scenefile::Affine& map) {
  const scenefile::Mesh& mesh = assets.meshes[mesh_index];
  const scenefile::MeshMaterials& list = assets.mesh_materials[mesh_index];
  const int base = static_cast<int>(materials.size());
  for (const scenefile::FaceMaterial& f : list.materials) {
    Material m;
    m.kd = f.diffuse;
    m.ks = f.specular;
    m.ke = f.emission;
    m.ns = f.shininess;
    m.ni = f.ior;
    m.illum = f.illum;
    materials.push_back(m);
  }
  const glm::mat3 normals = glm::transpose(glm::inverse(map.linear));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (list.of_triangle.empty() || list.of_triangle[i] == scenefile::mesh_no_index) {
      continue;
    }
    Triangle t;
    for (int k = 0; k < 3; ++k) {
      t.p[k] = map.point(mesh.positions[mesh.triangles[i][k]]);
    }
    const dvec3 across = cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
    if (length(across) == 0) {
      continue;
    }
    t.flat = normalize(across);
    const bool smooth =
        !mesh.triangle_normals.empty() && mesh.triangle_normals[i][0] != scenefile::mesh_no_index;
    for (int k = 0; k < 3; ++k) {
      t.n[k] =
          smooth ? normalize(dvec3(normals * mesh.normals[mesh.triangle_normals[i][k]])) : t.flat;
    }
    t.material = base + static_cast<int>(list.of_triangle[i]);
    triangles.push_back(t);
    if (materials[t.material].ke != dvec3(0)) {
      lamps.push_back(t);
      lamp_areas.push_back(length(across) / 2);
      lamp_area += lamp_areas.back();
    }
  }
}

void add_group(const scenefile::RenderScene& scene, const scenefile::Assets& assets,
               std::uint32_t group, const scenefile::Affine& map) {
  for (const scenefile::RenderPrimitive& p : scene.groups[group].primitives) {
    if (p.shape == scenefile::Shape::mesh) {
      add_mesh(assets, p.mesh, map * p.group_from_object);
    }
  }
  for (const scenefile::RenderInstance& i : scene.groups[group].instances) {
    add_group(scene, assets, i.group, map * i.group_from_instance);
  }
}

// The tone curves of students.
void to_screen(scenefile::Image& image, const std::string& tone, double exposure) {
  double white = 0;
  const auto gray = [](const float* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; };
  for (float& v : image.rgb) {
    v = std::isfinite(v) ? static_cast<float>(v * exposure) : 0;
  }
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    white = std::max(white, gray(&image.rgb[i]));
  }
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    float* p = &image.rgb[i];
    const double bright = gray(p);
    for (int c = 0; c < 3; ++c) {
      double v = std::max(0.0, static_cast<double>(p[c]));
      if (tone == "course") {
        v = std::sqrt(v * (1 + bright / (white * white)) / (1 + bright));
      } else if (tone == "reinhard22") {
        v = std::pow(v / (1 + v), 1 / 2.2);
      } else if (tone == "clamp22") {
        v = std::pow(std::min(1.0, v), 1 / 2.2);
      } else if (tone == "clamp2") {
        v = std::sqrt(std::min(1.0, v));
      } else if (tone == "srgb") {
        v = std::min(1.0, v);
        v = v < 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
      }
      if (on("gamma-twice")) {
        v = std::pow(std::max(0.0, v), 1 / 2.2);
      }
      p[c] = static_cast<float>(v);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr,
                 "usage: scenefile_student_path SCENE OUT WIDTHxHEIGHT SAMPLES SEED [WORD]...\n");
    return 2;
  }
  words.assign(argv + 6, argv + argc);
  int width = 0, height = 0;
  if (std::sscanf(argv[3], "%dx%d", &width, &height) != 2) {
    return 2;
  }
  const int samples = std::atoi(argv[4]);
  const unsigned seed = static_cast<unsigned>(std::atoi(argv[5]));
  scenefile::LoadSettings settings;
  settings.materials = true;
  const scenefile::LoadedScene scene = scenefile::load_scene_file(argv[1], settings);
  if (!scene.usable()) {
    std::fprintf(stderr, "cannot use %s\n", argv[1]);
    return 1;
  }
  add_group(scene.ready.scene, scene.assets, scene.ready.scene.root, {});
  if (triangles.empty() || lamps.empty()) {
    std::fprintf(stderr, "no meshes, or no lamps\n");
    return 1;
  }
  build(0, static_cast<int>(triangles.size()));
  const scenefile::RenderCamera& camera = scene.ready.scene.camera;
  const double tangent = on("angle-whole")
                             ? std::tan(camera.fov_y)
                             : std::tan(camera.fov_y / 2 * std::atof(setting("angle", "1")));
  scenefile::Image image(width, height);
  Tracer tracer(seed * 7919u + 1);
  const int grid = std::max(1, static_cast<int>(std::sqrt(samples)));
  const double clamp = std::atof(setting("clamp", "0"));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      dvec3 sum(0);
      if (on("same-seed")) {
        tracer.seed(seed + 1);
      }
      for (int i = 0; i < samples; ++i) {
        double dx = tracer.uniform(), dy = tracer.uniform();
        if (on("stratified")) {
          dx = (i % grid + dx) / grid;
          dy = (i / grid % grid + dy) / grid;
        }
        if (on("corners")) {
          dx = dy = 0;
        } else if (on("centers")) {
          dx = dy = 0.5;
        } else if (on("jitter-corner")) {
          dx -= 0.5;
          dy -= 0.5;
        }
        const double a = (2 * (x + dx) / width - 1) * tangent * width / height;
        const double b = (1 - 2 * (y + dy) / height) * tangent;
        dvec3 light =
            tracer.light_of({camera.position, normalize(-camera.w + a * camera.u + b * camera.v)});
        if (clamp > 0) {
          light = glm::min(light, dvec3(clamp));
        }
        sum += light;
      }
      if (on("divide-less")) {
        sum *= 1.25;
      }
      for (int c = 0; c < 3; ++c) {
        image.pixel(x, y)[on("bgr") ? 2 - c : c] = static_cast<float>(sum[c] / samples);
      }
    }
  }
  const std::string out = argv[2];
  const bool linear = out.ends_with(".pfm");
  const std::string tone = setting("tone", linear ? "none" : "course");
  if (!linear || tone != "none" || on("gamma-twice")) {
    to_screen(image, tone, std::atof(setting("exposure", "1")));
  }
  const auto bytes = scenefile::encode_image(
      image, linear ? scenefile::ImageFormat::pfm : scenefile::ImageFormat::png8,
      scenefile::Rounding::nearest);
  return bytes && scenefile::write_file(out, *bytes) ? 0 : 3;
}
