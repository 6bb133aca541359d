#pragma once
// Findings as SARIF 2.1.0 (OASIS), the format that code hosts and editors show beside the lines.

#include "scenefile/verbs/load_scene.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The path under which a reader of the log finds a file that the scene names; empty: nowhere.
using FindPath = std::function<std::string(const std::string& name)>;

/// Collects the findings of several scenes, one log with one run.
class SarifLog {
 public:
  /// The scene's findings, after apply_policy(). Those in a mesh are placed in its file.
  void add(const LoadedScene& scene, const FindPath& find_path);
  /// `exit_status` is what the program is going to end with.
  std::string text(int exit_status) const;

 private:
  struct Entry {
    std::string scene;  ///< its path
    std::string file;   ///< the path of the mesh that the finding is in; empty: in the scene
    Location used_at;   ///< where the scene names the mesh
    Diagnostic finding;
    std::string fingerprint;  ///< stays when lines in front of it come and go
  };
  std::vector<Entry> entries_;
  std::vector<std::string> unreadable_;
  std::map<std::string_view, const Code*> rules_;  ///< those that occur, by name
};

}  // namespace scenefile
