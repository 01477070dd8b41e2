#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/base/status.h"
#include "common/edit/colour_filter.h"
#include "common/edit/edge_filter.h"
#include "common/edit/equaliser.h"
#include "common/edit/palette.h"

namespace burnish {

v1::Equaliser to_wire(const Equaliser& equaliser);
/// Values are checked with the edit: check_equaliser().
Equaliser from_wire(const v1::Equaliser& message);

v1::Palette to_wire(const Palette& palette);
/// Names and colours are checked with the edit: check_palette(). Fails: as TransferCurve::create().
Result<Palette> from_wire(const v1::Palette& message);

v1::ColourFilter to_wire(const ColourFilter& filter);
/// Returns what keeps the colours for a message that is absent. Values are checked with the edit.
ColourFilter from_wire(const v1::ColourFilter& message, bool is_there);

v1::EdgeFilter to_wire(const EdgeFilter& filter);
/// Fails: invalid_argument for an unknown kind of filter.
Result<EdgeFilter> from_wire(const v1::EdgeFilter& message);

}  // namespace burnish
