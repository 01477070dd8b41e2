#pragma once

#include <string>

#include "common/edit/equaliser.h"

namespace burnish {

/// Returns bands to begin with, with gains of 1: from some cells of the grid up to a part of the
/// scan. Units: both lengths in file units.
Equaliser first_bands(double cell_size, double diagonal);

/// Describes a band by its details: "finer than 0.8", "0.8 to 2". Shapes: `number` from 1.
std::string details_of(const Equaliser& equaliser, size_t number);

}  // namespace burnish
