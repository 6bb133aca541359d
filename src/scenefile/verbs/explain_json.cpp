#include "scenefile/verbs/explain_tree.h"
#include "scenefile/verbs/scene_json.h"

#include <array>

namespace scenefile {

namespace {

constexpr std::array<std::string_view, 3> ray_names{"camera", "reflected", "refracted"};
constexpr std::array<std::string_view, 5> fate_names{"absent", "followed", "too-deep", "too-faint",
                                                     "too-many"};
constexpr std::array<std::string_view, 3> unlit_names{"", "light-of-another-mode",
                                                      "light-out-of-reach"};

template <typename T, std::size_t n>
std::string_view name_of(const std::array<std::string_view, n>& names, T value) {
  return names[static_cast<std::size_t>(value)];
}

void add_pair(Json& json, std::string_view name, const glm::dvec2& v) {
  json.begin_array(name);
  json.value(v.x);
  json.value(v.y);
  json.end_array();
}

void add_index(Json& json, std::string_view name, std::uint32_t index) {
  if (index != no_index) {
    json.add(name, index);
  }
}

class Document {
 public:
  Document(Json& json, const LoadedScene& scene)
      : json_(json), scene_(scene.ready.scene), names_(scene.written, scene.ready.sources) {}

  void add_pixel(const ExplainReport& report) {
    const PixelRecord& pixel = report.pixel;
    tessellated_ = report.realtime.has_value();
    json_.begin_object("pixel");
    json_.add("x", pixel.x);
    json_.add("y", pixel.y);
    json_.add("color", pixel.color);
    json_.begin_array("value");
    for (const std::uint8_t v : pixel.value) {
      json_.value(v);
    }
    json_.end_array();
    add_more(pixel);
    json_.begin_array("samples");
    for (std::size_t i = 0; i < pixel.samples.size(); ++i) {
      add_sample(pixel.samples[i], report.realtime ? &report.realtime->pixel.shares[i] : nullptr);
    }
    json_.end_array();
    json_.add("shown", pixel.shown);
    json_.begin_array("rays");
    for (const RayRecord& ray : pixel.rays) {
      add_ray(ray);
    }
    json_.end_array();
    add_remarks(report.remarks);
    if (report.yours) {
      add_yours(*report.yours, report.compared);
    }
    json_.end_object();
  }

 private:
  void add_more(const PixelRecord& pixel) {
    if (pixel.options.profile == Profile::fine && !tessellated_) {
      json_.begin_object("more_samples_because");
      json_.add("noisy", pixel.more.noisy);
      json_.add("penumbra", pixel.more.penumbra);
      json_.add("neighbors", pixel.more.neighbors);
      json_.end_object();
    }
  }

  void add_sample(const SampleRecord& sample, const RealtimeFramePixel* share) {
    json_.begin_object();
    if (share != nullptr) {
      add_pair(json_, "frame_pixel", share->at);
      json_.add("weight", share->weight);
    }
    add_pair(json_, "point", sample.point);
    add_pair(json_, "lens", sample.lens);
    json_.add("color", sample.color);
    json_.add("rays", sample.rays);
    json_.add("refined", sample.refined);
    add_index(json_, "refines", sample.refines);
    if (sample.object.has_value()) {
      json_.add("object", names_.text(*sample.object));
    }
    json_.end_object();
  }

  void add_object(const ObjectRef& object) { scenefile::add_object(json_, names_, object); }

  void add_line(std::string_view name, const Ray& ray) {
    json_.begin_object(name);
    json_.add("origin", ray.origin);
    json_.add("direction", ray.direction);
    json_.end_object();
  }

  void add_ray(const RayRecord& ray) {
    json_.begin_object();
    json_.add("kind", name_of(ray_names, ray.kind));
    add_index(json_, "parent", ray.parent);
    json_.add("depth", ray.depth);
    json_.add("weight", ray.weight);
    add_line("ray", ray.ray);
    json_.add("start", ray.start);
    json_.add("total_reflection", ray.total_reflection);
    json_.begin_array("walls");
    for (const WallRecord& wall : ray.walls) {
      add_wall(wall);
    }
    json_.end_array();
    json_.add("trapped", ray.trapped);
    if (ray.surface.has_value()) {
      add_surface(*ray.surface);
      json_.add("ambient", ray.ambient);
      json_.begin_array("lights");
      for (const LightRecord& light : ray.lights) {
        add_light(light);
      }
      json_.end_array();
      json_.add("local", ray.local);
      add_branch("reflected", ray.mirror);
      add_branch("refracted", ray.glass);
    }
    json_.add("sum", ray.sum);
    json_.add("color", ray.color);
    json_.end_object();
  }

  void add_wall(const WallRecord& wall) {
    json_.begin_object();
    add_object(wall.object);
    json_.add("t", wall.t);
    json_.add("position", wall.position);
    json_.add("normal", wall.normal);
    json_.add("direction", wall.direction);
    json_.add("mirrored", wall.mirrored);
    json_.end_object();
  }

  void add_surface(const SurfaceRecord& s) {
    json_.begin_object("surface");
    add_object(s.object);
    json_.add("shape", word_of(s.shape));
    if (s.shape == Shape::mesh) {
      json_.add("mesh", scene_.mesh_files[s.mesh].name);
    }
    if (s.shape == Shape::mesh || tessellated_) {
      json_.add("triangle", s.triangle);
    } else {
      json_.add("face", name_of(face_words, s.face));
    }
    json_.add("t", s.t);
    add_line("ray", s.ray);
    add_line("object_ray", s.object_ray);
    json_.add("position", s.position);
    json_.add("object_position", s.object_position);
    json_.add("normal", s.normal);
    json_.add("geometric_normal", s.geometric);
    json_.add("object_normal", s.object_normal);
    json_.add("bumped", s.bumped);
    if (s.has_uv) {
      add_pair(json_, "uv", s.uv);
    }
    add_texture(s);
    json_.add("diffuse_color", s.diffuse_color);
    json_.add("specular_color", s.specular_color);
    json_.end_object();
  }

