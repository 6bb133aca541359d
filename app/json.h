#pragma once
// The answers of the commands as JSON documents.

#include "app/gl_picture.h"
#include "app/option_table.h"
#include "app/realtime.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/summary.h"
#include "scenefile/verbs/load_file.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

/// A part of a picture that was drawn alone.
struct PartReport {
  std::uint32_t index = 0;  ///< counted from 0
  std::uint32_t count = 1;
  PixelRegion region;
  bool skipped = false;  ///< its file was there
};

/// What a render came to.
struct RenderReport {
  RenderOptions options;
  std::string output;
  std::string error;   ///< empty: the picture was written
  double seconds = 0;  ///< wall time of everything
  RenderStats stats;
  GlReport gl;  ///< of --engine gl
  std::optional<RealtimeReport> realtime;
  std::optional<PartReport> part;
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

std::string command_json(const Command& command);
std::string code_json(const Code& code);
/// All commands and all codes.
std::string help_json();

}  // namespace scenefile::app
