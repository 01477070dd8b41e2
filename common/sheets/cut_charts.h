#pragma once

#include "common/pages/page.h"
#include "common/sheets/chart.h"

namespace burnish {

/// Cuts a page into charts by planar projection of its triangles, whatever texture coordinates the
/// scan had. So the place of a texel is an affine function of the position, and no page carries
/// texture coordinates. Each chart lies in the smallest rectangle of 12 angles. No side has more
/// than kChartTexelsMax texels, except for that of one triangle alone. No two triangles of a chart
/// cover the same texel's centre.
/// `texels_per_step`: of the finest sheet, texels per step of PageGrid. Needs: check_page() is ok;
/// 0 < texels_per_step < 2^40. The same page gives the same charts.
PageCharts cut_charts(const Page& page, double texels_per_step);

}  // namespace burnish