  void add_texture(const SurfaceRecord& s) {
    if (!s.texture.has_value()) {
      return;
    }
    json_.begin_object("texture");
    json_.add("file", scene_.texture_files[s.texture->file].name);
    json_.begin_array("texel");
    json_.value(s.texture->texel.x);
    json_.value(s.texture->texel.y);
    json_.end_array();
    json_.add("texel_color", s.texture->texel_color);
    json_.add("color", s.texture->color);
    json_.add("blend", s.texture->blend);
    json_.end_object();
  }

  void add_light(const LightRecord& record) {
    const RenderLight& light = scene_.lights[record.light];
    json_.begin_object();
    json_.add("light", record.light);
    json_.add("type", word_of(light.type));
    json_.add("line", names_.at(light.source).location.line);
    if (record.unlit != Unlit::no) {
      json_.add("unlit", name_of(unlit_names, record.unlit));
    }
    json_.add("taken", record.taken);
    json_.begin_array("samples");
    for (const LightSample& sample : record.samples) {
      add_light_sample(sample);
    }
    json_.end_array();
    json_.add("contribution", record.contribution);
    json_.end_object();
  }

  void add_light_sample(const LightSample& l) {
    json_.begin_object();
    json_.add("to_light", l.to_light);
    json_.add("distance", l.distance);
    json_.add("attenuation", l.attenuation);
    json_.add("spot_factor", l.spot_factor);
    json_.add("color", l.color);
    json_.add("n_dot_l", l.n_dot_l);
    json_.add("r_dot_v", l.r_dot_v);
    json_.add("diffuse", l.diffuse);
    json_.add("specular", l.specular);
    json_.add("shadow_ray", l.shadow_ray);
    json_.add("visibility", l.visibility);
    json_.begin_array("blockers");
    for (const Blocker& blocker : l.blockers) {
      json_.begin_object();
      add_object(blocker.object);
      json_.add("t", blocker.t);
      json_.add("passes", blocker.passes);
      json_.add("itself", blocker.itself);
      json_.end_object();
    }
    json_.end_array();
    json_.add("contribution", l.contribution);
    json_.end_object();
  }

  void add_branch(std::string_view name, const BranchRecord& branch) {
    json_.begin_object(name);
    json_.add("fate", name_of(fate_names, branch.fate));
    json_.add("factor", branch.factor);
    if (branch.fate == Fate::followed) {
      json_.add("ray", branch.ray);
    }
    json_.end_object();
  }

  void add_yours(const Yours& yours, const std::optional<YoursCompared>& compared) {
    json_.begin_object("yours");
    json_.begin_array("value");
    for (const std::uint8_t v : yours.value) {
      json_.value(int{v});
    }
    json_.end_array();
    json_.add("equal", yours.equal);
    json_.begin_array("fits");
    for (const YoursFit& fit : yours.fits) {
      json_.begin_object();
      json_.add("what", fit.what);
      json_.add("value", fit.value);
      json_.end_object();
    }
    json_.end_array();
    if (compared) {
      add_compared(*compared);
    }
    json_.end_object();
  }

  void add_compared(const YoursCompared& compared) {
    const CauseReport& causes = compared.found.causes;
    json_.begin_object("compared");
    add_claims(json_, "causes", causes.claims);
    add_claims(json_, "partial", causes.partial);
    add_claims(json_, "notes", causes.notes);
    if (causes.asked) {
      json_.add("mistaken", glm::clamp(causes.asked->color, glm::dvec3(0), glm::dvec3(255)));
      json_.add("explained", compared.explained);
      json_.begin_array("terms");
      for (const TermWith& term : compared.terms) {
        json_.begin_object();
        json_.add("name", term.name);
        json_.add("ours", term.ours);
        json_.add("mistaken", term.mistaken);
        json_.end_object();
      }
      json_.end_array();
    }
    json_.end_object();
  }

  void add_remarks(const std::vector<Remark>& remarks) {
    json_.begin_array("remarks");
    for (const Remark& remark : remarks) {
      json_.begin_object();
      json_.add("kind", remark_name(remark.kind));
      json_.add("ray", remark.ray);
      add_index(json_, "light", remark.light);
      json_.add("text", remark.text);
      json_.end_object();
    }
    json_.end_array();
  }

  Json& json_;
  const RenderScene& scene_;
  ObjectNames names_;
  bool tessellated_ = false;
};

}  // namespace

std::string explain_json(const LoadedScene& scene, const RenderOptions& options,
                         const ExplainReport* report, const std::string& error,
                         const std::optional<RealtimeOptions>& realtime) {
  Json json;
  begin_document(json, "explain");
  json.key("scene");
  add_scene(json, scene);
  if (!error.empty()) {
    json.add("error", error);
  }
  if (realtime || (report != nullptr && report->realtime)) {
    json.add("width", options.width);
    json.add("height", options.height);
    json.add("profile", "realtime");
    add_realtime_options(json, realtime ? *realtime : report->realtime->panel);
  } else {
    add_render_options(json, options);
  }
  if (report != nullptr && report->path) {
    add_path_pixel(json, scene, *report);
  } else if (report != nullptr) {
    Document(json, scene).add_pixel(*report);
  }
  json.end_object();
  return json.text();
}

}  // namespace scenefile
