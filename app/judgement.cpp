#include "app/judgement.h"

#include "app/findings.h"
#include "app/output.h"
#include "scenefile/base/report.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

SceneView view_of(const LoadedScene& scene, RenderOptions options, std::string said) {
  return {&scene.ready.scene, &scene.assets, options, &scene.written, std::move(said)};
}

// What references in use were drawn with; the course's own words for the sets are beside them.
void add_views_of_features(const LoadedScene& scene, RenderOptions render, const std::string& name,
                           std::vector<SceneView>& views) {
  const auto add = [&](const char* words, const Features& features) {
    render.features = features;
    views.push_back(view_of(scene, render, fmt::format("{} --features {}", name, words)));
  };
  Features f = render.features;
  f.super_sample = false;
  f.texture_filter = false;
  add("shadows,reflect,refract,texture,depthoffield", f);
  f.depthoffield = false;
  add("shadows,reflect,refract,texture", f);
  f.refract = false;
  add("shadows,reflect,texture", f);
  f.texture = false;
  add("shadows,reflect", f);
  f.reflect = false;
  add("shadows", f);
  f = {true, false, false, true, false, false, false};
  add("shadows,texture", f);
  f = {false, true, false, true, false, false, false};
  add("reflect,texture", f);
  f = {false, false, false, true, false, false, false};
  add("texture", f);
  f = {false, false, false, true, true, false, false};
  add("texture,texture-filter", f);
  f = {true, true, false, true, true, false, false};
  add("shadows,reflect,texture,texture-filter", f);
  add("none", Features{false, false, false, false, false, false, false});
  if (render.mode == Mode::ray) {
    render.features = Features{false, false, false, false, false, false, false};
    for (const auto& [mode, word] :
         {std::pair(Mode::intersect, "intersect"), std::pair(Mode::normals, "normals")}) {
      render.mode = mode;
      views.push_back(view_of(scene, render, fmt::format("{} --mode {}", name, word)));
    }
  }
}

// The ways in which the scene may have been drawn, as far as the options leave it open.
std::vector<SceneView> possible_views(const LoadedScene& scene, const Options& options) {
  std::vector<Profile> profiles{options.render.profile};
  if (!was_given(options, "--profile")) {
    profiles = {Profile::course, Profile::fine};
  }
  std::vector<SceneView> views;
  for (const Profile profile : profiles) {
    const RenderOptions render = render_options(options, profile);
    const std::string name = profile == Profile::course ? "--profile course" : "--profile fine";
    views.push_back(view_of(scene, render, name));
    if (!was_given(options, "--features")) {
      add_views_of_features(scene, render, name, views);
    }
  }
  return views;
}

}  // namespace

LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context) {
  LoadedScene scene = load_scene(path, options, LoadDepth::with_all_assets, true, context);
  if (!options.json) {
    say(findings_text(scene, Verbosity::errors, wants_color(Stream::chatter)));
    // Without its textures the scene is not what the reference shows, and causes are guessed wrong.
    for (const Diagnostic* const finding : by_place(scene.diagnostics)) {
      if (finding->code->name.starts_with("texture.")) {
        say(fmt::format("{}: warning: {} [{}]\n", escaped(path, 4096),
                        escaped(finding->message, 4096), finding->code->name));
      }
    }
  }
  return scene;
}

Judgement judge(const Texture& reference, const Texture& test, const LoadedScene* scene,
                const Options& options, const std::function<bool(double)>& progress,
                LookForCauses look) {
  Judgement judgement;
  judgement.measures = measure(reference, test, options.pixel_threshold, &judgement.flip_errors);
  judgement.broken = broken_thresholds(options.thresholds, judgement.measures);
  const bool wanted = !judgement.broken.empty() ||
                      (look == LookForCauses::always && judgement.measures.difference.max > 0);
  if (!wanted || !judgement.measures.same_size) {
    return judgement;
  }
  if (scene == nullptr || status_of(*scene) != ExitCode::fine) {
    judgement.causes = find_causes(reference, test, nullptr, progress);
    return judgement;
  }
  judgement.scene_used = true;
  const SceneView view = most_alike(reference, possible_views(*scene, options));
  judgement.view = view.said;
  judgement.causes = find_causes(reference, test, &view, progress);
  return judgement;
}

std::string causes_text(const Judgement& judgement) {
  const CauseReport& report = judgement.causes;
  std::string text;
  for (const Claim& claim : report.claims) {
    text += fmt::format("cause: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& claim : report.rivals) {
    text += fmt::format("   or: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  for (const Claim& claim : report.partial) {
    text += fmt::format("in part: {} [{}]\n       {}\n", claim.what, name_of(claim.cause),
                        claim.evidence);
  }
  if (judgement.scene_used && report.share_scene_unlike <= 0.1 && !judgement.view.empty()) {
    text += fmt::format("reference: as drawn with {}\n", judgement.view);
  }
  if (judgement.scene_used && report.share_scene_unlike > 0.1) {
    text += fmt::format(
        "the scene is not what the reference shows: our picture of it differs in {:.0f} % of the "
        "pixels; give --profile and --features as the reference was made\n",
        100 * report.share_scene_unlike);
  } else if (report.claims.empty() && judgement.measures.same_size) {
    text += report.share_different < 0.001
                ? "cause: none known; they differ by edges and rounding alone\n"
            : judgement.scene_used
                ? "cause: none that is known explains the difference\n"
                : "cause: none that shows in the pictures alone; most causes are looked for only "
                  "with --scene SCENE, the scene of the pictures\n";
  }
  return text;
}

void add_claims(Json& json, std::string_view name, const std::vector<Claim>& claims) {
  json.begin_array(name);
  for (const Claim& claim : claims) {
    json.begin_object();
    json.add("cause", name_of(claim.cause));
    json.add("what", claim.what);
    json.add("evidence", claim.evidence);
    json.add("explained", claim.explained);
    json.end_object();
  }
  json.end_array();
}

void add_clauses(Json& json, std::string_view name, const std::vector<std::string>& clauses) {
  json.begin_array(name);
  for (const std::string& clause : clauses) {
    json.value(std::string_view(clause));
  }
  json.end_array();
}

void add_measures(Json& json, const PictureMeasures& m) {
  json.add("same_size", m.same_size);
  json.add("psnr_db", m.difference.psnr_db);
  json.add("mean_difference", m.difference.mean);
  json.add("max_difference", m.difference.max);
  json.add("share_over", m.difference.share_over);
  json.add("ssim", m.ssim);
  json.add("flip_mean", m.flip_mean);
  json.add("flip_max", m.flip_max);
}

void add_judgement(Json& json, const Judgement& judgement) {
  json.add("same", judgement.broken.empty());
  add_measures(json, judgement.measures);
  add_clauses(json, "broken", judgement.broken);
  add_claims(json, "causes", judgement.causes.claims);
  add_claims(json, "rivals", judgement.causes.rivals);
  add_claims(json, "partial", judgement.causes.partial);
  if (judgement.scene_used) {
    json.add("share_scene_unlike", judgement.causes.share_scene_unlike);
    json.add("reference_drawn_with", judgement.view);
  }
}

}  // namespace scenefile::app
