#pragma once

#include <cstdint>
#include <string>

namespace burnish {

/// Returns a moment in universal time: "2026-11-23T18:35:29Z".
std::string utc_text(int64_t unix_ms);

}  // namespace burnish
