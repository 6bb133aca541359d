#pragma once
// Findings about a file. Reading functions never throw, print or exit: they append to a
// Diagnostics and return as much as they could read. After an error the result must not be used;
// after a warning it can be used, with the default that the warning states.

#include "scenefile/base/code.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace scenefile {

/// What to write instead of a word of the file: the answer to "did you mean ...?", as data.
struct Correction {
  /// As in the file, without markup, quotes and escapes. It is the first such word of the tag, of
  /// the key and its value, or of the value that begins at the place of the finding.
  std::string written;
  /// Without escapes. The same as `written` if only its quotes or escapes are wrong; empty to
  /// remove it. Several attributes, as in `x="1" y="2"`, replace the one that is named `written`;
  /// the name of an element may be followed by attributes.
  std::string instead;
  bool certain = true;  ///< false if another word is as likely, or the author has to choose
  Location place{};     ///< of the tag with the word, if it is not at the place of the finding
};

/// One finding.
struct Diagnostic {
  const Code* code = nullptr;
  Severity severity = Severity::error;
  Location location;    ///< in `file`
  std::string file;     ///< empty: the scene file itself; else the mesh or texture as named there
  std::string message;  ///< one line of UTF-8; may hold input text, so escape it before a terminal
  std::vector<std::string> notes = {};  ///< more lines, such as the places searched for a file
  std::optional<Correction> correction = std::nullopt;  ///< if a better word is known
  std::string path{};  ///< of `file`, as this program can open it; empty: not known
};

/// An append-only list of findings with bounded memory: at most `limits.messages_per_code` of each
/// code and `limits.message_bytes` in total are kept; all are counted.
class Diagnostics {
 public:
  explicit Diagnostics(const Limits& limits = {});

  /// Adds a finding with the severity of its code.
  void report(const Code& code, Location location, std::string message);
  /// Adds a finding with another severity.
  void report(const Code& code, Severity severity, Location location, std::string message,
              std::vector<std::string> notes = {});
  /// Adds a finding about a word that was probably meant to be another one.
  void report(const Code& code, Location location, std::string message,
              std::optional<Correction> correction);
  /// Adds a complete finding, for example one about another file.
  void add(Diagnostic diagnostic);

  /// Sets Diagnostic::path of the findings about other files.
  void set_paths(const std::function<std::string(const std::string& file)>& path_of);

  const std::vector<Diagnostic>& list() const { return list_; }
  std::size_t count(Severity severity) const { return counts_[static_cast<int>(severity)]; }
  bool has_errors() const { return count(Severity::error) != 0; }
  /// How many of this kind were counted but not kept.
  std::size_t dropped(const Code& code) const;
  /// How many of any kind were counted but not kept.
  std::size_t dropped() const;

  /// Changes severities and removes findings, for `--strict`, `--deny warnings` and `--allow`:
  /// for each code and reported severity, `decide` returns the new severity, or
  /// nothing to remove the findings. Findings that were counted but not kept are treated alike.
  void rewrite(const std::function<std::optional<Severity>(const Code&, Severity)>& decide);

 private:
  struct Tally {
    std::size_t kept = 0;
    std::size_t dropped[3] = {0, 0, 0};  ///< by severity
  };

  std::vector<Diagnostic> list_;
  std::unordered_map<const Code*, Tally> tallies_;
  std::size_t counts_[3] = {0, 0, 0};
  std::size_t bytes_ = 0;
  std::size_t max_per_code_;
  std::size_t max_bytes_;
};

}  // namespace scenefile
