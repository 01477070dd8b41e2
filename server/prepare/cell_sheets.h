#pragma once

#include <functional>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/status.h"
#include "server/prepare/surface.h"

namespace burnish {

/// The sheets of the cells through which several components of the mesh pass.
struct CellSheets {
  ScratchArray<CellSheet> sheets;         ///< by cell, then by component
  ScratchArray<CellIntegrals> integrals;  ///< one per sheet
};

/// Finds the sheets. Finds none if more than one cell in four has several, or a cell has more than
/// kSheetsPerCellMax: such a scan is a soup, whose components mean nothing. Shapes: `cells`
/// strictly rising, with their passages; pieces by cell, also of cells left out. Fails: as `admit`
/// does; it is asked for the number of sheets before they take memory. Throws: WorkCancelled.
Result<CellSheets> find_cell_sheets(const Surface& surface, std::span<const CellPiece> pieces,
                                    std::span<const MortonKey> cells,
                                    std::span<const Passages> passages, const ScratchSpace& space,
                                    const std::function<Status(size_t sheets)>& admit,
                                    const LoopPart& part);

}  // namespace burnish
