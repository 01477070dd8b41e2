#pragma once

#include "common/base/status.h"

namespace burnish {

/// gRPC's number for a code.
int status_code_to_wire(StatusCode code);

/// A number that has no counterpart of its own becomes kInternal.
StatusCode status_code_from_wire(int code);

}  // namespace burnish
