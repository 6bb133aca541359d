// Pixels of mode path, as text and JSON.

#include "scenefile/base/shape_traits.h"
#include "scenefile/base/text.h"
#include "scenefile/verbs/explain_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace scenefile {

namespace {

// Indexed by BsdfLobe and PathEnd.
constexpr std::array<std::string_view, 6> lobe_names{"none",   "diffuse",    "glossy",
                                                     "mirror", "reflection", "refraction"};
constexpr std::array<std::string_view, 5> end_names{"none", "direct-only", "max-depth", "absorbed",
                                                    "roulette"};

std::string_view word_of(BsdfLobe lobe) {
  return lobe_names[static_cast<std::size_t>(lobe)];
}

const FaceMaterial* face_material(const LoadedScene& scene, const PathVertex& vertex) {
  return vertex.point.material == mesh_no_index
             ? nullptr
             : &scene.assets.mesh_materials[vertex.mesh].materials[vertex.point.material];
}

class PathText {
 public:
  PathText(const LoadedScene& scene, const PathPixel& pixel, const ExplainStyle& style)
      : loaded_(scene),
        scene_(scene.ready.scene),
        pixel_(pixel),
        path_(pixel.path),
        style_(style),
        names_(scene.written, scene.ready.sources) {}

  std::string text(const std::optional<PathNeighborhood>& around) const {
    ExplainItem top(fmt::format("{}, pixel {},{} of {}x{}, mode path\n",
                                escaped(shown_name(loaded_.path)), pixel_.x, pixel_.y,
                                pixel_.options.width, pixel_.options.height));
    const auto& [red, green, blue] = pixel_.picture;
    const double error = pixel_.standard_error;
    top.add(fmt::format("{} {}, the mean of the samples before tone mapping; standard error {}",
                        bold("color"), color({red, green, blue}),
                        std::isfinite(error) ? fmt::format("{:.2g}", error) : "unknown"));
    if (around) {
      add_around(top, *around);
    }
    add_samples(top);
    add_path(top);
    return top.text + tree_text(top);
  }

 private:
  std::string bold(std::string_view text) const { return bold_text(text, style_); }
  std::string color(const Color& c) const { return color_text(c, style_); }
  std::string object(const ObjectRef& ref) const { return object_text(names_, ref); }

  void add_around(ExplainItem& top, const PathNeighborhood& n) const {
    ExplainItem& item = top.add(fmt::format(
        "{} at {},{}..{},{}: {}", bold("yours"), n.block.x0, n.block.y0, n.block.x1 - 1,
        n.block.y1 - 1,
        n.mine ? fmt::format("{}, {:.1f} standard errors {} (up to {:.1f} by chance)",
                             color(*n.mine), std::abs(n.significance),
                             n.significance < 0 ? "darker" : "brighter", n.verdict.critical)
               : std::string("not compared: black in both, clipped, or near a visible lamp")));
    ExplainItem& truth = item.add(
        fmt::format("the truth {}, with an error of {:.2g}{}", color(n.truth), n.truth_error,
                    n.mine ? fmt::format("; of the difference {:.2g}", n.error) : std::string()));
    for (const PathTerm& term : n.terms) {
      truth.add(fmt::format("{} {}", term.name, color(term.light)));
    }
    const std::string lines = path_verdict_text(n.verdict);
    for (std::string_view rest = lines; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
      if (const std::string_view line = rest.substr(0, rest.find('\n')); !line.starts_with(' ')) {
        item.add(std::string(line));
      }
    }
  }

  void add_samples(ExplainItem& top) const {
    const std::size_t count = pixel_.samples.size();
    ExplainItem& item = top.add(fmt::format("{} {}", bold("samples"), count));
    for (std::size_t i = 0; i < std::min(count, max_explained_samples); ++i) {
      const PathSample& s = pixel_.samples[i];
      item.add(fmt::format("{:>2} at {:.4f},{:.4f}{}: {}, {}{}", i, s.point.x, s.point.y,
                           lens_text(s.lens), color(s.light), counted(s.surfaces, "surface"),
                           i == pixel_.shown ? "  <- shown" : ""));
    }
    if (count > max_explained_samples) {
      item.add(fmt::format("and {} more", count - max_explained_samples));
    }
  }

