#include "app/command.h"
#include "app/import_model.h"
#include "app/json.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/export/face_materials.h"
#include "scenefile/export/write_gltf.h"
#include "scenefile/export/write_obj.h"
#include "scenefile/export/write_pov.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/verbs/carry_files.h"
#include "scenefile/verbs/codes.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

// Drops the reader's notes, which do not matter for conversion; the writer's notes, which say what
// changed, remain.
void drop_notes(Diagnostics& diagnostics) {
  diagnostics.rewrite([](const Code&, Severity severity) {
    return severity == Severity::note ? std::nullopt : std::optional(severity);
  });
}

// As in the fine profile.
constexpr float assumed_transparent = 0.5f;

SceneFormat scene_format(ConvertTo format) {
  return format == ConvertTo::json ? SceneFormat::json : SceneFormat::xml;
}

// A model becomes several files, so the output must be a scene.
ExitCode check_model_target(const ConvertReport& report) {
  if (report.format != ConvertTo::xml && report.format != ConvertTo::json) {
    return fail(ExitCode::usage,
                "a model becomes a scene, .xml or .json; convert that into another format");
  }
  return ExitCode::fine;
}

// Several files need a folder.
ExitCode check_several(const ConvertReport& report) {
  if (is_standard_output(report.output)) {
    return fail(ExitCode::usage,
                "the output consists of several files; give a file name instead of -");
  }
  return ExitCode::fine;
}

std::string write_scene_file(LoadedScene& scene, const Options& options, Context& context) {
  if (const std::size_t comments = count_comments(scene.text); comments != 0) {
    scene.diagnostics.report(
        "convert.comments"_code, {},
        fmt::format("{} comment{} not carried over", comments, comments == 1 ? " is" : "s are"));
  }
  context.phase = "looking for textures and meshes";
  carry_files(scene, options.arguments[1], options.access, options.load.limits);
  context.phase = "writing the scene";
  return write_scene(scene.written, scene_format(*options.to), options.load.limits,
                     scene.diagnostics);
}

// POV-Ray opens the textures itself, so it needs the paths where they were found, relative to the
// output only if it cannot open the absolute one.
std::string write_pov_file(LoadedScene& scene, bool path, const Options& options,
                           Context& context) {
  std::vector<std::string> textures;
  const std::string folder = real_folder_of(options.arguments[1]);
  for (const AssetFile& file : locate_files(scene, options)) {
    if (file.kind == AssetKind::texture && file.from.empty()) {
      const std::string& path = file.resolved.path;
      textures.push_back(pov_opens(path) || path.empty() ? path : path_from(folder, path));
    }
  }
  context.phase = "writing the scene";
  const Features& features = options.render.features;
  return write_pov(scene.ready.scene, scene.assets, textures,
                   {.bounces = options.render.max_depth,
                    .transparent = assumed_transparent,
                    .shadows = features.shadows,
                    .reflect = features.reflect,
                    .refract = features.refract,
                    .texture = features.texture,
                    .texture_filter = features.texture_filter,
                    .lens = features.depthoffield,
                    .path = path},
                   scene.diagnostics);
}

std::string write_gltf_file(LoadedScene& scene, bool path, const Options& options,
                            Context& context) {
  context.phase = "writing the scene";
  return write_gltf(scene.written, scene.ready, scene.assets,
                    {.binary = *options.to == ConvertTo::glb,
                     .segments = options.segments,
                     .transparent = assumed_transparent,
                     .path = path},
                    scene.diagnostics);
}

std::string write_obj_file(LoadedScene& scene, bool path, const Options& options,
                           std::vector<ImportedFile>& files, Context& context) {
  context.phase = "writing the scene";
  const std::string stem = file_stem(options.arguments[1]);
  ObjScene obj = write_obj(scene.ready.scene, scene.assets,
                           {.stem = stem,
                            .segments = options.segments,
                            .transparent = assumed_transparent,
                            .path = path},
                           scene.diagnostics);
  files.push_back({stem + ".mtl", std::move(obj.mtl)});
  for (std::size_t i = 0; i < obj.pictures.size(); ++i) {
    files.push_back({fmt::format("{}-{}.png", stem, i + 1), std::move(obj.pictures[i])});
  }
  return std::move(obj.obj);
}

