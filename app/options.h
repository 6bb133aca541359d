#pragma once
// The command line as data.

#include "app/completion.h"
#include "app/names.h"
#include "scenefile/base/realtime.h"
#include "scenefile/compare/measure.h"
#include "scenefile/format/read_config.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/visit_options.h"
#include "scenefile/verbs/findings.h"
#include "scenefile/verbs/load_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::app {

struct Command;
struct OptionRow;

/// A pixel, counted from 0 at the top left.
struct PixelPlace {
  int x = 0;
  int y = 0;
};

/// A share of the work, counted from 0.
struct PartPlace {
  std::uint32_t index = 0;
  std::uint32_t count = 1;
};

/// Frames from the first to the last, counted from 1.
struct FrameRange {
  int first = 1;
  int last = 1;
};

/// An option given on the command line.
struct GivenOption {
  const OptionRow* row = nullptr;
  std::string value;  ///< empty: a flag
};

/// A configuration of the course's programs as the words of a command.
struct Configured {
  LoadedScene file;  ///< name, text and findings
  ConfigKind kind = ConfigKind::ray;
  std::string scene;               ///< empty: there is no configuration
  std::string output;              ///< the default of --output
  std::vector<std::string> words;  ///< options such as "--samples=50"
};

struct Options {
  std::vector<std::string> arguments;  ///< scenes, or the topic of help
  std::vector<GivenOption> given;

  std::string output;
  bool any_extension = false;  ///< `output` is a PNG if its extension is not known
  Engine engine = Engine::trace;
  bool realtime = false;                 ///< --profile realtime; `engine` is then gl
  RealtimeOptions realtime_panel;        ///< for `realtime`
  RenderOptions render;                  ///< complete, with the profile's defaults
  Tone tone = Tone::course;              ///< mode path: of PNG files
  double exposure = 0;                   ///< mode path: of PNG files, in stops
  double seconds = 0;                    ///< mode path: time for samples; 0: no limit
  std::string store;                     ///< a folder for the work done so far; empty: none
  std::optional<PartPlace> part;         ///< only this share of the work of the store
  std::optional<std::uint32_t> missing;  ///< list the missing of this many shares

  std::optional<int> turntable;     ///< frames: number of frames of a full turn
  std::string path;                 ///< frames: a file with views; empty: none
  std::optional<FrameRange> range;  ///< frames: which ones; default: all
  std::optional<double> fps;        ///< frames: frames per second
  std::string write_scenes;         ///< frames: pattern for scene files; empty: none
  std::string video;                ///< frames: an output file; empty: none
  bool overwrite = false;           ///< frames: also replace files of other motions

  LoadSettings load;
  AssetAccess access;
  FindingPolicy policy;                     ///< for check
  std::optional<std::uint64_t> max_memory;  ///< bytes; default: most of the memory
  std::optional<double> timeout;            ///< seconds

  std::optional<ConvertTo> to;
  int segments = 64;  ///< per full turn of round shapes, in formats that only have triangles
  std::optional<PixelPlace> pixel;
  std::optional<std::uint32_t> sample;  ///< the sample to describe in full
  std::string reference;                ///< view, explain: the right picture
  std::string mine;                     ///< the picture of another program
  std::string layer;                    ///< of EXR files with layers that are read

  std::string scene;  ///< the scene of the reference picture
  std::string heatmap;
  std::string sheet;
  std::string energy;  ///< diff: an SVG of light by bounces
  Thresholds thresholds;
  int pixel_threshold = 8;  ///< in 1/255
  std::string references;
  std::string scenes;
  std::string report;
  std::string title;  ///< of the report; empty: the name of the class's folder
  std::string junit;
  std::string csv;
  std::string csv_students;
  std::string gradescope;
  std::string pages;     ///< a folder for one page per student
  std::string name_map;  ///< a file that assigns pictures to references

  std::array<int, 2> window{};  ///< size in pixels; 0: as remembered
  bool live_trace = false;
  std::string screenshot;
  int frames = 1;
  std::string script;

  bool assets = true;

  bool check = false;  ///< only report what would change
  bool fix = false;
  bool stdio = false;    ///< has no effect
  bool dry_run = false;  ///< show what `fix` would change
  bool files = false;
  bool tree = false;
  bool json = false;
  bool sarif = false;
  bool markdown = false;
  bool man = false;
  std::optional<Shell> completion;
  bool quiet = false;
  bool help = false;
};

/// Parses the words after the command. Returns an error text, as a phrase that follows "scenefile:
/// "; empty on success. A configuration takes the place of the only argument; its options are those
/// that the command has, and were not given in `words`.
std::string parse_options(const Command& command, std::span<const char* const> words,
                          Options& options, const Configured& configured);

/// What the configuration gives as --output; empty if the command has none, and for frames, unless
/// it is a pattern.
std::string configured_output(const Command& command, const Configured& configured);

/// The argument, if a command that draws pictures has only one and it is a configuration; otherwise
/// empty.
std::string config_argument(const Command& command, std::span<const char* const> words);

/// Whether the words after the command contain --json, and the command has this option. The words
/// may be wrong otherwise.
bool asks_for_json(const Command& command, std::span<const char* const> words);

/// Whether an option, such as "--samples", was given.
bool was_given(const Options& options, std::string_view name);

/// The first given option, or layer, that selects mode path: --mode path, or what only this mode
/// has; else empty.
std::string path_option(const Options& options);
/// Sets mode path, with its defaults for what was not given.
void set_path_mode(Options& options);
/// Whether scenes that only faces light are drawn in mode path.
bool may_choose_path_mode(const Options& options);
/// The first given option, or layer, that mode path does not have; else empty.
std::string option_without_paths(const Options& options);

/// options.render with the defaults of this profile.
RenderOptions render_options(const Options& options, Profile profile);

}  // namespace scenefile::app
