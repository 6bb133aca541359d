#pragma once
// Private to the io room: the temporary file of a write in progress, known to the signal handler.

#include <string>

namespace scenefile {

/// Notes the path as the one to remove should a signal end the process. One at a time.
void guard_temporary(const std::string& path);
/// The file has its final name or is gone.
void release_temporary();
/// Removes the guarded file, if there is one. Async-signal-safe.
void remove_guarded_temporary();

/// A name in `folder` that nobody can guess.
std::string temporary_name(const std::string& folder);

}  // namespace scenefile
