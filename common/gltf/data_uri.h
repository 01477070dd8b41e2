#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// Returns whether a URI holds its bytes itself: "data:" in any case, as RFC 2397 says.
bool is_data_uri(std::string_view uri);

/// Returns where the base64 of a data URI begins; npos if its bytes are written in another way.
size_t find_base64(std::string_view uri);

/// Decodes a data URI. `place` begins the messages; `steps` hears of each character. Fails:
/// invalid_argument (not base64, damaged).
Result<std::vector<uint8_t>> read_data_uri(std::string_view uri, const std::string& place,
                                           const FileSteps& steps = {});

}  // namespace burnish
