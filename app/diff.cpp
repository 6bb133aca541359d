#include "app/diff.h"

#include "app/load_picture.h"

#include <algorithm>

namespace scenefile::app {

ExitCode run_diff(const Options& options, Context& context) {
  const bool pictures =
      std::any_of(options.arguments.begin(), options.arguments.end(), is_picture_file);
  return pictures ? diff_images(options, context) : diff_scenes(options, context);
}

}  // namespace scenefile::app
