#include "scenefile/verbs/grade_paths.h"

#include "scenefile/base/text.h"
#include "scenefile/format/read_config.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace scenefile {

namespace {

// The page of help for a claim; others are about the scattering of light.
Cause page_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Cause>, 31> pages{
      {{"vertical-flip", Cause::vertical_flip},
       {"horizontal-flip", Cause::horizontal_flip},
       {"swapped-channels", Cause::swapped_channels},
       {"gamma", Cause::gamma},
       {"brightness", Cause::brightness},
       {"flat-normals", Cause::normals},
       {"visibility", Cause::light_samples},
       {"self-shadow", Cause::light_samples},
       {"distance", Cause::light_samples},
       {"lamp-cosine", Cause::light_samples},
       {"lamp-area", Cause::light_samples},
       {"lamp-points", Cause::light_samples},
       {"lamp-choice", Cause::light_samples},
       {"lamp-sampling", Cause::light_samples},
       {"direct-twice", Cause::light_samples},
       {"direct-factor", Cause::light_samples},
       {"first-direct-factor", Cause::light_samples},
       {"depth", Cause::path_length},
       {"no-reflected-light", Cause::path_length},
       {"roulette", Cause::path_length},
       {"emission-after-specular", Cause::path_length},
       {"caustics", Cause::path_length},
       {"caustics-factor", Cause::path_length},
       {"mirror", Cause::specular_paths},
       {"mirror-factor", Cause::specular_paths},
       {"mirror-cosine", Cause::specular_paths},
       {"glass", Cause::specular_paths},
       {"glass-factor", Cause::specular_paths},
       {"refraction", Cause::specular_paths},
       {"fresnel", Cause::specular_paths},
       {"total-reflection", Cause::specular_paths}}};
  const auto page =
      std::find_if(pages.begin(), pages.end(), [&](const auto& row) { return row.first == name; });
  return page == pages.end() ? Cause::scattering : page->second;
}

Claim claim_of(const PathClaim& claim) {
  return {page_of(claim.name), claim.what, claim.evidence, claim.explained};
}

Error config_error(const std::string& path, const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.severity == Severity::error) {
      return {fmt::format("{}:{}: {}", escaped(path, 400), d.location.line, escaped(d.message)),
              ErrorKind::input};
    }
  }
  return {fmt::format("{}: cannot be used", escaped(path, 400)), ErrorKind::input};
}

}  // namespace

Result<std::vector<PathReference>> path_references(const std::string& folder,
                                                   const std::string& scenes,
                                                   const RenderOptions& options) {
  std::vector<Error> errors;
  std::vector<PathReference> references;
  for (const std::string& path : files_below(folder, errors)) {
    if (ending_of(path) != ".ini") {
      continue;
    }
    Result<std::string> text = read_file(path, Limits{}.value_bytes);
    if (!text) {
      return text.error();
    }
    Diagnostics diagnostics;
    const CourseConfig config = read_config(*text, Limits{}, diagnostics);
    if (diagnostics.has_errors()) {
      return config_error(path, diagnostics);
    }
    if (config.kind != ConfigKind::path) {
      continue;
    }
    PathReference& one = references.emplace_back();
    one.file = found_file("", config.output);
    one.file.path = path;
    one.text = *std::move(text);
    one.scene = scenes.empty() ? config.scene : scenes + '/' + config.scene;
    one.options = options;
    one.options.width = config.width;
    one.options.height = config.height;
    one.options.direct_only = options.direct_only || config.direct_lighting_only;
    one.options.max_depth = config.path_continuation_prob == 0 ? 1 : options.max_depth;
  }
  if (!errors.empty()) {
    return errors.front();
  }
  if (references.empty()) {
    return Error{fmt::format("{} contains no configurations of the path tracer (.ini)",
                             quoted(folder, 400))};
  }
  return references;
}

void set_result(const PathVerdict& v, PictureResult& result) {
  result.verdict = v.right ? Verdict::passed : Verdict::differs;
  if (v.too_noisy) {
    result.reasons.push_back(
        fmt::format("too noisy to tell whether it is right: about {:.0f} times as many samples "
                    "per pixel would do",
                    std::ceil(std::max(1.0, v.more_samples))));
  } else if (!v.right) {
    result.reasons.push_back(
        fmt::format("it differs from the truth by more than its noise: by up to {:.1f} standard "
                    "errors of blocks of {}x{} pixels",
                    v.largest, block_side, block_side));
  }
  for (const PathClaim& claim : v.causes) {
    (result.causes.empty() ? result.causes : result.rivals).push_back(claim_of(claim));
  }
  for (const PathClaim& claim : v.partial) {
    result.partial.push_back(claim_of(claim));
  }
  for (const std::vector<PathClaim>* list : {&v.conventions, &v.notes}) {
    for (const PathClaim& claim : *list) {
      result.notes.push_back(claim.what);
    }
  }
}

}  // namespace scenefile
