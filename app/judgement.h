#pragma once
// A picture against its reference, as diff and grade look at it.

#include "app/json_writer.h"
#include "app/load.h"
#include "scenefile/compare/measure.h"
#include "scenefile/grade/causes.h"

namespace scenefile::app {

struct Judgement {
  PictureMeasures measures;
  std::vector<float> flip_errors;   ///< of the pixels; empty for pictures of different sizes
  std::vector<std::string> broken;  ///< thresholds; empty: the same
  CauseReport causes;               ///< nothing where the pictures are the same
  std::string view;                 ///< how the reference was drawn, as options; empty: not known
  bool scene_used = false;          ///< whether a scene was there to look for causes with
};

enum class LookForCauses { where_broken, always };

/// Compares; looks for causes where a threshold is broken. `scene`: what the reference shows; may
/// be null.
Judgement judge(const Texture& reference, const Texture& test, const LoadedScene* scene,
                const Options& options, const std::function<bool(double)>& progress,
                LookForCauses look = LookForCauses::where_broken);

/// The scene of --scene, said and without assets where it cannot be used.
LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context);

/// The causes as lines for people.
std::string causes_text(const Judgement& judgement);

/// Members of an object each.
void add_measures(Json& json, const PictureMeasures& measures);
void add_clauses(Json& json, std::string_view name, const std::vector<std::string>& clauses);
void add_claims(Json& json, std::string_view name, const std::vector<Claim>& claims);
void add_judgement(Json& json, const Judgement& judgement);

}  // namespace scenefile::app
