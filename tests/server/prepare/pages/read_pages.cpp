#include "tests/server/prepare/pages/read_pages.h"

#include "common/pages/page_file.h"

namespace burnish {

Result<ReadPages> read_pages(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const PageFile file, PageFile::open(path));
  ReadPages read;
  read.directory = file.directory();
  for (PageId id = 0; id < read.directory.head.page_count(); ++id) {
    ASSIGN_OR_RETURN(Page page, file.read_page(id));
    read.pages.push_back(std::move(page));
  }
  return read;
}

Status build_pages_of(const TriangleMesh& mesh, const std::filesystem::path& path,
                      const PagesOptions& options, const Progress& progress, PagesReport* report,
                      const PageTexels& texels) {
  const MeshStatistics statistics = compute_statistics(mesh);
  return build_pages({mesh.vertices, mesh.triangles, mesh.colours, statistics, texels}, path,
                     options, progress, report);
}

}  // namespace burnish
