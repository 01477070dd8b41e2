#include "server/prepare/prepared_file.h"

#include <cstddef>
#include <cstring>
#include <string>
#include <xxhash.h>

#include "server/prepare/prepared_checks.h"

namespace burnish {

template <typename T>
static std::span<const uint8_t> as_bytes(std::span<const T> elements) {
  return {reinterpret_cast<const uint8_t*>(elements.data()), elements.size_bytes()};
}

std::array<std::span<const uint8_t>, kPreparedSections> section_bytes(
    const PreparedMesh& prepared) {
  return {as_bytes(prepared.vertices),  as_bytes(prepared.triangles),
          as_bytes(prepared.colours),   as_bytes(prepared.evaluation),
          as_bytes(prepared.cells),     as_bytes(prepared.integrals),
          as_bytes(prepared.curvature), as_bytes(prepared.passages),
          as_bytes(prepared.sheets),    as_bytes(prepared.sheet_integrals)};
}

uint64_t prepared_checksum(std::span<const uint8_t> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

uint64_t header_checksum(const PreparedHeader& header) {
  return XXH3_64bits(&header, offsetof(PreparedHeader, checksum));
}

static std::array<double, 3> to_array(const Vec3d& v) {
  return {v.x(), v.y(), v.z()};
}

static Vec3d to_vector(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

static void put_statistics(const MeshStatistics& from, PreparedHeader& header) {
  header.statistics_counts = {
      from.vertices,   from.triangles,           from.boundary_edges,       from.non_manifold_edges,
      from.components, from.zero_area_triangles, from.unreferenced_vertices};
  header.area = from.area;
  header.signed_volume = from.signed_volume;
  header.mean_edge_length = from.mean_edge_length;
  header.box_min = to_array(from.box_min);
  header.box_max = to_array(from.box_max);
}

static MeshStatistics get_statistics(const PreparedHeader& header) {
  const auto& counts = header.statistics_counts;
  MeshStatistics statistics;
  statistics.vertices = counts[0];
  statistics.triangles = counts[1];
  statistics.boundary_edges = counts[2];
  statistics.non_manifold_edges = counts[3];
  statistics.components = counts[4];
  statistics.zero_area_triangles = counts[5];
  statistics.unreferenced_vertices = counts[6];
  statistics.area = header.area;
  statistics.signed_volume = header.signed_volume;
  statistics.mean_edge_length = header.mean_edge_length;
  statistics.box_min = to_vector(header.box_min);
  statistics.box_max = to_vector(header.box_max);
  return statistics;
}

template <typename T>
static SectionEntry entry_of(PreparedSection id, std::span<const T> elements) {
  return {static_cast<uint32_t>(id), sizeof(T), elements.size(), 0,
          prepared_checksum(as_bytes(elements))};
}

PreparedHeader make_prepared_header(const PreparedMesh& prepared) {
  PreparedHeader header = {};
  header.magic = kPreparedMagic;
  header.version = kPreparedFormatVersion;
  header.depth = static_cast<uint32_t>(prepared.frame.depth);
  header.grid_origin = to_array(prepared.frame.origin);
  header.cell_size = prepared.frame.cell_size;
  header.length_unit = prepared.length_unit;
  header.curvature_radius = prepared.curvature_radius;
  put_statistics(prepared.statistics, header);
  header.has_double_positions = prepared.has_double_positions;
  header.histogram_range = prepared.histogram.range;
  header.histogram_area = prepared.histogram.area;
  header.walls_share = prepared.walls.share;
  header.walls_depth = static_cast<uint64_t>(prepared.walls.depth);
  header.sections = {entry_of(PreparedSection::kVertices, prepared.vertices),
                     entry_of(PreparedSection::kTriangles, prepared.triangles),
                     entry_of(PreparedSection::kColours, prepared.colours),
                     entry_of(PreparedSection::kEvaluation, prepared.evaluation),
                     entry_of(PreparedSection::kCells, prepared.cells),
                     entry_of(PreparedSection::kIntegrals, prepared.integrals),
                     entry_of(PreparedSection::kCurvature, prepared.curvature),
                     entry_of(PreparedSection::kPassages, prepared.passages),
                     entry_of(PreparedSection::kSheets, prepared.sheets),
                     entry_of(PreparedSection::kSheetIntegrals, prepared.sheet_integrals)};
  header.file_bytes = sizeof(PreparedHeader);
  for (SectionEntry& entry : header.sections) {
    entry.offset = align_section(header.file_bytes);
    header.file_bytes = entry.offset + entry.count * entry.element_bytes;
  }
  header.checksum = header_checksum(header);
  return header;
}

// Needs: a checked table.
template <typename T>
static std::span<const T> elements_of(PreparedSection id, const PreparedHeader& header,
                                      std::span<const uint8_t> file) {
  const SectionEntry& entry = header.sections[static_cast<int>(id)];
  return {reinterpret_cast<const T*>(file.data() + entry.offset), entry.count};
}

static ThinWalls walls_of(const PreparedHeader& header) {
  return {header.walls_share, static_cast<int>(header.walls_depth)};
}

static PreparedMesh mesh_over(const PreparedHeader& header, std::span<const uint8_t> file) {
  PreparedMesh mesh;
  mesh.frame = {to_vector(header.grid_origin), header.cell_size, static_cast<int>(header.depth)};
  mesh.length_unit = header.length_unit;
  mesh.curvature_radius = header.curvature_radius;
  mesh.statistics = get_statistics(header);
  mesh.has_double_positions = header.has_double_positions != 0;
  mesh.histogram = {header.histogram_range, header.histogram_area};
  mesh.walls = walls_of(header);
  mesh.vertices = elements_of<Vec3d>(PreparedSection::kVertices, header, file);
  mesh.triangles = elements_of<Triangle>(PreparedSection::kTriangles, header, file);
  mesh.colours = elements_of<Rgba8>(PreparedSection::kColours, header, file);
  mesh.evaluation = elements_of<EvaluationPoint>(PreparedSection::kEvaluation, header, file);
  mesh.cells = elements_of<MortonKey>(PreparedSection::kCells, header, file);
  mesh.integrals = elements_of<CellIntegrals>(PreparedSection::kIntegrals, header, file);
  mesh.curvature = elements_of<CellCurvature>(PreparedSection::kCurvature, header, file);
  mesh.passages = elements_of<uint32_t>(PreparedSection::kPassages, header, file);
  mesh.sheets = elements_of<CellSheet>(PreparedSection::kSheets, header, file);
  mesh.sheet_integrals = elements_of<CellIntegrals>(PreparedSection::kSheetIntegrals, header, file);
  return mesh;
}

Result<PreparedHeader> parse_prepared_header(std::span<const uint8_t> beginning,
                                             uint64_t file_bytes) {
  if (beginning.size() < sizeof(PreparedHeader))
    return data_loss("length of the file is " + std::to_string(file_bytes) + ", its header needs " +
                     std::to_string(sizeof(PreparedHeader)));
  PreparedHeader header;
  std::memcpy(&header, beginning.data(), sizeof(header));
  RETURN_IF_ERROR(check_header(header, file_bytes));
  RETURN_IF_ERROR(check_scalars(header));
  return header;
}

PreparedSummary summary_of(const PreparedHeader& header) {
  const auto count = [&](PreparedSection id) {
    return header.sections[static_cast<int>(id)].count;
  };
  PreparedSummary summary;
  summary.length_unit = header.length_unit;
  summary.cell_size = header.cell_size;
  summary.histogram = {header.histogram_range, header.histogram_area};
  summary.walls = walls_of(header);
  summary.vertices = count(PreparedSection::kVertices);
  summary.cells = count(PreparedSection::kCells);
  for (const SectionEntry& entry : header.sections)
    summary.byte_count += entry.count * entry.element_bytes;
  return summary;
}

Result<PreparedMesh> parse_prepared_file(std::span<const uint8_t> file) {
  ASSIGN_OR_RETURN(const PreparedHeader header, parse_prepared_header(file, file.size()));
  RETURN_IF_ERROR(check_section_checksums(header, file));
  PreparedMesh mesh = mesh_over(header, file);
  RETURN_IF_ERROR(check_contents(mesh));
  return mesh;
}

}  // namespace burnish
