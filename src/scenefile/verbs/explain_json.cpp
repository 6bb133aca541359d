#include "scenefile/verbs/explain_tree.h"
#include "scenefile/verbs/scene_json.h"

#include <array>

namespace scenefile {

namespace {

constexpr std::array<std::string_view, 3> ray_names{"camera", "reflected", "refracted"};
constexpr std::array<std::string_view, 5> outcome_names{"absent", "followed", "too-deep",
                                                        "too-faint", "too-many"};
constexpr std::array<std::string_view, 3> unlit_names{"", "light-of-another-mode",
                                                      "light-out-of-reach"};

template <typename T, std::size_t n>
std::string_view name_of(const std::array<std::string_view, n>& names, T value) {
  return names[static_cast<std::size_t>(value)];
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
    json_.add({{"x", pixel.x}, {"y", pixel.y}, {"color", pixel.color}, {"value", pixel.value}});
    if (pixel.options.profile == Profile::fine && !tessellated_) {
      json_.add_object("more_samples_because", {{"noisy", pixel.more.noisy},
                                                {"penumbra", pixel.more.penumbra},
                                                {"neighbors", pixel.more.neighbors}});
    }
    json_.add_objects("samples", pixel.samples, [&](const SampleRecord& sample) {
      if (report.realtime) {
        const RealtimeFramePixel& share =
            report.realtime->pixel.shares[std::size_t(&sample - pixel.samples.data())];
        json_.add({{"frame_pixel", glm::dvec2(share.at)}, {"weight", share.weight}});
      }
      add_sample(sample);
    });
    json_.add("shown", pixel.shown);
    json_.add_objects("rays", pixel.rays, [&](const RayRecord& ray) { add_ray(ray); });
    json_.add_objects("remarks", report.remarks, [&](const Remark& remark) {
      json_.add({{"kind", remark_name(remark.kind)}, {"ray", remark.ray}});
      add_index(json_, "light", remark.light);
      json_.add("text", remark.text);
    });
    if (report.yours) {
      add_yours(*report.yours, report.compared);
    }
    json_.end_object();
  }

 private:
  void add_sample(const SampleRecord& sample) {
    json_.add({{"point", sample.point},
               {"lens", sample.lens},
               {"color", sample.color},
               {"rays", sample.rays},
               {"refined", sample.refined}});
    add_index(json_, "refines", sample.refines);
    if (sample.object.has_value()) {
      json_.add("object", names_.text(*sample.object));
    }
  }

  void add_object(const ObjectRef& object) { scenefile::add_object(json_, names_, object); }

  void add_ray(const RayRecord& ray) {
    json_.add("kind", name_of(ray_names, ray.kind));
    add_index(json_, "parent", ray.parent);
    json_.add({{"depth", ray.depth}, {"weight", ray.weight}});
    add_line(json_, "ray", ray.ray);
    json_.add({{"start", ray.start}, {"total_reflection", ray.total_reflection}});
    json_.add_objects("walls", ray.walls, [&](const WallRecord& wall) {
      add_object(wall.object);
      json_.add({{"t", wall.t},
                 {"position", wall.position},
                 {"normal", wall.normal},
                 {"direction", wall.direction},
                 {"mirrored", wall.mirrored}});
    });
    json_.add("trapped", ray.trapped);
    if (ray.surface.has_value()) {
      add_surface(*ray.surface);
      json_.add("ambient", ray.ambient);
      json_.add_objects("lights", ray.lights, [&](const LightRecord& light) { add_light(light); });
      json_.add("local", ray.local);
      add_branch("reflected", ray.mirror);
      add_branch("refracted", ray.glass);
    }
    json_.add({{"sum", ray.sum}, {"color", ray.color}});
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
    add_line(json_, "ray", s.ray);
    add_line(json_, "object_ray", s.object_ray);
    json_.add({{"position", s.position},
               {"object_position", s.object_position},
               {"normal", s.normal},
               {"geometric_normal", s.geometric},
               {"object_normal", s.object_normal},
               {"bumped", s.bumped}});
    if (s.has_uv) {
      json_.add("uv", s.uv);
    }
    if (s.texture.has_value()) {
      json_.add_object("texture", {{"file", scene_.texture_files[s.texture->file].name},
                                   {"texel", s.texture->texel},
                                   {"texel_color", s.texture->texel_color},
                                   {"color", s.texture->color},
                                   {"blend", s.texture->blend}});
    }
    json_.add({{"diffuse_color", s.diffuse_color}, {"specular_color", s.specular_color}});
    json_.end_object();
  }

  void add_light(const LightRecord& record) {
    const RenderLight& light = scene_.lights[record.light];
    json_.add({{"light", record.light},
               {"type", word_of(light.type)},
               {"line", names_.at(light.source).location.line}});
    if (record.unlit != Unlit::no) {
      json_.add("unlit", name_of(unlit_names, record.unlit));
    }
    json_.add("taken", record.taken);
    json_.add_objects("samples", record.samples, [&](const LightSample& l) {
      json_.add({{"to_light", l.to_light},
                 {"distance", l.distance},
                 {"attenuation", l.attenuation},
                 {"spot_factor", l.spot_factor},
                 {"color", l.color},
                 {"n_dot_l", l.n_dot_l},
                 {"r_dot_v", l.r_dot_v},
                 {"diffuse", l.diffuse},
                 {"specular", l.specular},
                 {"shadow_ray", l.shadow_ray},
                 {"visibility", l.visibility}});
      json_.add_objects("blockers", l.blockers, [&](const Blocker& blocker) {
        add_object(blocker.object);
        json_.add({{"t", blocker.t}, {"passes", blocker.passes}, {"itself", blocker.itself}});
      });
      json_.add("contribution", l.contribution);
    });
    json_.add("contribution", record.contribution);
  }

  void add_branch(std::string_view name, const BranchRecord& branch) {
    json_.begin_object(name);
    json_.add({{"fate", name_of(outcome_names, branch.outcome)}, {"factor", branch.factor}});
    if (branch.outcome == BranchOutcome::followed) {
      json_.add("ray", branch.ray);
    }
    json_.end_object();
  }

  void add_yours(const Yours& yours, const std::optional<YoursCompared>& compared) {
    json_.begin_object("yours");
    json_.add({{"value", yours.value}, {"equal", yours.equal}});
    json_.add_objects("fits", yours.fits, [&](const YoursFit& fit) {
      json_.add({{"what", fit.what}, {"value", fit.value}});
    });
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
      json_.add({{"mistaken", glm::clamp(causes.asked->color, glm::dvec3(0), glm::dvec3(255))},
                 {"explained", compared.explained}});
      json_.add_objects("terms", compared.terms, [&](const TermWith& term) {
        json_.add({{"name", term.name}, {"ours", term.ours}, {"mistaken", term.mistaken}});
      });
    }
    json_.end_object();
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
    json.add({{"width", options.width}, {"height", options.height}, {"profile", "realtime"}});
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
