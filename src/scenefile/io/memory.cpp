#include "scenefile/io/memory.h"

#include "scenefile/io/descriptor.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace scenefile {

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t max_text = 1 << 16;

// Kernel files have no size to query. Returns an empty text if the file cannot be read.
std::string kernel_text(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.open()) {
    return {};
  }
  const Result<std::string> text = read_all(file.get(), path, 0, max_text);
  return text ? *text : std::string();
}

// "max" and an absent file mean no limit.
std::uint64_t limit_in(const std::string& path) {
  const std::string text = kernel_text(path);
  std::uint64_t limit = unlimited;
  std::from_chars(text.data(), text.data() + text.size(), limit);
  return limit;
}

// The smallest limit of the group and its parents.
std::uint64_t min_upwards(const std::string& root, std::string group, const char* file) {
  std::uint64_t least = unlimited;
  while (true) {
    if (group == "/") {
      group.clear();
    }
    least = std::min(least, limit_in(root + group + "/" + file));
    const std::size_t slash = group.rfind('/');
    if (slash == std::string::npos) {
      return least;
    }
    group.resize(slash);
  }
}

std::uint64_t physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? std::uint64_t(pages) * std::uint64_t(page) : unlimited;
}

// The type of `resource` differs between C libraries.
std::uint64_t soft_limit(auto resource) {
  rlimit limit{};
  return ::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur
                                                                               : unlimited;
}

}  // namespace

std::uint64_t cgroup_memory_limit(std::string_view membership, const std::string& root) {
  std::uint64_t least = unlimited;
  while (!membership.empty()) {
    const std::size_t end = std::min(membership.find('\n'), membership.size());
    const std::string_view line = membership.substr(0, end);
    membership.remove_prefix(std::min(end + 1, membership.size()));
    // "4:memory:/group" in version 1, "0::/group" in version 2.
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string_view::npos || second == std::string_view::npos) {
      continue;
    }
    const std::string_view controllers = line.substr(first + 1, second - first - 1);
    const std::string group(line.substr(second + 1));
    if (controllers.empty()) {
      least = std::min(least, min_upwards(root, group, "memory.max"));
    } else if (controllers == "memory") {
      least = std::min(least, min_upwards(root + "/memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

std::uint64_t default_memory_limit() {
  const std::uint64_t cgroup =
      cgroup_memory_limit(kernel_text("/proc/self/cgroup"), "/sys/fs/cgroup");
  return std::min({physical_memory(), cgroup, soft_limit(RLIMIT_AS), soft_limit(RLIMIT_DATA)}) / 5 *
         4;
}

void limit_memory([[maybe_unused]] std::uint64_t bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) == 0) {
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

std::uint64_t memory_in_use() {
  // Two numbers of pages: total, then resident.
  const std::string text = kernel_text("/proc/self/statm");
  const std::size_t blank = text.find(' ');
  std::uint64_t pages = 0;
  if (blank != std::string::npos) {
    std::from_chars(text.data() + blank + 1, text.data() + text.size(), pages);
  }
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void return_free_memory() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t large = std::uintptr_t{1} << 21;
  const auto start = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (start + large - 1) / large * large;
  const std::uintptr_t last = (start + bytes) / large * large;
  if (first < last) {
    ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  }
#endif
}

}  // namespace scenefile