  static std::string lens_text(const glm::dvec2& lens) {
    return lens == glm::dvec2(0)
               ? std::string()
               : fmt::format(" through the lens at {:.3f},{:.3f}", lens.x, lens.y);
  }

  void add_path(ExplainItem& top) const {
    ExplainItem& item =
        top.add(fmt::format("{} {}: {}", bold("sample"), pixel_.shown, color(path_.light)));
    for (std::size_t i = 0; i < path_.vertices.size(); ++i) {
      add_vertex(item, i);
    }
    if (path_.escaped) {
      item.add(fmt::format("from {} along {}: hits nothing, the background is black",
                           vector_text(path_.last.origin), vector_text(path_.last.direction)));
    }
    item.add(fmt::format(
        "{} {} = {} reflected or refracted at most once, plus {}{}", bold("sum"),
        color(path_.light), color_text(path_.direct), color_text(path_.indirect),
        path_.clamp == 1 ? std::string() : fmt::format(" times {:.4g} by --clamp", path_.clamp)));
  }

  void add_vertex(ExplainItem& sample, std::size_t index) const {
    const PathVertex& v = path_.vertices[index];
    ExplainItem& item = sample.add(fmt::format(
        "{} {}: hits {} {} at t = {:.6g}{}", bold("vertex"), index, scenefile::word_of(v.shape),
        bold(object(pixel_.objects[index])), v.t, v.point.facing.outside ? "" : ", from inside"));
    item.add(
        fmt::format("from {} along {}", vector_text(v.ray.origin), vector_text(v.ray.direction)));
    item.add(fmt::format("point {}, normal {}{}", vector_text(v.point.position),
                         vector_text(v.point.facing.normal),
                         v.point.facing.normal == v.point.facing.geometric
                             ? std::string()
                             : ", of the face " + vector_text(v.point.facing.geometric)));
    add_material(item, v);
    if (v.point.emission != Color(0)) {
      add_emission(item, v);
    }
    for (std::uint32_t i = 0; i < v.lights; ++i) {
      add_light(item, v.first_light + i);
    }
    item.add(fmt::format("{} throughput {} times {} = {}", bold("adds"), color_text(v.throughput),
                         color_text(v.emission + v.light),
                         color(v.throughput * v.emission + v.throughput * v.light)));
    add_next(item, v);
  }

  void add_material(ExplainItem& item, const PathVertex& v) const {
    std::string text;
    if (v.shape == Shape::mesh) {
      text = fmt::format("triangle {} of {}", v.point.triangle,
                         escaped(scene_.mesh_files[v.mesh].name));
    }
    if (const FaceMaterial* const m = face_material(loaded_, v)) {
      text += fmt::format(", material {} ({}:{}), illum {}", escaped(m->name, 80),
                          escaped(m->file, 80), m->location.line, m->illum);
    }
    if (!text.empty()) {
      item.add(text);
    }
    const Bsdf& bsdf = v.point.bsdf;
    const auto add = [&](const Color& c, std::string_view name, const std::string& more) {
      if (c != Color(0)) {
        item.add(fmt::format("{} {}{}", name, color(c), more));
      }
    };
    add(bsdf.diffuse, "diffuse", "");
    add(bsdf.glossy, "glossy", fmt::format(", exponent {:.6g}", bsdf.shininess));
    add(bsdf.mirror, "mirror", "");
    add(bsdf.glass, "glass", fmt::format(", index of refraction {:.6g}", bsdf.ior));
  }

  void add_emission(ExplainItem& item, const PathVertex& v) const {
    std::string why;
    if (v.emission_density > 0) {
      why = pixel_.options.mis && pixel_.options.convention == Convention::physics
                ? fmt::format(
                      ": this direction has density {:.6g} by the BSDF, {:.6g} by light "
                      "samples",
                      v.ray_density, v.emission_density)
                : std::string(": light samples find it");
    }
    item.add(fmt::format("{} {} times weight {:.4g} = {}{}", bold("emission"),
                         color_text(v.point.emission), v.emission_weight, color(v.emission), why));
  }

