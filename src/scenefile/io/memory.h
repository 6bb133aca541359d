#pragma once
// Memory limits of the process.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace scenefile {

/// 80 % of the smallest of physical memory, the limits of the process's control groups (v1 and v2)
/// and its resource limits, in bytes.
std::uint64_t default_memory_limit();

/// Limits memory for data (stacks and heap; not code or reserved address space) to this many bytes;
/// allocations beyond that throw std::bad_alloc. Never raises an existing limit. Does nothing under
/// sanitizers, which need extra memory.
void limit_memory(std::uint64_t bytes);

/// Resident memory of the process in bytes; 0 if unknown.
std::uint64_t memory_in_use();

/// Returns freed memory to the system if the C library keeps it.
void return_free_memory();

/// Requests 2 MB pages for a range of memory that has not been written yet. If granted, the first
/// use takes a third of the time.
void ask_for_large_pages(void* begin, std::size_t bytes);

/// The smallest limit of the control groups in `membership` (the text of /proc/self/cgroup) and
/// their parents, read from files below `root` (/sys/fs/cgroup); UINT64_MAX if there is none.
std::uint64_t cgroup_memory_limit(std::string_view membership, const std::string& root);

}  // namespace scenefile
