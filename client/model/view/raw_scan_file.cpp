// Reads raw scans from files. A browser has none of this: its scans are a server's.

#include <future>
#include <utility>

#include "client/model/view/raw_scan.h"
#include "client/scene/raw_pages.h"
#include "common/mesh/io/mesh_io.h"

namespace burnish {

// Memory that reading may take: that of a file of 1 GB, and of a smaller one if it is packed.
static constexpr uint64_t kRawReadingBytesMax = 12'000'000'000;

bool can_be_raw(const std::filesystem::path& file) {
  const auto format = mesh_format_of_path(file);
  if (!format.is_ok()) return false;
  const auto bytes = reading_bytes_max(file, *format);
  return bytes.is_ok() && *bytes <= kRawReadingBytesMax;
}

Result<RawScan> read_raw_scan(const std::filesystem::path& file, uint64_t triangles_max) {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(file));
  ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(file));
  std::error_code ignored;
  RawScan scan{.name = file.filename().string(),
               .file = file,
               .size_bytes = std::filesystem::file_size(file, ignored),
               .vertices = mesh.vertices.size(),
               .triangles = mesh.triangles.size(),
               .has_colours = mesh.has_colours()};
  auto statistics = std::async(std::launch::async, [&mesh] { return compute_statistics(mesh); });
  RawPages raw = make_raw_pages(mesh, triangles_max);
  scan.statistics = statistics.get();
  scan.box = raw.box;
  scan.up = likely_up(raw.box, {}, format);
  scan.pages = std::move(raw.pages);
  scan.space = raw.space;
  return scan;
}

}  // namespace burnish
