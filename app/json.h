#pragma once
// The JSON output of the commands.

#include "app/gl_picture.h"
#include "app/option_table.h"
#include "app/realtime.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/mistakes/cause_help.h"
#include "scenefile/scene/summary.h"
#include "scenefile/verbs/load_file.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

/// The work on a store.
struct StoreReport {
  std::size_t found = 0;               ///< bands that existed
  std::size_t drawn = 0;               ///< new bands
  std::vector<std::uint32_t> missing;  ///< shares, counted from 1, if these were requested
};

/// The result of a render.
struct RenderReport {
  RenderOptions options;
  std::string output;
  std::string error;   ///< empty: success
  double seconds = 0;  ///< total wall time
  RenderStats stats;
  GlReport gl;  ///< for --engine gl
  std::optional<RealtimeReport> realtime;
  std::optional<StoreReport> store;
  bool written = false;  ///< the picture
};
std::string render_json(const LoadedScene& scene, const RenderReport& report);

/// The result of info.
struct InfoReport {
  SceneSummary summary;
  std::optional<Bounds> bounds;  ///< nullopt: nothing is drawn
  std::vector<AssetFile> files;
  std::string tree;  ///< empty: not requested
  std::optional<RealtimeReport> realtime;
};
/// `report`: null if the scene cannot be used; `error` then says so.
std::string info_json(const LoadedScene& scene, const InfoReport* report,
                      const std::string& error = {});

/// The result of a conversion.
struct ConvertReport {
  std::string output;
  ConvertTo format = ConvertTo::xml;
  std::string error = {};  ///< empty: success
  std::size_t bytes = 0;
};
std::string convert_json(const LoadedScene& scene, const ConvertReport& report);

/// The result of formatting a file.
struct FormatReport {
  std::string scene;  ///< text of parsed_file_json()
  bool changed = false;
  std::string error = {};  ///< empty: success
};
std::string format_json(const std::vector<FormatReport>& files, bool check);

/// The answer of a command that failed before it had one. `configuration`: scene_json() of a
/// configuration that cannot be used, or empty.
std::string failure_json(std::string_view command, std::string_view error,
                         std::string_view configuration = {});

std::string command_json(const Command& command);
std::string code_json(const Code& code);
std::string cause_json(Cause cause);
/// The codes of a family, or all, and the cause that has the name of the family.
std::string codes_json(std::string_view family = {}, std::optional<Cause> cause = {});
std::string causes_json();
std::string limits_json();
/// All commands, codes, causes and limits.
std::string help_json();
/// The words of the format (scene/vocabulary_words.h): those with this name, or all.
std::string vocabulary_json(std::string_view name = {});

}  // namespace scenefile::app
