#pragma once

#include <string>

namespace scenefile::app {

/// The folder that contains this program, with links resolved; empty if the system does not tell.
std::string program_folder();

/// The folder of the documentation: in a clone or in an installation. Empty if there is none.
std::string documentation_folder();

}  // namespace scenefile::app
