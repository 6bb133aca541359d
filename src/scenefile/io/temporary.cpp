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

enum class SlotState : int { free, claimed, guarded };

// Static, because a signal handler must not allocate memory.
struct Slot {
  std::atomic<SlotState> state = SlotState::free;
  std::array<char, 4096> path{};
};
std::array<Slot, 64> slots;
static_assert(std::atomic<SlotState>::is_always_lock_free);

// The slot that now holds the path; -1 if there is none for it.
int guard(const std::string& path) {
  for (std::size_t i = 0; i < slots.size() && path.size() < slots[i].path.size(); ++i) {
    SlotState expected = SlotState::free;
    if (slots[i].state.compare_exchange_strong(expected, SlotState::claimed)) {
      std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
      slots[i].state = SlotState::guarded;
      return static_cast<int>(i);
    }
  }
  return -1;
}

void release(int slot) {
  if (slot >= 0) {
    slots[static_cast<std::size_t>(slot)].state = SlotState::free;
  }
}

}  // namespace

Temporary::~Temporary() {
  if (!path_.empty() && !kept_) {
    ::unlink(path_.c_str());
  }
  release(slot_);
}

void Temporary::choose(const std::string& folder) {
  std::uint64_t random = 0;
  if (::getrandom(&random, sizeof random, 0) != sizeof random) {
    random = static_cast<std::uint64_t>(::getpid());
  }
  path_ = fmt::format("{}/.scenefile-{:016x}.tmp", folder, random);
  slot_ = guard(path_);
}

void Temporary::keep() {
  kept_ = true;
  release(slot_);
  slot_ = -1;
}

void remove_temporaries() {
  for (const Slot& slot : slots) {
    if (slot.state == SlotState::guarded) {
      ::unlink(slot.path.data());
    }
  }
}

}  // namespace scenefile
