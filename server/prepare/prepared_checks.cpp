#include "server/prepare/prepared_checks.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>

#include "common/base/limits.h"
#include "server/prepare/passages.h"

namespace burnish {

namespace {

constexpr std::array<const char*, kPreparedSections> kNames = {
    "vertices",  "triangles", "colours",  "evaluation", "cells",
    "integrals", "curvature", "passages", "sheets",     "sheet integrals"};
constexpr std::array<uint32_t, kPreparedSections> kElementBytes = {
    sizeof(Vec3d),     sizeof(Triangle),      sizeof(Rgba8),         sizeof(EvaluationPoint),
    sizeof(MortonKey), sizeof(CellIntegrals), sizeof(CellCurvature), sizeof(uint32_t),
    sizeof(CellSheet), sizeof(CellIntegrals)};

std::string section(PreparedSection id) {
  return std::string("section ") + kNames[static_cast<int>(id)];
}

Status check_equal(const std::string& what, uint64_t value, uint64_t wanted) {
  if (value == wanted) return Status::ok();
  return data_loss(what + " is " + std::to_string(value) + ", must be " + std::to_string(wanted));
}

Status check_at_most(const std::string& what, uint64_t value, uint64_t most) {
  if (value <= most) return Status::ok();
  return data_loss(what + " is " + std::to_string(value) + ", must be at most " +
                   std::to_string(most));
}

Status check_table(const PreparedHeader& header) {
  uint64_t end = sizeof(PreparedHeader);
  for (int i = 0; i < kPreparedSections; ++i) {
    const SectionEntry& entry = header.sections[i];
    const std::string where = section(static_cast<PreparedSection>(i)) + ": ";
    const uint64_t offset = align_section(end);
    RETURN_IF_ERROR(check_equal(where + "id", entry.id, i));
    RETURN_IF_ERROR(check_equal(where + "element size", entry.element_bytes, kElementBytes[i]));
    RETURN_IF_ERROR(check_equal(where + "offset", entry.offset, offset));
    RETURN_IF_ERROR(check_at_most(where + "offset", offset, header.file_bytes));
    const uint64_t room = (header.file_bytes - offset) / entry.element_bytes;
    RETURN_IF_ERROR(check_at_most(where + "count", entry.count, room));
    end = offset + entry.count * entry.element_bytes;
  }
  return check_equal("the end of the last section", end, header.file_bytes);
}

Status check_counts(const PreparedMesh& prepared) {
  const auto check = [](PreparedSection id, uint64_t count, uint64_t wanted) {
    return check_equal(section(id) + ": count", count, wanted);
  };
  const uint64_t vertices = prepared.vertices.size();
  const uint64_t triangles = prepared.triangles.size();
  const uint64_t cells = prepared.cells.size();
  RETURN_IF_ERROR(check(PreparedSection::kVertices, vertices, prepared.statistics.vertices));
  RETURN_IF_ERROR(check(PreparedSection::kTriangles, triangles, prepared.statistics.triangles));
  RETURN_IF_ERROR(check_at_most("section vertices: count", vertices, kVerticesMax));
  RETURN_IF_ERROR(check_at_most("section triangles: count", triangles, kTrianglesMax));
  RETURN_IF_ERROR(check_at_most("section cells: count", cells, INT32_MAX));
  if (!prepared.colours.empty())
    RETURN_IF_ERROR(check(PreparedSection::kColours, prepared.colours.size(), vertices));
  RETURN_IF_ERROR(check(PreparedSection::kEvaluation, prepared.evaluation.size(), vertices));
  RETURN_IF_ERROR(check(PreparedSection::kIntegrals, prepared.integrals.size(), cells));
  RETURN_IF_ERROR(check(PreparedSection::kCurvature, prepared.curvature.size(), cells));
  RETURN_IF_ERROR(check(PreparedSection::kPassages, prepared.passages.size(), cells));
  return check(PreparedSection::kSheetIntegrals, prepared.sheet_integrals.size(),
               prepared.sheets.size());
}

/// Returns the least number below `count` that is bad, or `count`. Calls is_bad() from several
/// threads.
template <typename IsBad>
size_t first_bad(size_t count, const IsBad& is_bad) {
  size_t first = count;
#pragma omp parallel for schedule(static) reduction(min : first)
  for (size_t i = 0; i < count; ++i)
    if (i < first && is_bad(i)) first = i;
  return first;
}

Status check_triangles(const PreparedMesh& prepared) {
  const size_t vertices = prepared.vertices.size();
  const auto is_outside = [&](uint32_t v) { return v >= vertices; };
  const size_t t = first_bad(prepared.triangles.size(), [&](size_t i) {
    return std::ranges::any_of(prepared.triangles[i], is_outside);
  });
  if (t == prepared.triangles.size()) return Status::ok();
  const uint32_t v = *std::ranges::find_if(prepared.triangles[t], is_outside);
  return data_loss("section triangles: triangle " + std::to_string(t) + " refers to vertex " +
                   std::to_string(v) + " of " + std::to_string(vertices));
}

Status check_evaluation(const PreparedMesh& prepared) {
  const auto cells = static_cast<int32_t>(prepared.cells.size());
  const size_t v = first_bad(prepared.evaluation.size(), [&](size_t i) {
    const int32_t cell = prepared.evaluation[i].cell;
    return cell != kNone && (cell < 0 || cell >= cells);
  });
  if (v == prepared.evaluation.size()) return Status::ok();
  return data_loss("section evaluation: vertex " + std::to_string(v) + " lies in cell " +
                   std::to_string(prepared.evaluation[v].cell) + " of " + std::to_string(cells));
}

Status check_cells(const PreparedMesh& prepared) {
  const MortonKey end = MortonKey{1} << 3 * prepared.frame.depth;
  const auto is_rising = [&](size_t c) {
    return c == 0 || prepared.cells[c - 1] < prepared.cells[c];
  };
  const size_t c = first_bad(prepared.cells.size(),
                             [&](size_t i) { return !is_rising(i) || prepared.cells[i] >= end; });
  if (c == prepared.cells.size()) return Status::ok();
  return data_loss(
      "section cells: key " + std::to_string(prepared.cells[c]) + " of cell " + std::to_string(c) +
      (is_rising(c) ? " is outside the grid of depth " + std::to_string(prepared.frame.depth)
                    : std::string(" is not above the one before it")));
}

Status check_passages(const PreparedMesh& prepared) {
  const auto unknown = [&](size_t c) { return prepared.passages[c] & ~kAllPassages; };
  const size_t c = first_bad(prepared.passages.size(), [&](size_t i) { return unknown(i) != 0; });
  if (c == prepared.passages.size()) return Status::ok();
  return data_loss("section passages: bit " + std::to_string(std::countr_zero(unknown(c))) +
                   " of cell " + std::to_string(c) + " is set but does not stand for a neighbour");
}

Status check_sheets(const PreparedMesh& prepared) {
  const CellSheet* last = nullptr;
  int in_cell = 0;
  for (size_t s = 0; s < prepared.sheets.size(); ++s) {
    const CellSheet& sheet = prepared.sheets[s];
    const auto fail = [&](const std::string& what) {
      return data_loss("section sheets: sheet " + std::to_string(s) + what);
    };
    if (sheet.cell < 0 || static_cast<size_t>(sheet.cell) >= prepared.cells.size())
      return fail(" names cell " + std::to_string(sheet.cell) + " of " +
                  std::to_string(prepared.cells.size()));
    if (last != nullptr &&
        std::tie(sheet.cell, sheet.component) <= std::tie(last->cell, last->component))
      return fail(" is not above the one before it");
    if ((sheet.passages & ~prepared.passages[sheet.cell]) != 0)
      return fail(" has passages that its cell " + std::to_string(sheet.cell) + " does not have");
    in_cell = last != nullptr && last->cell == sheet.cell ? in_cell + 1 : 1;
    if (in_cell > kSheetsPerCellMax)
      return fail(" is number " + std::to_string(in_cell) + " of cell " +
                  std::to_string(sheet.cell) + ", the limit is " +
                  std::to_string(kSheetsPerCellMax));
    last = &sheet;
  }
  return Status::ok();
}

}  // namespace

Status check_header(const PreparedHeader& header, uint64_t actual_file_bytes) {
  if (header.magic != kPreparedMagic) return data_loss("header: this is not a prepared mesh");
  RETURN_IF_ERROR(check_equal("header: format version", header.version, kPreparedFormatVersion));
  RETURN_IF_ERROR(check_equal("header: checksum", header.checksum, header_checksum(header)));
  RETURN_IF_ERROR(check_equal("length of the file", actual_file_bytes, header.file_bytes));
  return check_table(header);
}

Status check_scalars(const PreparedHeader& header) {
  const auto check_range = [](const std::string& name, double value, double least, double most) {
    if (value >= least && value <= most) return Status::ok();  // false for NaN
    std::ostringstream message;
    message << "header: " << name << " is " << value << ", must be in " << least << ".." << most;
    return data_loss(message.str());
  };
  const double max = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  RETURN_IF_ERROR(check_range("depth", header.depth, kDepthMin, kDepthMax));
  RETURN_IF_ERROR(check_range("cell size", header.cell_size, least, max));
  RETURN_IF_ERROR(check_range("length unit", header.length_unit, least, max));
  RETURN_IF_ERROR(check_range("curvature radius", header.curvature_radius, 0, max));
  RETURN_IF_ERROR(check_range("area", header.area, least, max));
  RETURN_IF_ERROR(check_range("signed volume", header.signed_volume, -max, max));
  RETURN_IF_ERROR(check_range("mean edge length", header.mean_edge_length, 0, max));
  RETURN_IF_ERROR(check_range("double positions", header.has_double_positions, 0, 1));
  RETURN_IF_ERROR(check_range("histogram range", header.histogram_range, least, max));
  RETURN_IF_ERROR(check_range("share of thin walls", header.walls_share, 0, 1));
  RETURN_IF_ERROR(
      check_range("depth of thin walls", static_cast<double>(header.walls_depth), 0, kDepthMax));
  for (int axis = 0; axis < 3; ++axis) {
    RETURN_IF_ERROR(check_range("grid origin", header.grid_origin[axis], -max, max));
    RETURN_IF_ERROR(check_range("box", header.box_min[axis], -max, max));
    RETURN_IF_ERROR(check_range("box", header.box_max[axis], header.box_min[axis], max));
  }
  for (float area : header.histogram_area)
    RETURN_IF_ERROR(check_range("histogram area", area, 0, max));
  return Status::ok();
}

Status check_section_checksums(const PreparedHeader& header, std::span<const uint8_t> file) {
  std::array<uint64_t, kPreparedSections> sums;
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < kPreparedSections; ++i) {
    const SectionEntry& entry = header.sections[i];
    sums[i] = prepared_checksum(file.subspan(entry.offset, entry.count * entry.element_bytes));
  }
  for (int i = 0; i < kPreparedSections; ++i)
    RETURN_IF_ERROR(check_equal(section(static_cast<PreparedSection>(i)) + ": checksum", sums[i],
                                header.sections[i].checksum));
  return Status::ok();
}

Status check_contents(const PreparedMesh& prepared) {
  RETURN_IF_ERROR(check_counts(prepared));
  RETURN_IF_ERROR(check_triangles(prepared));
  RETURN_IF_ERROR(check_evaluation(prepared));
  RETURN_IF_ERROR(check_cells(prepared));
  RETURN_IF_ERROR(check_passages(prepared));
  return check_sheets(prepared);
}

}  // namespace burnish
