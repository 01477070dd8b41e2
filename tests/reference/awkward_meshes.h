#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/mesh/triangle_mesh.h"

/// Meshes of the kinds that scanners and exporters make, with 1 to 20 thousand triangles. Each is
/// valid input, and each breaks some careless preparation or solver.
namespace burnish::reference {

/// Returns both meshes in one, without shared vertices.
TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other);

/// A sheet with boundary on four sides and one bump; the rest is exactly flat and parallel to the
/// grid.
TriangleMesh bumped_sheet(int side);

/// Seven wavy sheets that meet in one edge line: that line's edges have seven triangles each.
TriangleMesh non_manifold_fan(int side);

/// Every triangle on its own three vertices, each moved a little: gaps and overlaps everywhere.
TriangleMesh shaken_soup(const TriangleMesh& mesh, double shake);

/// Scanner noise along the radius.
TriangleMesh noisy_sphere(int level, double noise);

/// Two slightly bent sheets a small part of a cell apart, facing away from each other.
TriangleMesh two_near_sheets(int side, double gap);

/// A closed pyramid of square steps. Steps, and all walls except the outermost, lie in grid planes
/// of every depth from 4 on: multiples of 1/16 of the cube around the box's centre.
TriangleMesh stepped_block(int splits);

/// A sphere with triangles that repeat a vertex, triangles on a line, a double triangle, and
/// vertices that no triangle references, one of them far away.
TriangleMesh sphere_with_debris(int level);

/// Closed, open and tiny parts: spheres of three sizes and orientations, and a loose triangle.
TriangleMesh several_components();

/// Small components that float up to a cell and a half of depth 5 above a sphere, which shrinks
/// beneath them.
TriangleMesh small_components_over_a_sphere();

/// Flat small components of at most half a cell of depth 5, ten times as long as wide and as wide
/// as thick. Some share a corner or two of their cells with the sphere's.
TriangleMesh shards_over_a_sphere();

/// A sphere with a hundred spikes of one vertex each, eight cells of depth 5 high. They taper to
/// less than a cell, so the sheet bends back close to itself.
TriangleMesh spiked_sphere();

/// A cylinder of long thin triangles, twenty times as high as they are wide.
TriangleMesh needles();

/// Returns every kind with its name, for SCOPED_TRACE.
std::vector<std::pair<std::string, TriangleMesh>> awkward_meshes();

}  // namespace burnish::reference
