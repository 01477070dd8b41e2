#pragma once

#include <string>

namespace burnish {

/// Returns in plain words why a server cannot be reached. `reason` is the text of gRPC, whose other
/// texts stay as they are.
std::string why_unreachable(const std::string& reason);

}  // namespace burnish
