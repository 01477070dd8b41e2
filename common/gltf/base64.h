#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"

namespace burnish {

/// Decodes base64 of RFC 4648, with or without padding. Returns nothing if a character or the
/// length is wrong. `steps` hears of each character.
std::optional<std::vector<uint8_t>> from_base64(std::string_view text, FileSteps steps = {});

/// Encodes with padding.
std::string to_base64(std::span<const uint8_t> bytes);

}  // namespace burnish
