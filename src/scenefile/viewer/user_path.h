#pragma once
// Where the window keeps files of the user, by the XDG base directory specification.

#include <string>
#include <string_view>

namespace scenefile::viewer {

/// The path of the file `name` in the folder scenefile of `xdg`, the value of a variable such as
/// XDG_CONFIG_HOME, if that is an absolute path; otherwise in `usual` (such as ".config") of
/// `home`. Empty if neither is given.
std::string user_path(const char* xdg, const char* home, std::string_view usual,
                      std::string_view name);

}  // namespace scenefile::viewer
