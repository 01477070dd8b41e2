#pragma once

#include <nlohmann/json.hpp>

#include "common/measure/deviation.h"

namespace burnish {

/// Returns a deviation as JSON, in the terms of Deviation.
nlohmann::ordered_json deviation_json(const Deviation& deviation);

}  // namespace burnish
