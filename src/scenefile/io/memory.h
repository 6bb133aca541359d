#pragma once
// How much memory the process may use.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// 80 % of the least of what the machine has, what the process's control groups (both versions)
/// and what its resource limits allow, in bytes.
std::uint64_t default_memory_limit();

/// From now on memory for data beyond so many bytes (stacks and heap; not the program's code, nor
/// address space that is only reserved) is refused, so that an allocation throws std::bad_alloc.
/// Never raises a limit that is there already. Nothing happens under sanitizers, which need memory
/// of their own.
void limit_memory(std::uint64_t bytes);

/// How much memory of the machine the process takes now, in bytes; 0 where that is unknown.
std::uint64_t memory_in_use();

/// Gives memory that was freed back to the system, where the C library keeps it for later.
void return_free_memory();

/// Asks the system for pages of 2 MB for a range of memory that nothing has been written to yet,
/// as far as it has room for whole ones. Where it gives them, first use costs a third.
void ask_for_large_pages(void* begin, std::size_t bytes);

/// The least limit that the control groups in `membership` (the text of /proc/self/cgroup) and
/// their parents set, read from files below `root` (/sys/fs/cgroup); UINT64_MAX: none.
std::uint64_t cgroup_memory_limit(std::string_view membership, const std::string& root);

}  // namespace scenefile
