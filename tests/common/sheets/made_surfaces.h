#pragma once

#include "common/pages/page.h"
#include "common/sheets/chart.h"

namespace burnish {

/// Returns a page of a height field with `side` x `side` vertices, `spacing` steps apart. Its waves
/// are `height` steps high and 20 squares of a 41-vertex page long, whatever the side.
Page wavy_page(int side, double spacing, double height);

/// Returns a page of a whole sphere around the middle of the lattice.
Page sphere_page(int rings, double radius);

/// Returns a ramp that winds twice around an axis, so that one half lies above the other.
Page ramp_page(double radius);

/// Returns the same page with three vertices of its own for each triangle.
Page torn_page(const Page& page);

/// Returns the area of a page, steps².
double area_of(const Page& page);

/// Returns how many texels two triangles of one chart cover.
size_t covered_twice(const Page& page, const PageCharts& charts, double texels_per_step);

}  // namespace burnish
