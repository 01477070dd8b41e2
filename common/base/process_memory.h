#pragma once

#include <cstdint>
#include <filesystem>

namespace burnish {

uint64_t resident_bytes();       ///< this process's resident memory now
uint64_t peak_resident_bytes();  ///< its largest since the start or the last reset
/// Starts the peak anew; false and without effect where the kernel does not allow it.
bool reset_peak_resident_bytes();
/// What the machine can still give without swapping.
uint64_t available_memory_bytes();

/// What the cgroups of this process allow, the smallest of all above it; a container or a unit of
/// systemd is one. The largest number where there is no limit. `root` is the machine's "/".
uint64_t cgroup_memory_bytes_max(const std::filesystem::path& root = "/");

/// What this process can have at all: the machine's memory or its cgroups' limit.
uint64_t machine_memory_bytes();

}  // namespace burnish
