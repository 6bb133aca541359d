#include "scenefile/verbs/grade_paths.h"

#include "scenefile/base/text.h"
#include "scenefile/format/read_config.h"
#include "scenefile/grade/claims.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/compare_paths.h"
#include "scenefile/verbs/compare_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

Claim claim_of(const PathClaim& claim) {
  return {claim.page, claim.what, claim.evidence, claim.explained};
}

// The findings of that severity, with their places.
std::vector<std::string> findings_of(const std::string& path, const Diagnostics& diagnostics,
                                     Severity severity) {
  std::vector<std::string> lines;
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.severity == severity) {
      lines.push_back(fmt::format("{}{}: {}", escaped(path, 400),
                                  d.location.known() ? fmt::format(":{}", d.location.line) : "",
                                  escaped(d.message)));
    }
  }
  return lines;
}

}  // namespace

Result<std::vector<PathReference>> path_references(const std::string& folder,
                                                   const std::string& scenes,
                                                   const RenderOptions& options,
                                                   std::vector<std::string>& notes) {
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
    const CourseConfig config = read_config(*text, Limits{}, diagnostics, ConfigKind::path);
    const std::vector<std::string> wrong = findings_of(path, diagnostics, Severity::error);
    if (config.kind != ConfigKind::path) {
      notes.insert(notes.end(), wrong.begin(), wrong.end());
      continue;
    }
    if (!wrong.empty()) {
      return Error{wrong.front(), ErrorKind::input};
    }
    for (std::string& line : findings_of(path, diagnostics, Severity::warning)) {
      notes.push_back(std::move(line));
    }
    FoundFile file = found_file("", config.output);
    file.path = path;
    for (const PathReference& other : references) {
      if (other.file.stem == file.stem && other.file.folders == file.folders) {
        return Error{
            fmt::format("{} and {} name the same output, {}", escaped(other.file.path, 400),
                        escaped(path, 400), quoted(config.output, 400)),
            ErrorKind::input};
      }
    }
    PathReference& one = references.emplace_back();
    one.file = std::move(file);
    one.text = *std::move(text);
    one.scene = scenes.empty() || config.scene.starts_with('/') ? config.scene
                                                                : scenes + '/' + config.scene;
    one.options = options;
    one.options.width = config.width;
    one.options.height = config.height;
    one.options.direct_only = options.direct_only || config.direct_lighting_only;
    if (config.most_bounces() > 0) {
      one.options.max_depth = config.most_bounces();
    }
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
    result.reasons.push_back("cannot tell whether it is right: " + too_noisy_text(v));
  } else if (v.tested == 0) {
    result.reasons.push_back("no part of it can be compared with the truth");
  } else if (!v.right) {
    result.reasons.push_back(
        fmt::format("it differs from the truth by more than its noise: by up to {:.1f} standard "
                    "errors of blocks of {}x{} pixels",
                    v.largest, block_side, block_side));
  }
  for (const PathClaim& claim : v.causes) {
    (result.causes.empty() ? result.causes : result.rivals).push_back(claim_of(claim));
  }
  if (!result.rivals.empty()) {
    std::vector<std::string> others;
    for (Claim& rival : result.rivals) {
      rival.said = true;
      others.push_back(rival.what);
    }
    add_alternatives(result.causes.front(), others);
  }
  for (const PathClaim& claim : v.partial) {
    result.partial.push_back(claim_of(claim));
  }
  for (const PathClaim& claim : v.conventions) {
    result.notes.push_back(no_mistake_text(claim.what));
  }
  for (const PathClaim& claim : v.notes) {
    result.notes.push_back(claim.what);
  }
}

}  // namespace scenefile