// `files`: written next to the output.
std::string convert(LoadedScene& scene, const Options& options, std::vector<ImportedFile>& files,
                    Context& context) {
  drop_notes(scene.diagnostics);
  const ConvertTo to = *options.to;
  // False without assets, which are not loaded to write a scene file.
  const bool path = lit_by_faces_only(scene);
  if (path) {
    use_face_materials(scene.ready.scene, scene.assets, assumed_transparent, to != ConvertTo::pov,
                       scene.diagnostics);
  }
  switch (to) {
    case ConvertTo::xml:
    case ConvertTo::json:
      break;
    case ConvertTo::pov:
      return write_pov_file(scene, path, options, context);
    case ConvertTo::glb:
    case ConvertTo::gltf:
      return write_gltf_file(scene, path, options, context);
    case ConvertTo::obj:
      return write_obj_file(scene, path, options, files, context);
  }
  return write_scene_file(scene, options, context);
}

// Which assets the format needs.
LoadDepth depth_for(ConvertTo format) {
  switch (format) {
    case ConvertTo::xml:
    case ConvertTo::json:
      return LoadDepth::prepared;
    case ConvertTo::pov:
    case ConvertTo::glb:
    case ConvertTo::gltf:
    case ConvertTo::obj:
      break;
  }
  return LoadDepth::with_all_assets;
}

std::string summary_text(const ConvertReport& report) {
  return fmt::format("{}: {}, {} bytes\n",
                     report.output == "-" ? "<stdout>" : escaped(report.output, 4096),
                     format_name(report.format), report.bytes);
}

// Prints a verdict only if there are findings.
std::string findings_of(const LoadedScene& scene, bool quiet) {
  const bool color = wants_color(Stream::chatter);
  if (quiet || status_of(scene) != ExitCode::fine) {
    return findings_text(scene, quiet ? Verbosity::errors : Verbosity::warnings, color);
  }
  return report_text(scene, scene.diagnostics, {.color = color});
}

}  // namespace

ExitCode run_convert(const Options& options, Context& context) {
  ConvertReport report{.output = options.arguments[1], .format = *options.to};
  const std::array output{named_file("output", report.output)};
  if (const Outcome refused = claim_outputs(output, context); refused.status != ExitCode::fine) {
    return fail(refused);
  }
  std::vector<ImportedFile> files;
  const bool model = is_model(options.arguments[0]);
  if (model) {
    if (const ExitCode status = check_model_target(report); status != ExitCode::fine) {
      return status;
    }
  }
  if (model || report.format == ConvertTo::obj) {
    if (const ExitCode status = check_several(report); status != ExitCode::fine) {
      return status;
    }
  }
  LoadedScene scene =
      model ? import_model(options.arguments[0], report.output, options, files, context)
            : load_scene(options.arguments[0], options, depth_for(report.format),
                         /*allow_missing=*/true, context);
  std::string text;
  if (status_of(scene) == ExitCode::fine) {
    text = model ? write_scene(scene.written, scene_format(report.format), options.load.limits,
                               scene.diagnostics)
                 : convert(scene, options, files, context);
  }
  if (!options.json) {
    say(findings_of(scene, options.quiet));
  }
  context.phase = "writing the file";
  Outcome outcome = outcome_of(scene);
  report.bytes = text.size();
  if (outcome.status == ExitCode::fine) {
    outcome = write_model(report.output, text, files, context);
  }
  report.error = outcome.error;
  if (options.json) {
    return used_standard_output() ? outcome.status
                                  : answer_json(outcome, convert_json(scene, report));
  }
  if (status_of(scene) == ExitCode::fine && !report.error.empty()) {
    say_error(report.error);
  } else if (outcome.status == ExitCode::fine && !options.quiet) {
    say_afterwards([&] { return summary_text(report); });
  }
  return outcome.status;
}

}  // namespace scenefile::app
