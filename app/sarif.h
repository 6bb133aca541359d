#pragma once
// Findings as SARIF 2.1.0 (OASIS), the format that code hosts and editors show beside the lines.

#include "app/load.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::app {

/// Collects the findings of several scenes, one log with one run.
class SarifLog {
 public:
  /// The scene's findings, after apply_policy(). Those in a mesh are placed in its file.
  void add(const LoadedScene& scene, const Options& options);
  /// `status` is what the program is going to exit with.
  std::string text(ExitCode status) const;

 private:
  struct Result {
    std::string scene;  ///< as given on the command line
    std::string file;   ///< the path of the mesh that the finding is in; empty: in the scene
    Location used_at;   ///< where the scene names the mesh
    Diagnostic finding;
    std::string fingerprint;  ///< stays when lines in front of it come and go
  };
  std::vector<Result> results_;
  std::vector<std::string> unreadable_;
  std::map<std::string_view, const Code*> rules_;  ///< those that occur, by name
};

}  // namespace scenefile::app
