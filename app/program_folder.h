#pragma once

#include <filesystem>

namespace scenefile::app {

/// The folder that holds this program, not a link to it; empty if the system does not say.
std::filesystem::path program_folder();

/// The folder of the documentation: in a clone or in an installation. Empty if there is none.
std::filesystem::path documentation_folder();

}  // namespace scenefile::app
