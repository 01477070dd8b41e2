#include "server/prepare/pages/pages_need.h"

#include "server/prepare/pages/triangle_runs.h"

namespace burnish {

namespace {

constexpr uint64_t kBytesInAnyCase = 64 << 20;  // a batch of pages, threads' stacks
constexpr uint64_t kHeapLostDivisor = 8;        // what the heap loses between blocks
constexpr uint64_t kFileBytesPerTriangle = 8;   // of the scan, all levels
constexpr uint64_t kColourBytesPerVertex = 8;   // all levels

uint64_t scan_bytes(const PagesInput& scan) {
  return scan.vertices.size_bytes() + scan.triangles.size_bytes() + scan.colours.size_bytes();
}

// Of vertices: place, joined vertex, normal, colour, page, mark.
uint64_t vertex_bytes(const PagesInput& scan) {
  const uint64_t each = sizeof(Vec3i) + sizeof(uint32_t) + sizeof(Vec3f) + sizeof(uint32_t) + 1;
  return scan.vertices.size() * each + scan.colours.size_bytes();
}

// Of triangles: level 0, its pages, and the larger of what cutting and what replacing takes.
uint64_t triangle_bytes(const PagesInput& scan) {
  const uint64_t cutting = sizeof(TriangleCentre) + 3;
  const uint64_t replacing = (2 * sizeof(Triangle) + sizeof(uint32_t)) / 2;
  return scan.triangles.size() *
         (sizeof(Triangle) + sizeof(uint32_t) + std::max(cutting, replacing));
}

std::string mebibytes(uint64_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

}  // namespace

PreparationNeed predict_pages(const PagesInput& scan) {
  PreparationNeed need;
  need.counts.vertices = scan.vertices.size();
  need.counts.triangles = scan.triangles.size();
  need.counts.has_colours = !scan.colours.empty();
  const uint64_t bytes = scan_bytes(scan) + vertex_bytes(scan) + triangle_bytes(scan);
  need.memory_bytes = bytes + bytes / kHeapLostDivisor + kBytesInAnyCase;
  need.file_bytes = scan.triangles.size() * kFileBytesPerTriangle +
                    scan.colours.size() * kColourBytesPerVertex + (1 << 16);
  return need;
}

std::string pages_need_text(const PreparationNeed& need) {
  return "making pages of " + std::to_string(need.counts.triangles) + " triangles takes " +
         mebibytes(need.memory_bytes) + " of memory and a file of " + mebibytes(need.file_bytes);
}

}  // namespace burnish
