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
  /// The scene's findings, after apply_policy().
  void add(const LoadedScene& scene);
  /// `status` is what the program is going to exit with.
  std::string text(ExitCode status) const;

 private:
  struct Result {
    std::string scene;  ///< as given on the command line
    Diagnostic finding;
    std::string fingerprint;  ///< stays when lines in front of it come and go
  };
  std::vector<Result> results_;
  std::vector<std::string> unreadable_;
  std::map<std::string_view, const Code*> rules_;  ///< those that occur, by name
};

}  // namespace scenefile::app
