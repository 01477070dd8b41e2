#include "server/prepare/pages/pages_need.h"

#include <algorithm>

#include "server/prepare/pages/triangle_runs.h"

namespace burnish {

namespace {

constexpr uint64_t kBytesInAnyCase = 8 << 20;  // threads' stacks, digits
constexpr uint64_t kBatchBytesMax = 24 << 20;  // of pages on their way to the file
constexpr uint64_t kBatchBytesPerElement = 32;
constexpr uint64_t kHeapLostDivisor = 8;  // what the heap loses between blocks

// Of the file, all levels together.
constexpr uint64_t kFileBytesPerTriangle = 6;
constexpr uint64_t kFileBytesPerVertex = 5;
constexpr uint64_t kFileBytesPerColour = 8;

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

uint64_t batch_bytes(const PagesInput& scan) {
  return std::min(kBatchBytesMax,
                  (scan.triangles.size() + scan.vertices.size()) * kBatchBytesPerElement);
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
  need.memory_bytes = bytes + bytes / kHeapLostDivisor + batch_bytes(scan) + kBytesInAnyCase;
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
