#pragma once
// Private to the io room: the temporary file of a write in progress, for the signal handler.

#include <string>

namespace scenefile {

/// Registers the path to remove if a signal ends the process. One at a time.
void guard_temporary(const std::string& path);
/// Call after the file was renamed or removed.
void release_temporary();
/// Removes the registered file, if there is one. Async-signal-safe.
void remove_guarded_temporary();

/// A unique, unpredictable name in `folder`.
std::string temporary_name(const std::string& folder);

}  // namespace scenefile
