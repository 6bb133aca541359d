#pragma once
// A scene with its findings as JSON, and members shared by the output of several commands.
// The schemas in schema/ describe the documents of check, explain and grade.

#include "scenefile/base/realtime.h"
#include "scenefile/trace/render_options.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Writes the version and the name of the command; the document's object stays open.
void begin_document(Json& json, std::string_view verb);

/// What `check --fix` did to a scene's file.
struct FixReport {
  std::vector<Diagnostic> made;  ///< the findings that were fixed
  std::string error;             ///< why the file could not be written; empty on success
};

/// Adds the scene as a value of the open object or array: path, verdict, findings.
void add_scene(Json& json, const LoadedScene& scene, const FixReport* fixes = nullptr);
/// The same as a separate text.
std::string scene_json(const LoadedScene& scene, const FixReport* fixes = nullptr);

/// A file that was only parsed, as a separate text: path and findings without a verdict.
std::string parsed_file_json(const LoadedScene& file);

/// The document for checked scenes, from texts of scene_json().
std::string check_json(const std::vector<std::string>& scenes);

/// Adds line and column to the open object, if known.
void add_location(Json& json, Location location);

/// Adds size, profile, features and so on to the open object.
void add_render_options(Json& json, const RenderOptions& options);
/// Adds the settings of the assignment Realtime to the open object.
void add_realtime_options(Json& json, const RealtimeOptions& options);

}  // namespace scenefile
