#include "scenefile/verbs/compare_paths.h"

#include "scenefile/base/text.h"
#include "scenefile/path/lamps.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/trace_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

void add_claim_lines(std::string& text, const char* word, const std::vector<PathClaim>& claims) {
  for (const PathClaim& claim : claims) {
    text += fmt::format("{}: {} [{}]{}{}\n", &claim == claims.data() ? word : "or", claim.what,
                        claim.name, claim.evidence.empty() ? "" : "; ", claim.evidence);
  }
}

void add_path_claims(Json& json, std::string_view name, const std::vector<PathClaim>& claims) {
  json.add_objects(name, claims, [&](const PathClaim& claim) {
    json.add({{"name", claim.name},
              {"what", claim.what},
              {"evidence", claim.evidence},
              {"explained", claim.explained}});
  });
}

// Two digits of a whole number are enough for a number of samples.
double few_digits(double value) {
  const double digits = std::pow(10, std::floor(std::log10(std::max(value, 10.0))) - 1);
  return std::max(2.0, std::ceil(value / digits) * digits);
}

}  // namespace

RenderStatus draw_truth(const LoadedScene& scene, const RenderOptions& options, double seconds,
                        const Progress& progress, PathTruth& truth) {
  const TraceScene traced(scene.ready.scene, scene.assets, {.threads = options.threads});
  constexpr std::uint32_t most_samples = 4096;
  // Shares of the time. The truth has most of it, because all explanations start from it.
  constexpr double of_variants = 0.25;
  constexpr double of_throughputs = 0.15;
  RenderStatus status =
      draw_truth(traced, scene.ready.scene, options, (1 - of_variants - of_throughputs) * seconds,
                 most_samples, progress, truth);
  if (status != RenderStatus::complete) {
    return status;
  }
  draw_pools(traced, scene.ready.scene, options, truth);
  status = draw_throughputs(traced, scene.ready.scene, options, of_throughputs * seconds, progress,
                            truth);
  return status != RenderStatus::complete
             ? status
             : draw_variants(all_variants, scene.ready.scene, scene.assets, options,
                             of_variants * seconds, progress, truth);
}

RenderStatus judge_by_truth(const LoadedScene& scene, const RenderOptions& options, double seconds,
                            const Progress& progress, const DecodedPicture& mine, PathTruth& truth,
                            PathVerdict& verdict) {
  verdict = judge_path(truth, mine);
  if (verdict.noisy_variants.empty()) {
    return RenderStatus::complete;
  }
  std::vector<VariantPicture> first = truth.variants;
  RenderStatus drawn = RenderStatus::complete;
  for (const Variant& variant : verdict.noisy_variants) {
    const auto is_it = [&](const VariantPicture& v) { return v.variant == variant; };
    const auto finer =
        std::find_if(truth.finer_variants.begin(), truth.finer_variants.end(), is_it);
    if (finer != truth.finer_variants.end()) {
      std::erase_if(truth.variants, is_it);
      truth.variants.push_back(*finer);
      continue;
    }
    drawn = draw_variants({&variant, 1}, scene.ready.scene, scene.assets, options, seconds / 3,
                          progress, truth);
    if (drawn != RenderStatus::complete) {
      break;
    }
    truth.finer_variants.push_back(truth.variants.back());
  }
  if (drawn == RenderStatus::complete) {
    verdict = judge_path(truth, mine);
  }
  truth.variants = std::move(first);  // other pictures are judged as if they were alone
  return drawn;
}

std::string too_noisy_text(const PathVerdict& v) {
  return std::isfinite(v.more_samples)
             ? fmt::format("too noisy; about {:.0f} times as many samples per pixel would do",
                           few_digits(v.more_samples))
         : v.truth_too_noisy ? "the truth is too noisy; more --time would do"
                             : "the picture is too small; one with more pixels would do";
}