  void add_light(ExplainItem& vertex, std::size_t index) const {
    const PathLight& l = path_.lights[index];
    std::string name = "lamp";
    if (l.light != no_index) {
      const RenderLight& light = scene_.lights[l.light];
      name = fmt::format("{} light{}", scenefile::word_of(light.type),
                         place_text(names_.at(light.source).location));
    }
    ExplainItem& item = vertex.add(fmt::format("{} {}", bold(name), color(l.contribution)));
    if (l.emission == Color(0)) {
      item.add(l.light != no_index ? "none arrives here"
               : l.lamp_cosine > 0 ? "the lamp is black there"
                                   : "the chosen point faces away");
      return;
    }
    item.add(fmt::format("along {}, distance {:.6g}: {} {}", vector_text(l.to_light), l.distance,
                         l.light == no_index ? "emits" : "light", color(l.emission)));
    item.add(fmt::format("BSDF times cosine {}", color(l.reflected)));
    item.add(l.light == no_index
                 ? fmt::format("density {:.6g} by light samples, {:.6g} by the BSDF: weight {:.4g}",
                               l.density, l.bsdf_density, l.weight)
                 : fmt::format("divided by {:.6g}: samples of it per light", l.density));
    if (l.shadow_ray) {
      item.add(fmt::format("shadow leaves {}{}", color_text(l.visibility),
                           pixel_.occluders[index]
                               ? ": occluded by " + object(*pixel_.occluders[index])
                               : std::string(": no occluder")));
    }
  }

  void add_next(ExplainItem& item, const PathVertex& v) const {
    switch (v.end) {
      case PathEnd::direct_only:
        item.add("the path ends: only direct light is wanted");
        return;
      case PathEnd::max_depth:
        item.add("the path ends: the maximum depth is reached");
        return;
      case PathEnd::none:
      case PathEnd::absorbed:
      case PathEnd::roulette:
        break;
    }
    if (v.next.lobe == BsdfLobe::none) {
      item.add("the path ends: the surface reflects nothing");
      return;
    }
    item.add(fmt::format(
        "{} {} along {}: {} {} / {} {:.6g} = {}", bold("continues"), word_of(v.next.lobe),
        vector_text(v.next.to_light), v.next.specular() ? "factor" : "BSDF times cosine",
        color_text(v.next.bsdf_cosine), v.next.specular() ? "probability" : "density",
        v.next.density, color(v.next.weight)));
    if (v.end == PathEnd::absorbed) {
      item.add("the path ends: no light can come from there");
    } else if (v.continuation != 1) {
      item.add(fmt::format("roulette: goes on with probability {:.4g}{}", v.continuation,
                           v.end == PathEnd::roulette ? ", and ends here" : ""));
    }
  }

  const LoadedScene& loaded_;
  const RenderScene& scene_;
  const PathPixel& pixel_;
  const PathRecord& path_;
  ExplainStyle style_;
  ObjectNames names_;
};

class PathDocument {
 public:
  PathDocument(Json& json, const LoadedScene& scene, const PathPixel& pixel)
      : json_(json), loaded_(scene), pixel_(pixel), names_(scene.written, scene.ready.sources) {}

  void add_pixel(const std::optional<PathNeighborhood>& around) {
    const PathRecord& path = pixel_.path;
    json_.begin_object("pixel");
    json_.add({{"x", pixel_.x},
               {"y", pixel_.y},
               {"color", pixel_.picture},
               {"standard_error", pixel_.standard_error}});
    json_.add_objects("samples", pixel_.samples, [&](const PathSample& s) {
      json_.add(
          {{"point", s.point}, {"lens", s.lens}, {"color", s.light}, {"surfaces", s.surfaces}});
    });
    json_.add("shown", pixel_.shown);
    if (around) {
      add_around(*around);
    }
    json_.begin_object("path");
    json_.add_objects("vertices", path.vertices, [&](const PathVertex& v) {
      add_vertex(v, pixel_.objects[std::size_t(&v - path.vertices.data())]);
    });
    if (path.escaped) {
      add_line(json_, "escapes", path.last);
    }
    json_.add({{"direct", path.direct},
               {"indirect", path.indirect},
               {"clamp", path.clamp},
               {"color", path.light}});
    json_.end_object();
    json_.end_object();
  }

