#pragma once
// A language server for scene files: a function of messages, without files, threads and clocks.
// Source of the protocol: "Language Server Protocol", version 3.17.
//
// Findings while a scene is edited, completion, explanations of words and findings, corrections,
// formatting, the outline, templates (where they are declared, all their uses, new names), and
// colors. Files that are not scenes have no findings.

#include "scenefile/asset/load_assets.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// How the textures and meshes of a scene are read; `uri` is that of the scene, such as
/// file:///home/ann/chess.xml, and `path` its path, or its name if it is not a file.
using FilesOfScene = std::function<FetchFile(const std::string& uri, const std::string& path)>;

class LanguageServer {
 public:
  /// Without a function, or with one that returns an empty one, scenes are checked without their
  /// textures and meshes.
  explicit LanguageServer(FilesOfScene files = {});
  ~LanguageServer();

  /// Takes one message, JSON without its header, and returns those to send. `now`: seconds, of any
  /// clock that does not go back.
  std::vector<std::string> handle(std::string_view body, double now);

  /// When tick() has something to do; nullopt: not before the next message.
  std::optional<double> next_tick() const;
  /// Checks what was not changed for a while.
  std::vector<std::string> tick(double now);

  /// Set after the notification exit: 0 if the client asked for the shutdown before, otherwise 1.
  std::optional<int> exit_status() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace scenefile
