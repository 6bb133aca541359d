#pragma once
// What `scenefile lsp` does with its server. Two sources implement it: the native program reads
// standard input; under Node.js, JavaScript does (bindings/web/serve_editor.cpp).

#include "app/command.h"
#include "scenefile/lsp/language_server.h"

#include <memory>
#include <string>
#include <vector>

namespace scenefile::app {

ExitCode serve_editor(std::unique_ptr<LanguageServer> server);

/// Seconds of a clock that does not go back.
double seconds_now();
/// The messages with their headers.
std::string with_headers(const std::vector<std::string>& messages);
void say_no_header();

}  // namespace scenefile::app
