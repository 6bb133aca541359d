// Replaces view.cpp if the program is built without src/scenefile/viewer.

#include "app/command.h"
#include "app/output.h"

namespace scenefile::app {

ExitCode run_view(const Options& /*options*/, Context& /*context*/) {
  say_error(
      "view: this program was built without a window (SCENEFILE_VIEWER); "
      "\"scenefile render\" draws to a file");
  return ExitCode::environment;
}

}  // namespace scenefile::app
