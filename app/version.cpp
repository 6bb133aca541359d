#include "app/command.h"
#include "app/json.h"
#include "app/output.h"

namespace scenefile::app {

ExitCode run_version(const Options& options, Context& /*context*/) {
  return answer(options.json ? version_json(SCENEFILE_VERSION)
                             : std::string("scenefile " SCENEFILE_VERSION "\n"));
}

}  // namespace scenefile::app
