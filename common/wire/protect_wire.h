#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/edit/protect.h"

namespace burnish {

v1::Protect to_wire(const Protect& change);

/// Fails: invalid_argument for an unknown way, or a lasso with other than 16 numbers of its view or
/// an odd number of coordinates. Ranges are checked with the edit.
Result<Protect> from_wire(const v1::Protect& message);

}  // namespace burnish
