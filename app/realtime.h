#pragma once
// The options of --profile realtime.

#include "app/options.h"
#include "scenefile/grade/realtime_causes.h"
#include "scenefile/verbs/realtime_report.h"

#include <optional>
#include <string>

namespace scenefile::app {

/// The assignment's settings from the options; nullopt for other profiles.
std::optional<RealtimeOptions> realtime_options(const Options& options);

/// Which settings are not given, so that diff and grade must find them in the reference.
RealtimeUnknowns realtime_unknowns(const Options& options);

/// Checks combinations of options. Returns an error message, as a phrase that follows "scenefile:
/// "; empty on success.
std::string check_realtime_options(const Options& options);

}  // namespace scenefile::app
