#pragma once
// The answers of the commands as JSON documents.

#include "app/gl_picture.h"
#include "app/load.h"
#include "app/option_table.h"
#include "app/realtime.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/diff.h"
#include "scenefile/scene/summary.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

class Json;

/// The version and the name of the command; the document's object stays open.
void begin_document(Json& json, std::string_view command);

/// Size, profile, features and so on, into the object that is open.
void add_render_options(Json& json, const RenderOptions& options);

/// A scene with its findings, as a part of a document.
std::string scene_json(const LoadedScene& scene);

/// `scenes` are texts of scene_json().
std::string check_json(const std::vector<std::string>& scenes);

/// What a render came to.
struct RenderReport {
  RenderOptions options;
  std::string output;
  std::string error;   ///< empty: the picture was written
  double seconds = 0;  ///< wall time of everything
  RenderStats stats;
  GlReport gl;  ///< of --engine gl
  std::optional<RealtimeReport> realtime;
};
std::string render_json(const LoadedScene& scene, const RenderReport& report);

/// What info found.
struct InfoReport {
  SceneSummary summary;
  std::optional<Bounds> bounds;  ///< none: nothing is drawn
  std::vector<AssetFile> files;
  std::string tree;  ///< empty: not asked for
  std::optional<RealtimeReport> realtime;
};
std::string info_json(const LoadedScene& scene, const InfoReport* report);

/// What a conversion came to.
struct ConvertReport {
  std::string output;
  ConvertTo format = ConvertTo::xml;
  std::string error = {};  ///< empty: the scene was written
  std::size_t bytes = 0;
};
std::string convert_json(const LoadedScene& scene, const ConvertReport& report);

/// What became of one file.
struct FormatReport {
  std::string scene;  ///< text of scene_json()
  bool changed = false;
  std::string error = {};  ///< empty: it was written, where it had to be
};
std::string format_json(const std::vector<FormatReport>& files, bool check);

/// `diff`: null when one of the scenes cannot be used.
std::string diff_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff);

std::string command_json(const Command& command);
std::string code_json(const Code& code);
/// All commands and all codes.
std::string help_json();

}  // namespace scenefile::app
