#include "app/diff.h"

namespace scenefile::app {

ExitCode run_diff(const Options& options, Context& context) {
  return diff_scenes(options, context);
}

}  // namespace scenefile::app
