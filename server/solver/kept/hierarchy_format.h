#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "server/prepare/prepared_file.h"

namespace burnish {

// The hierarchy file, little-endian throughout:
//
//   offset 0   HierarchyHeader: magic, format version, fingerprint, length of the whole file, the
//              scalars, and last a checksum of all of that and of the table
//   offset 64  the table: one SectionEntry (prepared_file.h) for each array, in the order in which
//              visit_arrays() calls them
//   then       the sections at the next multiples of 64 bytes, as plain arrays; zeros in between,
//              and where a struct has padding
//
// It has the arrays that are dear to make. A reader makes cells_of_corner, row_of_corner and the
// rows of tiles itself: that takes no longer than reading them.
//
// Checksums are XXH3-64 without a seed, that of the header by sealed_checksum(). They find damage.
// Every index that could lead a solver outside its arrays is also checked by itself
// (hierarchy_checks.h). A file of another version or fingerprint is never converted: it can be made
// again from the prepared mesh.

static_assert(std::endian::native == std::endian::little, "hierarchy files are little-endian");

inline constexpr std::array<char, 8> kHierarchyMagic = {'b', 'u', 'r', 'n', 'h', 'i', 'e', '\n'};

struct HierarchyHeader {
  std::array<char, 8> magic;
  uint32_t version;
  int32_t coarsest;
  int32_t finest;
  int32_t first_weak_depth;  ///< of the plan
  uint32_t has_flat_parts;   ///< of the plan
  int32_t sheet_count;       ///< at the finest depth
  uint64_t fingerprint;
  uint64_t file_bytes;
  uint64_t section_count;
  uint64_t checksum;  ///< of the bytes before it, and of the table
};
static_assert(sizeof(HierarchyHeader) == 64, "no padding: every byte is under the checksum");

inline constexpr size_t kSectionsPerDepth = 34;
inline constexpr size_t kSectionsOfAll = 10;

/// Needs: depths in range.
inline size_t section_count(int coarsest, int finest) {
  return kSectionsPerDepth * static_cast<size_t>(finest - coarsest + 1) + kSectionsOfAll;
}

/// Calls visit(name, vector) for the arrays of one depth that a file has.
template <typename Depth, typename Visit>
void visit_depth_arrays(Depth& depth, Visit&& visit) {
  visit("cells", depth.grid.cells);
  visit("corners", depth.grid.corners);
  visit("corners of cells", depth.grid.cell_corners);
  visit("ties", depth.ties);
  visit("parents", depth.parent_cell);
  visit("starts of children", depth.children.start);
  visit("children", depth.children.item);
  auto& shares = depth.shares;
  visit("parts of cells", shares.part);
  visit("targets of shares", shares.target);
  visit("starts of shares", shares.start);
  visit("shares", shares.share);
  visit("cells apart", shares.apart);
  auto& stencil = depth.stencil;
  visit("corners of rows", stencil.corner_of_row);
  visit("starts of rows", stencil.row_start);
  visit("columns", stencil.column);
  visit("masks", stencil.mask);
  visit("places in tiles", stencil.tiles.twice_local);
  visit("starts of halos", stencil.tiles.halo.start);
  visit("halos", stencil.tiles.halo.item);
  visit("wide tiles", stencil.tiles.is_wide);
  visit("irregular corners", stencil.irregular.corner);
  visit("starts of sums", stencil.irregular.sum_start);
  visit("starts of sources", stencil.irregular.source_start);
  visit("sources", stencil.irregular.source);
  visit("irregular cells", stencil.irregular_cells.cell);
  visit("entries of irregular cells", stencil.irregular_cells.entry);
  auto& transfer = depth.to_parent;
  visit("prolongation", transfer.prolongation);
  visit("shared corners", transfer.shared.corner);
  visit("starts of shared corners", transfer.shared.start);
  visit("coarse corners", transfer.shared.coarse_corner);
  visit("weights of coarse corners", transfer.shared.weight);
  visit("starts of the restriction", transfer.restriction_start);
  visit("restriction", transfer.restriction_corner);
  visit("weights of the restriction", transfer.restriction_weight);
}

template <typename P, typename Visit>
void visit_patch_arrays(P& patches, Visit&& visit) {
  visit("starts of patches", patches.start);
  visit("corners of patches", patches.corner);
  visit("starts of colours", patches.colour_start);
  visit("starts of entries", patches.entry_start);
}

/// Calls visit(name, vector) for each array of a file, in its order, the coarsest depth first.
template <typename H, typename Plan, typename Visit>
void visit_arrays(H& hierarchy, Plan& plan, Visit&& visit) {
  for (auto& depth : hierarchy.depths) visit_depth_arrays(depth, visit);
  visit("starts of points", hierarchy.points.start);
  visit("points", hierarchy.points.item);
  visit_patch_arrays(hierarchy.small_components, visit);
  visit_patch_arrays(plan.patches, visit);
}

uint64_t hierarchy_checksum(const HierarchyHeader& header, std::span<const SectionEntry> table);

/// Checks magic, version, fingerprint, depths and length. Fails: data_loss.
Status check_hierarchy_header(const HierarchyHeader& header, uint64_t fingerprint, int depth,
                              uint64_t file_bytes);

/// Checks the table, for elements of these sizes. Needs: a checked header. Fails: data_loss.
Status check_hierarchy_table(const HierarchyHeader& header, std::span<const SectionEntry> table,
                             std::span<const uint32_t> element_bytes);

}  // namespace burnish
