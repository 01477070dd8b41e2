// Triangles per second of one core that become drawable and that move: page_mesh_bench [TRIANGLES]

#include <cmath>
#include <cstdio>
#include <string>

#include "client/scene/page_mesh.h"
#include "client/scene/page_space.h"
#include "common/generate/generate.h"
#include "tests/bench/timing.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {
namespace {

constexpr size_t kPageTriangles = 3500;
constexpr int kDepth = 8;
constexpr int kRepeats = 11;

std::vector<Vec3f> wave(const PageMesh& mesh) {
  std::vector<Vec3f> displacements;
  for (const Vec3f& p : mesh.positions)
    displacements.emplace_back(std::sin(20 * p.y()), std::cos(15 * p.z()), std::sin(30 * p.x()));
  return displacements;
}

void report(const char* what, double triangles, double ms) {
  std::printf("%-24s %8.2f ms %8.1f M triangles/s\n", what, ms, triangles / ms / 1e3);
}

Status run(uint64_t triangles) {
  ASSIGN_OR_RETURN(const TriangleMesh scan,
                   generate_scan({.kind = "blob", .vertices = triangles / 2}));
  const SplitMesh split = split_into_pages(scan, kPageTriangles);
  std::vector<PageMesh> meshes;
  std::vector<std::vector<Vec3f>> displacements;
  for (const Page& page : split.pages) {
    meshes.push_back(make_page_mesh(page, split.grid));
    displacements.push_back(wave(meshes.back()));
  }
  const float cell_size = make_page_space(split.grid, kDepth).cell_size;
  const auto count = static_cast<double>(scan.triangles.size());
  std::printf("%.0f triangles, %zu pages\n", count, meshes.size());
  size_t vertices = 0;  // keeps the work from being left out
  report("made", count, median_milliseconds(kRepeats, 1, [&] {
           for (const Page& page : split.pages)
             vertices += make_page_mesh(page, split.grid).normals.size();
         }));
  report("moved", count, median_milliseconds(kRepeats, 1, [&] {
           for (size_t i = 0; i < meshes.size(); ++i)
             vertices += displace(meshes[i], displacements[i], cell_size).normals.size();
         }));
  return vertices > 0 ? Status::ok() : internal_error("no vertex was made");
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const burnish::Status status = burnish::run(count > 1 ? std::stoull(words[1]) : 1'000'000);
  if (!status.is_ok()) std::fprintf(stderr, "page_mesh_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
