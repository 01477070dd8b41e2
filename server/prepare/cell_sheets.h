#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "server/prepare/surface.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

/// The sheets of those cells through which several components of the mesh pass.
struct CellSheets {
  std::vector<CellSheet> sheets;         ///< by cell, then by component
  UnsetVector<CellIntegrals> integrals;  ///< one per sheet
};

/// None where more than one cell in four has several, or a cell more than kSheetsPerCellMax: such a
/// scan is a soup, whose components say nothing.
/// Shapes: `cells` strictly rising, with their passages; pieces by cell, also of cells left out.
/// Fails: as `admit` does, which is asked for so many sheets before they take memory.
Result<CellSheets> find_cell_sheets(const Surface& surface, std::span<const CellPiece> pieces,
                                    std::span<const MortonKey> cells,
                                    std::span<const Passages> passages,
                                    const std::function<Status(size_t sheets)>& admit);

}  // namespace burnish
