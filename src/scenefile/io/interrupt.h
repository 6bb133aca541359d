#pragma once

namespace scenefile {

/// Makes SIGINT and SIGTERM set a flag instead of ending the process; a second one of either ends
/// it at once.
void watch_signals();

/// The signal that came (2 or 15), or 0.
int pending_signal();

}  // namespace scenefile
