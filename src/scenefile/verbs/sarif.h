#pragma once
// Findings as SARIF 2.1.0 (OASIS), which code hosts and editors show next to the lines.

#include "scenefile/edit/fix.h"
#include "scenefile/verbs/load_scene.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Collects the findings of several scenes in a log with one run.
class SarifLog {
 public:
  /// Adds the scene's findings, after apply_policy(). Findings about a mesh get the place in its
  /// file.
  void add(const LoadedScene& scene);
  /// `exit_status` is that of the program.
  std::string text(int exit_status) const;

 private:
  struct Entry {
    std::string scene;  ///< its path
    std::string file;   ///< path of the mesh that the finding is about; empty: the scene
    Location used_at;   ///< where the scene refers to the mesh
    Diagnostic finding;
    std::string fingerprint;  ///< does not change if lines are added or removed before it
    std::vector<Replacement> fixes;
  };
  std::vector<Entry> entries_;
  std::vector<std::string> unreadable_;
  std::map<std::string_view, const Code*> rules_;  ///< those that occur, by name
};

}  // namespace scenefile
