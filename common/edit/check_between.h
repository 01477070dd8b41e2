#pragma once

#include "common/base/status.h"

namespace burnish {

/// Fails: invalid_argument that names the value and its limits: "edges: strength 2 is outside
/// 0..1".
Status check_between(const char* what, double value, double least, double most);

}  // namespace burnish
