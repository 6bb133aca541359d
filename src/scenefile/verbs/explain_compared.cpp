// A pixel of another program's picture, with the mistakes that the whole picture shows.

#include "scenefile/explain/object_names.h"
#include "scenefile/verbs/explain_tree.h"

#include <fmt/format.h>

#include <utility>

namespace scenefile {

namespace {

using glm::dvec3;

// Without lights, the mistaken pixel has no terms.
std::vector<TermWith> terms_with(const LoadedScene& loaded, const Terms& ours,
                                 const MistakenPixel& mistaken) {
  const RenderScene& scene = loaded.ready.scene;
  const ObjectNames names(loaded.written, loaded.ready.sources);
  std::vector<TermWith> terms;
  const auto add = [&](std::string name, const dvec3& of_ours, const dvec3& with) {
    if (glm::any(glm::greaterThan(glm::max(255.0 * of_ours, glm::abs(with)), dvec3(0.05)))) {
      terms.push_back({std::move(name), 255.0 * of_ours, with});
    }
  };
  if (mistaken.lights.empty()) {
    return terms;
  }
  add("ambient", ours.ambient, mistaken.ambient);
  for (std::uint32_t i = 0; i < mistaken.lights.size(); ++i) {
    LightTerms of_ours;
    for (const LightTerms& light : ours.lights) {
      of_ours = light.light == i ? light : of_ours;
    }
    const std::string light =
        i < scene.lights.size() ? fmt::format("{} light{}", word_of(scene.lights[i].type),
                                              place_text(names.at(scene.lights[i].source).location))
                                : std::string("a light that the scene does not have");
    add(light + ", diffuse", of_ours.diffuse, mistaken.lights[i].diffuse);
    add(light + ", specular", of_ours.specular, mistaken.lights[i].specular);
  }
  add("reflection and refraction", ours.mirror + ours.glass, mistaken.followed);
  return terms;
}

}  // namespace

bool shows_nothing(const PictureComparison& found) {
  const CauseReport& causes = found.causes;
  return !found.broken.empty() && causes.claims.empty() && causes.partial.empty() &&
         causes.notes.empty() && !causes.only_details && found.scene_fits() && !found.exchanged &&
         !found.right_at_other_size;
}

void add_compared(const LoadedScene& scene, const std::array<std::uint8_t, 3>& value,
                  PictureComparison found, ExplainReport& report) {
  add_yours(scene, value, report);
  YoursCompared compared;
  if (const std::optional<MistakenPixel>& asked = found.causes.asked) {
    compared.explained = gives_value(asked->color, value);
    compared.terms = terms_with(scene, terms_of(report.pixel), *asked);
  }
  if (!shows_nothing(found)) {
    report.yours->fits.clear();
  }
  compared.found = std::move(found);
  report.compared = std::move(compared);
}

}  // namespace scenefile
