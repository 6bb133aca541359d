// Replaces view.cpp if the program is built without src/scenefile/viewer.

#include "app/command.h"
#include "app/output.h"

namespace scenefile::app {

ExitCode run_view(const Options& /*options*/, Context& /*context*/) {
  return fail(ExitCode::environment,
              "view: this program was built without a window (SCENEFILE_VIEWER); "
              "\"scenefile render\" draws to a file");
}

}  // namespace scenefile::app