std::string path_verdict_text(const PathVerdict& v) {
  std::string text;
  add_claim_lines(text, "cause", v.causes);
  add_claim_lines(text, "in part", v.partial);
  for (const PathClaim& c : v.conventions) {
    text += fmt::format("convention: {} [{}]{}{}\n", c.what, c.name, c.evidence.empty() ? "" : "; ",
                        c.evidence);
  }
  for (const PathClaim& c : v.notes) {
    text += fmt::format("note: {}\n", c.what);
  }
  if (v.right) {
    text += "right within its noise\n";
  } else if (v.too_noisy) {
    text += fmt::format("cannot tell: {}\n", too_noisy_text(v));
  } else if (v.causes.empty() && v.partial.empty() && v.tested > 0) {
    text += "different; no known mistake explains it\n";
  }
  if (v.tested == 0) {
    return text;
  }
  text += fmt::format(
      "  {} blocks of {}x{} pixels; largest difference {:.1f} standard errors at pixel {},{} "
      "({:.1f} is the most by chance)\n",
      v.tested, block_side, block_side, v.largest, v.largest_at.x, v.largest_at.y, v.critical);
  for (const PathPlace& place : v.places) {
    text += fmt::format("  {}: {:.3f} +- {:.3f} of the truth's ({:.1f} % of it)\n", place.name,
                        place.factor, place.error, 100 * place.share);
  }
  text += fmt::format(
      "  noise as of {} per pixel; the truth has {:.0f}\n",
      v.samples < 0.5 ? "less than one sample" : fmt::format("{:.0f} samples", v.samples),
      v.truth_samples);
  if (v.curve != "linear values") {
    text += fmt::format(
        "  read as {}{}\n", v.curve,
        v.exposure == 1 ? std::string() : fmt::format(" with exposure {:.3f}", v.exposure));
  }
  if (v.clipped > 0) {
    text += fmt::format("  {} left out\n", counted(v.clipped, "clipped pixel"));
  }
  if (v.fireflies > 0) {
    text += fmt::format("  {} with {:.1f} % of the light\n",
                        v.fireflies == 1 ? "1 firefly" : fmt::format("{} fireflies", v.fireflies),
                        100 * v.firefly_energy);
  }
  return text;
}

Texture truth_picture(const PathTruth& truth) {
  Image image(truth.width, truth.height);
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      image.rgb[3 * i + c] = static_cast<float>(truth.pixels[i][c]);
    }
  }
  return quantize(tone_mapped(std::move(image), Tone::course, 0), Rounding::nearest);
}

Texture significance_picture(const PathTruth& truth, const PathVerdict& v) {
  Texture picture{truth.width, truth.height, {}};
  picture.rgb.resize(std::size_t{3} * truth.width * truth.height);
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const double z = v.significance[std::size_t(y / block_side) * truth.columns + x / block_side];
      // Below what chance explains, nothing is shown.
      const double shown =
          std::clamp((std::abs(z) - v.critical / 2) / (2.5 * v.critical), 0.0, 1.0);
      const auto rest = static_cast<std::uint8_t>(255 * (1 - shown));
      std::uint8_t* rgb = &picture.rgb[std::size_t{3} * (std::size_t(y) * truth.width + x)];
      rgb[0] = z == 0 ? 200 : z > 0 ? 255 : rest;
      rgb[1] = z == 0 ? 200 : rest;
      rgb[2] = z == 0 ? 200 : z > 0 ? rest : 255;
    }
  }
  return picture;
}

