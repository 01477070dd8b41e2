#pragma once

#include <filesystem>
#include <vector>

#include "common/mesh/triangle_mesh.h"
#include "common/pages/directory.h"
#include "server/prepare/pages/build_pages.h"

namespace burnish {

/// A page file read whole.
struct ReadPages {
  PageDirectory directory;
  std::vector<Page> pages;  ///< by number

  int level_count() const { return directory.head.level_count(); }
};

/// Fails: what PageFile says.
Result<ReadPages> read_pages(const std::filesystem::path& path);

/// Makes the page file of a mesh. Fails: as build_pages() does.
Status build_pages_of(const TriangleMesh& mesh, const std::filesystem::path& path,
                      const PagesOptions& options = {}, const Progress& progress = {},
                      PagesReport* report = nullptr, const PageTexels& texels = {});

}  // namespace burnish
