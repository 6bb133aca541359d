#pragma once

namespace scenefile {

/// For programs, called once at the start. From then on SIGHUP, SIGINT and SIGTERM end the process
/// at once, in whatever it is doing, with status 129, 130 and 143, after removing the temporary
/// file of a write_file() in progress. Signals that the caller of the program ignores stay ignored.
/// A closed pipe or a file size limit becomes an error of the write instead of a signal.
void handle_signals();

}  // namespace scenefile