std::string energy_svg(const PathVerdict& v) {
  constexpr int width = 480;
  constexpr int height = 300;
  constexpr int bottom = 250;
  double most = 1e-30;
  for (const std::vector<double>* list : {&v.energy_truth, &v.energy_mine}) {
    for (const double value : *list) {
      most = std::max(most, value);
    }
  }
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
      "<text x=\"20\" y=\"24\">Light by bounces, without visible lamps: truth (gray), mine "
      "(blue)</text>\n",
      width, height);
  const auto bar = [&](double left, double value, const char* color) {
    const double high = 190 * std::max(0.0, value) / most;
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"36\" height=\"{:.1f}\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"10\">{:.3g}</text>\n",
        left, bottom - high, high, color, left + 18, bottom - high - 4, value);
  };
  for (std::size_t i = 0; i < v.energy_truth.size(); ++i) {
    const double left = 30 + 110.0 * static_cast<double>(i);
    bar(left, v.energy_truth[i], "#999999");
    if (i < v.energy_mine.size()) {
      bar(left + 40, v.energy_mine[i], "#3366cc");
    }
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}{}</text>\n",
                       left + 38, bottom + 20, i + 1,
                       i + 1 == v.energy_truth.size() ? " and more"
                       : i == 0                       ? " (direct)"
                                                      : "");
  }
  return svg + "</svg>\n";
}

PathNeighborhood neighborhood(const PathTruth& truth, PathVerdict verdict,
                              const glm::ivec2& pixel) {
  PathNeighborhood n;
  const glm::ivec2 at = pixel / block_side;
  const std::size_t b = std::size_t(at.y) * truth.columns + at.x;
  n.block = {at.x * block_side, at.y * block_side, std::min((at.x + 1) * block_side, truth.width),
             std::min((at.y + 1) * block_side, truth.height)};
  n.truth_error = std::sqrt(luminance(truth.noise[b]));
  if (verdict.errors[b] > 0) {
    n.mine = verdict.mine[b];
    n.error = verdict.errors[b];
    n.significance = verdict.significance[b];
  }
  constexpr int most = 5;  // and more
  std::array<Color, most + 1> by_bounce{};
  Color mirror(0);
  Color glass(0);
  for (const auto& [kind, light] : truth.kinds) {
    n.truth += light[b];
    by_bounce[std::min(most, kind.bounces() + (kind.hit ? 0 : 1))] += light[b];
    mirror += kind.mirror > 0 ? light[b] : Color(0);
    glass += kind.glass > 0 ? light[b] : Color(0);
  }
  const auto add = [&](std::string name, const Color& light) {
    if (luminance(light) > 0) {
      n.terms.push_back({std::move(name), light});
    }
  };
  add("visible lamps", by_bounce[0]);
  add("direct light", by_bounce[1]);
  for (int i = 2; i <= most; ++i) {
    add(fmt::format("light of {} bounces{}", i, i == most ? " and more" : ""), by_bounce[i]);
  }
  add("of these, after mirrors", mirror);
  add("of these, after glass", glass);
  n.verdict = std::move(verdict);
  return n;
}

void add_path_verdict(Json& json, const PathVerdict& v) {
  json.add({{"right", v.right}, {"too_noisy", v.too_noisy}, {"more_samples", v.more_samples}});
  add_path_claims(json, "causes", v.causes);
  add_path_claims(json, "partial", v.partial);
  add_path_claims(json, "conventions", v.conventions);
  add_path_claims(json, "notes", v.notes);
  json.add_objects("places", v.places, [&](const PathPlace& place) {
    json.add({{"name", place.name},
              {"share", place.share},
              {"factor", place.factor},
              {"error", place.error}});
  });
  json.add({{"energy_truth", v.energy_truth},
            {"energy_mine", v.energy_mine},
            {"blocks", v.tested},
            {"largest_significance", v.largest},
            {"largest_at", std::array{v.largest_at.x, v.largest_at.y}},
            {"critical_significance", v.critical},
            {"samples", v.samples},
            {"truth_samples", v.truth_samples},
            {"curve", v.curve},
            {"exposure", v.exposure},
            {"clipped", v.clipped},
            {"not_finite", v.not_finite},
            {"fireflies", v.fireflies},
            {"firefly_energy", v.firefly_energy},
            {"chi2_per_value", v.chi2_per_value}});
}

}  // namespace scenefile