 private:
  void add_around(const PathNeighborhood& n) {
    json_.begin_object("yours");
    json_.add("block", std::array{n.block.x0, n.block.y0, n.block.x1, n.block.y1});
    if (n.mine) {
      json_.add(
          {{"color", *n.mine}, {"standard_error", n.error}, {"significance", n.significance}});
    }
    json_.add({{"truth", n.truth}, {"truth_error", n.truth_error}});
    json_.add_objects("terms", n.terms, [&](const PathTerm& term) {
      json_.add({{"name", term.name}, {"color", term.light}});
    });
    json_.begin_object("picture");
    add_path_verdict(json_, n.verdict);
    json_.end_object();
    json_.end_object();
  }

  void add_vertex(const PathVertex& v, const ObjectRef& object) {
    add_object(json_, names_, object);
    json_.add("shape", scenefile::word_of(v.shape));
    if (v.shape == Shape::mesh) {
      json_.add(
          {{"mesh", loaded_.ready.scene.mesh_files[v.mesh].name}, {"triangle", v.point.triangle}});
    } else {
      json_.add("face", face_words[static_cast<std::size_t>(v.face)]);
    }
    add_line(json_, "ray", v.ray);
    json_.add({{"start", v.start},
               {"ray_density", v.ray_density},
               {"t", v.t},
               {"position", v.point.position},
               {"normal", v.point.facing.normal},
               {"geometric_normal", v.point.facing.geometric},
               {"outside", v.point.facing.outside}});
    add_material(v);
    json_.add("throughput", v.throughput);
    json_.add_object("emission", {{"radiance", v.point.emission},
                                  {"density", v.emission_density},
                                  {"weight", v.emission_weight},
                                  {"contribution", v.emission}});
    json_.add_objects("lights", std::span(pixel_.path.lights).subspan(v.first_light, v.lights),
                      [&](const PathLight& light) { add_light(light); });
    json_.add({{"light", v.light}, {"end", end_names[static_cast<std::size_t>(v.end)]}});
    if (v.next.lobe != BsdfLobe::none) {
      json_.add_object("next", {{"lobe", word_of(v.next.lobe)},
                                {"direction", v.next.to_light},
                                {"bsdf_cosine", v.next.bsdf_cosine},
                                {"density", v.next.density},
                                {"weight", v.next.weight},
                                {"continuation", v.continuation}});
    }
  }

  void add_material(const PathVertex& v) {
    const Bsdf& bsdf = v.point.bsdf;
    json_.begin_object("material");
    if (const FaceMaterial* const m = face_material(loaded_, v)) {
      json_.add(
          {{"name", m->name}, {"file", m->file}, {"line", m->location.line}, {"illum", m->illum}});
    }
    json_.add({{"diffuse", bsdf.diffuse},
               {"glossy", bsdf.glossy},
               {"shininess", bsdf.shininess},
               {"mirror", bsdf.mirror},
               {"glass", bsdf.glass},
               {"ior", bsdf.ior}});
    json_.end_object();
  }

  void add_light(const PathLight& l) {
    if (l.light != no_index) {
      const RenderLight& light = loaded_.ready.scene.lights[l.light];
      json_.add({{"light", l.light},
                 {"type", scenefile::word_of(light.type)},
                 {"line", names_.at(light.source).location.line}});
    } else {
      json_.add("type", "lamp");
    }
    json_.add({{"to_light", l.to_light},
               {"distance", l.distance},
               {"emission", l.emission},
               {"bsdf_cosine", l.reflected},
               {"density", l.density},
               {"bsdf_density", l.bsdf_density},
               {"weight", l.weight},
               {"unshadowed", l.unshadowed},
               {"shadow_ray", l.shadow_ray},
               {"visibility", l.visibility}});
    if (const auto& occluder = pixel_.occluders[std::size_t(&l - pixel_.path.lights.data())]) {
      json_.begin_object("occluder");
      add_object(json_, names_, *occluder);
      json_.end_object();
    }
    json_.add("contribution", l.contribution);
  }

  Json& json_;
  const LoadedScene& loaded_;
  const PathPixel& pixel_;
  ObjectNames names_;
};

}  // namespace

std::string explain_path_text(const LoadedScene& scene, const ExplainReport& report,
                              const ExplainStyle& style) {
  return PathText(scene, *report.path, style).text(report.around);
}

void add_path_pixel(Json& json, const LoadedScene& scene, const ExplainReport& report) {
  PathDocument(json, scene, *report.path).add_pixel(report.around);
}

}  // namespace scenefile
