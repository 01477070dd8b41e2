#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/base/limits.h"
#include "common/edit/brush.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// β everywhere that is not painted.
struct SetGradientScale {
  double beta = kBetaDefault;
};

/// α as a function of curvature; a constant curve is the isotropic fidelity weight.
struct SetTransferCurve {
  TransferCurve curve{kAlphaDefault};
};

/// Overrides of single cells, as `--cell-field` reads them; cells not named keep their fields.
struct SetCellFields {
  struct Cell {
    Vec3i cell;     ///< grid units
    double alpha1;  ///< user units
    double alpha2;  ///< user units
    double beta;
  };
  std::vector<Cell> cells;
};

/// One change of a session. The id is the client's choice: applying an id twice is harmless.
struct Edit {
  std::string id;
  std::variant<SetGradientScale, SetTransferCurve, Stroke, SetCellFields> change;
};

/// What can be wrong without knowing the mesh: every value against its limit.
Status validate(const Edit& edit);

}  // namespace burnish
