#include "app/judgement.h"

#include "app/findings.h"
#include "app/output.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

SceneView view_of(const LoadedScene& scene, RenderOptions options) {
  return {&scene.ready.scene, &scene.assets, options};
}

// The ways in which the scene may have been drawn, as far as the options leave it open.
std::vector<SceneView> possible_views(const LoadedScene& scene, const Options& options) {
  std::vector<Profile> profiles{options.render.profile};
  if (!was_given(options, "--profile")) {
    profiles = {Profile::course, Profile::fine};
  }
  std::vector<SceneView> views;
  for (const Profile profile : profiles) {
    RenderOptions render = render_options(options, profile);
    views.push_back(view_of(scene, render));
    if (!was_given(options, "--features")) {
      render.features.texture_filter = false;
      views.push_back(view_of(scene, render));
      render.features.refract = false;
      views.push_back(view_of(scene, render));
      render.features = Features{false, false, false, false, false, false, false};
      views.push_back(view_of(scene, render));
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
  }
  return scene;
}

Judgement judge(const Texture& reference, const Texture& test, const LoadedScene* scene,
                const Options& options, const std::function<bool(double)>& progress) {
  Judgement judgement;
  judgement.measures = measure(reference, test, options.pixel_threshold, &judgement.flip_errors);
  judgement.broken = broken_thresholds(options.thresholds, judgement.measures);
  if (judgement.broken.empty() || !judgement.measures.same_size) {
    return judgement;
  }
  if (scene == nullptr || status_of(*scene) != ExitCode::fine) {
    judgement.causes = find_causes(reference, test, nullptr, progress);
    return judgement;
  }
  judgement.scene_used = true;
  const SceneView view = most_alike(reference, possible_views(*scene, options));
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
  if (judgement.scene_used) {
    json.add("share_scene_unlike", judgement.causes.share_scene_unlike);
  }
}

}  // namespace scenefile::app
