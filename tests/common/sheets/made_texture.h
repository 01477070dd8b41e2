#pragma once

#include "common/sheets/bake_sheet.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"

namespace burnish {

/// Returns a smooth, coloured, opaque pattern over space whose waves are `wave` steps long.
Texel pattern_at(const Vec3d& position, double wave);

/// Returns a page's own triangles with the pattern on them.
BakeSource pattern_on(const Page& page, double wave);

/// Bakes and lays out a sheet of a page. Steps are file units: a density is texels per step.
Sheet baked_sheet(const Page& page, const PageCharts& charts, float density,
                  const BakeSource& source, int samples_per_side);

/// Returns the peak signal-to-noise ratio of a sheet, sampled bilinearly at random places of the
/// page, to the pattern there; dB.
double psnr_to_pattern(const Page& page, const PageCharts& charts, const Sheet& sheet, double wave);

}  // namespace burnish
