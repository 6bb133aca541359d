#pragma once
// A ray tracer as a student would write it, for tests: one ray per pixel, single precision, no
// acceleration structure. Shares nothing with the project's geometry and tracer, so that their
// agreement is evidence. Makes common mistakes on request.

#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/scene.h"

#include <set>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::student {

/// A mistake that the tracer can make.
struct KnownMistake {
  std::string_view name;    ///< "lights-only-first"
  std::string_view family;  ///< for tables
  std::string_view
      causes;  ///< names (name_of) of causes that are correct answers, separated by '|'
};

std::span<const KnownMistake> known_mistakes();

/// What the tracer should draw, in terms of the course's configuration.
struct Job {
  int width = 320;
  int height = 240;
  bool shadows = true;
  bool reflect = true;
  bool refract = true;
  bool texture = true;
  bool directional_alone = false;  ///< without the above: the course's first project
  std::set<std::string, std::less<>> mistakes;
};

/// `textures`: by file name as written.
Texture draw(const Scene& scene, const Assets& assets, std::span<const std::string> texture_names,
             const Job& job);

}  // namespace scenefile::student
