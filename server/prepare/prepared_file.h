#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <span>

#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

// The prepared file, little-endian throughout:
//
//   offset 0     PreparedHeader: magic, format version, length of the whole file, the scalars of
//                PreparedMesh, the table of sections, and last a checksum of all of that
//   offset 1088  the sections in the order of PreparedSection, each at the next multiple of 64
//                bytes, as plain arrays of the structs that PreparedMesh shows; zeros in between
//
//   section      element             bytes   count
//   vertices     Vec3d                  24   v
//   triangles    Triangle               12   t
//   colours      Rgba8                   4   0 or v
//   evaluation   EvaluationPoint        16   v
//   cells        MortonKey               8   c, strictly rising
//   integrals    CellIntegrals          736   c
//   curvature    CellCurvature          12   c
//   passages     uint32_t                4   c
//   sheets       CellSheet              12   s, by cell, then by component
//   and theirs   CellIntegrals          736   s
//
// Checksums are XXH3-64 without a seed. The table repeats the values that follow from the counts
// (element sizes, offsets). A reader refuses a file if any of them differs. Checksums find damage.
// Every value that could lead a reader outside its arrays is also checked by itself: indices in
// triangles and evaluation, the order and range of cells, the unused bits of passages.
// Floating-point values inside the sections are as trustworthy as their checksum.
//
// A file of another version is never converted: it can be rebuilt from the scan.

static_assert(std::endian::native == std::endian::little, "prepared files are little-endian");
static_assert(sizeof(Vec3d) == 24 && sizeof(CellCurvature) == 12);

enum class PreparedSection {
  kVertices,
  kTriangles,
  kColours,
  kEvaluation,
  kCells,
  kIntegrals,
  kCurvature,
  kPassages,
  kSheets,
  kSheetIntegrals,
};
inline constexpr int kPreparedSections = 10;
inline constexpr uint64_t kSectionAlignment = 64;
inline constexpr std::array<char, 8> kPreparedMagic = {'b', 'u', 'r', 'n', 'i', 's', 'h', '\n'};

struct SectionEntry {
  uint32_t id;  ///< a PreparedSection
  uint32_t element_bytes;
  uint64_t count;
  uint64_t offset;
  uint64_t checksum;
};

struct PreparedHeader {
  std::array<char, 8> magic;
  uint32_t version;
  uint32_t depth;
  uint64_t file_bytes;
  std::array<double, 3> grid_origin;
  double cell_size;
  double length_unit;
  double curvature_radius;
  std::array<uint64_t, 7> statistics_counts;  ///< in the order of MeshStatistics
  double area;
  double signed_volume;
  double mean_edge_length;
  std::array<double, 3> box_min;
  std::array<double, 3> box_max;
  uint32_t has_double_positions;
  float histogram_range;
  std::array<float, CurvatureHistogram::kBins> histogram_area;
  double walls_share;
  uint64_t walls_depth;
  std::array<SectionEntry, kPreparedSections> sections;
  uint64_t checksum;  ///< of the bytes before it
};
static_assert(sizeof(PreparedHeader) == 1064, "no padding: every byte is under the checksum");

inline uint64_t align_section(uint64_t offset) {
  return (offset + kSectionAlignment - 1) / kSectionAlignment * kSectionAlignment;
}

/// Returns the sections' bytes, inside the mesh.
std::array<std::span<const uint8_t>, kPreparedSections> section_bytes(const PreparedMesh& prepared);

PreparedHeader make_prepared_header(const PreparedMesh& prepared);

uint64_t prepared_checksum(std::span<const uint8_t> bytes);
uint64_t header_checksum(const PreparedHeader& header);

/// Reads the header from the beginning of a file of `file_bytes`. Fails: data_loss that names the
/// wrong part of the header.
Result<PreparedHeader> parse_prepared_header(std::span<const uint8_t> beginning,
                                             uint64_t file_bytes);

PreparedSummary summary_of(const PreparedHeader& header);

/// Reads the checksum of a prepared file's header, which depends on all its bytes. Fails: as
/// read_prepared_summary().
Result<uint64_t> read_prepared_checksum(const std::filesystem::path& path);

/// Reads a whole file's bytes. The mesh's spans point into them, and its storage stays empty.
/// Needs: bytes aligned to 64. Fails: data_loss that names the section and the fault.
Result<PreparedMesh> parse_prepared_file(std::span<const uint8_t> file);

}  // namespace burnish
