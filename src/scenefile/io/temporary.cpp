#include "scenefile/io/temporary.h"

#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>

namespace scenefile {

namespace {

// Static, because a signal handler must not allocate memory.
std::array<char, 4096> guarded_path;
std::atomic<bool> guarded = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void guard_temporary(const std::string& path) {
  if (path.size() < guarded_path.size()) {
    std::memcpy(guarded_path.data(), path.c_str(), path.size() + 1);
    guarded = true;
  }
}

void release_temporary() {
  guarded = false;
}

void remove_guarded_temporary() {
  if (guarded) {
    ::unlink(guarded_path.data());
  }
}

std::string temporary_name(const std::string& folder) {
  std::uint64_t random = 0;
  if (::getrandom(&random, sizeof random, 0) != sizeof random) {
    random = static_cast<std::uint64_t>(::getpid());
  }
  return fmt::format("{}/.scenefile-{:016x}.tmp", folder, random);
}

}  // namespace scenefile
