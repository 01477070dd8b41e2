#pragma once

#include <cstdint>
#include <filesystem>

namespace burnish {

uint64_t resident_bytes();       ///< resident memory of this process now
uint64_t anonymous_bytes();      ///< resident memory now, without mapped files
uint64_t peak_resident_bytes();  ///< largest since the start or the last reset
/// Resets the peak. Returns false, without effect, if the kernel does not allow it.
bool reset_peak_resident_bytes();
/// Returns the memory that the machine can still give without swapping.
uint64_t available_memory_bytes();

/// Returns the smallest memory limit of the cgroups of this process; a container or a systemd unit
/// is a cgroup. Returns the largest uint64_t if there is no limit. `root` is the machine's "/".
uint64_t cgroup_memory_bytes_max(const std::filesystem::path& root = "/");

/// Returns the most that this process can have: the machine's memory or the limit of its cgroups.
uint64_t machine_memory_bytes();

}  // namespace burnish
