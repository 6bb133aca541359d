#pragma once
// The table of all options, used by the parser and the help.

#include "app/options.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

inline constexpr unsigned for_render = 1;
inline constexpr unsigned for_check = 2;
inline constexpr unsigned for_info = 4;
inline constexpr unsigned for_help = 8;
inline constexpr unsigned for_version = 16;
inline constexpr unsigned for_convert = 32;
inline constexpr unsigned for_diff = 64;
inline constexpr unsigned for_format = 128;
inline constexpr unsigned for_explain = 256;
inline constexpr unsigned for_grade = 512;
inline constexpr unsigned for_view = 1024;
inline constexpr unsigned for_frames = 2048;
inline constexpr unsigned for_lsp = 4096;
/// Commands that compare pictures.
inline constexpr unsigned for_pictures = for_diff | for_grade;
/// Options of the tracer.
inline constexpr unsigned for_tracing = for_render | for_explain | for_frames;
/// Options of the profile realtime.
inline constexpr unsigned for_realtime =
    for_render | for_explain | for_frames | for_check | for_info | for_view | for_pictures;
inline constexpr unsigned for_all_readers = for_tracing | for_check | for_info | for_convert;

/// How an option is parsed.
struct OptionParser {
  template <typename Set>
  constexpr OptionParser(Set function, std::span<const std::string_view> accepted = {})
      : set(function), words(accepted) {}

  /// Parses the value. Returns an error text, as a phrase that follows "--name: "; empty on
  /// success.
  std::string (*set)(Options& options, const std::string& value);
  std::span<const std::string_view> words;  ///< words_of()
};

struct OptionRow {
  std::string_view name;    ///< "--size"
  std::string_view letter;  ///< "-o", or empty
  std::string_view value;   ///< "WxH"; empty: a flag
  std::string_view help;
  unsigned commands;  ///< a combination of for_... bits
  OptionParser parser;
  /// The field of RenderOptions that it sets, which determines the engines and profiles that
  /// support it (visit_options.h); if empty, `support` does.
  std::string_view field = {};
  OptionSupport support = supported_everywhere;
  bool sets_defaults = false;  ///< affects the defaults of other options, so it is parsed first
};

/// Options under a heading of the help.
struct OptionGroup {
  std::string_view heading;
  std::span<const OptionRow> rows;
};

/// In the order of the help.
std::span<const OptionGroup> option_groups();

/// Those of a command.
std::vector<const OptionRow*> options_of(const Command& command);

/// The accepted words: one, or if the value is LIST, several separated by commas; empty if the
/// value is not a word.
std::span<const std::string_view> words_of(const OptionRow& row);

/// `; did you mean "word"?` for the nearest known word, or empty.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace scenefile::app
