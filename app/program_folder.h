#pragma once

#include <string>

namespace scenefile::app {

/// The folder that holds this program, not a link to it; empty if the system does not say.
std::string program_folder();

/// The folder of the documentation: in a clone or in an installation. Empty if there is none.
std::string documentation_folder();

}  // namespace scenefile::app
