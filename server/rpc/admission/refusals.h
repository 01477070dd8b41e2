#pragma once

#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Logs and counts a refused call. `peer` may be empty: gRPC does not tell it for a call of which
/// it has only the headers.
void report_refusal(std::string_view method, std::string_view peer, const Status& why);

}  // namespace burnish
