#pragma once
// Helpers for reading scene texts in tests.

#include "scenefile/format/read_scene.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::testing {

struct Reading {
  Scene scene;
  Diagnostics diagnostics;
};

inline Reading read(std::string_view text, const ReadOptions& options = {}) {
  Reading reading{{}, Diagnostics(options.limits)};
  reading.scene = read_scene(text, options, reading.diagnostics);
  return reading;
}

inline Reading read_compat(std::string_view text) {
  ReadOptions options;
  options.compat_course = true;
  return read(text, options);
}

inline std::string_view severity_text(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

/// Each finding as "4:18 error xml.number".
inline std::vector<std::string> findings(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics.list()) {
    result.push_back(fmt::format("{}:{} {} {}", d.location.line, d.location.column,
                                 severity_text(d.severity), d.code->name));
  }
  return result;
}

inline std::vector<std::string> found(const Reading& reading) {
  return findings(reading.diagnostics);
}

/// The findings in a text.
inline std::vector<std::string> found(std::string_view text, const Limits& limits = {}) {
  ReadOptions options;
  options.limits = limits;
  return findings(read(text, options).diagnostics);
}

/// Each finding as "4:18 message".
inline std::vector<std::string> messages(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics.list()) {
    result.push_back(fmt::format("{}:{} {}", d.location.line, d.location.column, d.message));
  }
  return result;
}

inline std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A scene whose root contains `inside`, starting on line 3.
inline std::string in_root(std::string_view inside) {
  return fmt::format(
      "<scenefile>\n<object type=\"tree\" name=\"root\">\n{}\n</object>\n</scenefile>\n", inside);
}

/// A scene with a cube in a transblock after `transforms`, on line 4.
inline std::string with_transforms(std::string_view transforms) {
  return in_root(fmt::format(
      "<transblock>\n{}\n<object type=\"primitive\" name=\"cube\"/>\n</transblock>", transforms));
}

/// A scene with a cube with the properties `inside`, on line 5.
inline std::string with_material(std::string_view inside) {
  return in_root(fmt::format(
      "<transblock>\n<object type=\"primitive\" name=\"cube\">\n{}\n</object>\n</transblock>",
      inside));
}

/// A scene with `inside` before the root, on line 2.
inline std::string with_top(std::string_view inside) {
  return fmt::format("<scenefile>\n{}\n<object type=\"tree\" name=\"root\"/>\n</scenefile>\n",
                     inside);
}

}  // namespace scenefile::testing
