#pragma once

#include <filesystem>

#include <sys/stat.h>

#include "common/base/status.h"

namespace burnish {

/// Fails: failed_precondition "k.pem can be read by everybody: its mode is 0644, ..." if the file's
/// mode has one of `bits` (S_IROTH, S_IWOTH). `what` names the bits in words. A missing file
/// passes.
Status refuse_mode(const std::filesystem::path& path, mode_t bits, const char* what);

}  // namespace burnish
