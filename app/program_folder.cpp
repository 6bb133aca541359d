#include "app/program_folder.h"

#include <filesystem>
#include <system_error>

namespace scenefile::app {

std::string program_folder() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string() : self.parent_path().string();
}

std::string documentation_folder() {
  const std::filesystem::path program = program_folder();
  for (const char* const place : {"../share/doc/scenefile/docs", "../../docs"}) {
    std::error_code error;
    const std::filesystem::path folder = (program / place).lexically_normal();
    if (std::filesystem::exists(folder / "assets.md", error) && !error) {
      return folder.string();
    }
  }
  return {};
}

}  // namespace scenefile::app
