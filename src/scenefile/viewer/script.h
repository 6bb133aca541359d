#pragma once
// Scripted user input for the window, for tests and screenshots.
//
// One step per line; empty lines and lines that begin with # are ignored. Positions are in pixels
// of the window, from its top left.
//
//     key Ctrl+S            press and release a key that has an effect
//     hold W 10             hold a key for so many frames
//     move 400 300          the pointer goes there
//     press left            or middle, right
//     release left
//     drag left 400 300 500 320 10      from, to, in so many frames
//     click 400 300
//     wheel -2
//     drop PATH             drop a file or folder into the window
//     frames 5              draw so many frames
//     settle                draw until nothing is pending: files, rays, comparisons
//     screenshot OUT.png
//     copy FROM TO          as an editor would that saves the scene
//     copied OUT.txt        write what the window copied last
//     times OUT.tsv         write how long each frame so far kept input waiting
//     quit

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::viewer {

enum class StepKind : std::uint8_t {
  key,
  hold,
  move,
  press,
  release,
  wheel,
  drop,
  frames,
  settle,
  screenshot,
  copy,
  copied,
  times,
  quit,
};

/// Members that the step does not use have their default values.
struct ScriptStep {
  StepKind kind = StepKind::frames;
  std::string text;   ///< key or path
  std::string other;  ///< the second path
  double x = 0;       ///< pixels; wheel: steps upward in y
  double y = 0;
  int number = 1;          ///< frames, or the button: 0 left, 1 right, 2 middle
  std::uint32_t line = 0;  ///< 0: not from a text
};

struct Script {
  std::vector<ScriptStep> steps;
  std::string wrong;  ///< an error in one line, "line 3: ..."; empty: valid
};

/// Steps that take several frames become several steps, because each frame does at most one.
Script parse_script(std::string_view text);

}  // namespace scenefile::viewer
