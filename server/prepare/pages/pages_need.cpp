#include "server/prepare/pages/pages_need.h"

#include <algorithm>

#include "server/prepare/pages/plane_sides.h"
#include "server/prepare/pages/triangle_runs.h"

namespace burnish {

namespace {

constexpr uint64_t kBytesInAnyCase = 10 << 20;  // threads' stacks, digits, the program's own pages
constexpr uint64_t kBatchBytesMax = 24 << 20;   // of pages on their way to the file
constexpr uint64_t kBatchBytesPerElement = 32;
constexpr uint64_t kHeapBytesPerPage = 256;   // bounds, directory, place of the replacement
constexpr uint64_t kTrianglesPerPage = 1000;  // at least, over all levels
constexpr uint64_t kSharedBytesPerVertex =
    40;  // sums of vertices of several pages; most of a soup's whose vertices stay apart

// In the file, all levels together.
constexpr uint64_t kFileBytesPerTriangle = 6;
constexpr uint64_t kFileBytesPerVertex = 5;
constexpr uint64_t kFileBytesPerColour = 8;

uint64_t scan_bytes(const PagesInput& scan) {
  return scan.vertices.size_bytes() + scan.triangles.size_bytes() + scan.colours.size_bytes() +
         2 * scan.texels.of_triangle.size_bytes();
}

// Counts of each vertex: place, joined vertex, normal, colour, page, mark.
uint64_t vertex_bytes(const PagesInput& scan) {
  const uint64_t each = sizeof(Vec3i) + sizeof(uint32_t) + sizeof(Vec3f) + sizeof(uint32_t) + 1;
  return scan.vertices.size() * (each + kSharedBytesPerVertex) + scan.colours.size_bytes();
}

// Counts, while places of vertices are joined: place, sides, joined vertex, twice the sorted hash.
uint64_t joining_bytes(const PagesInput& scan) {
  return scan.vertices.size() *
         (sizeof(Vec3i) + sizeof(PlaneSides) + sizeof(uint32_t) + 2 * 2 * sizeof(uint64_t));
}

// Counts for triangles: level 0, its pages, and the larger of what cutting and what replacing
// takes.
uint64_t triangle_bytes(const PagesInput& scan) {
  const uint64_t cutting = sizeof(TriangleCentre) + 3;
  const uint64_t replacing = (3 * sizeof(Triangle) + sizeof(uint32_t)) / 2;
  return scan.triangles.size() *
         (sizeof(Triangle) + sizeof(uint32_t) + std::max(cutting, replacing));
}

uint64_t batch_bytes(const PagesInput& scan) {
  return std::min(kBatchBytesMax,
                  (scan.triangles.size() + scan.vertices.size()) * kBatchBytesPerElement);
}

std::string mebibytes(uint64_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

}  // namespace

PreparationNeed predict_pages(const PagesInput& scan, uint64_t arrays_bytes_max) {
  PreparationNeed need;
  need.counts.vertices = scan.vertices.size();
  need.counts.triangles = scan.triangles.size();
  need.counts.has_colours = !scan.colours.empty();
  const uint64_t arrays =
      scan_bytes(scan) + std::max(vertex_bytes(scan) + triangle_bytes(scan), joining_bytes(scan));
  const uint64_t in_memory = std::min(arrays, arrays_bytes_max);
  need.memory_bytes = in_memory + batch_bytes(scan) + kBytesInAnyCase +
                      scan.triangles.size() / kTrianglesPerPage * kHeapBytesPerPage;
  need.scratch_bytes = arrays - in_memory;
  need.file_bytes = scan.triangles.size() * kFileBytesPerTriangle +
                    scan.vertices.size() * kFileBytesPerVertex +
                    scan.colours.size() * kFileBytesPerColour + (1 << 16);
  return need;
}

std::string pages_need_text(const PreparationNeed& need) {
  return "making pages of " + std::to_string(need.counts.triangles) + " triangles takes " +
         mebibytes(need.memory_bytes) + " of memory and a file of " + mebibytes(need.file_bytes);
}

}  // namespace burnish
