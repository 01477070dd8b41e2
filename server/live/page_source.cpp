#include "server/live/page_source.h"

namespace burnish {

ScanPageSource::ScanPageSource(MeshStore& store, std::shared_ptr<const ScanPages> scan,
                               std::shared_ptr<const SharedMesh> mesh)
    : store_(store), scan_(std::move(scan)), mesh_(std::move(mesh)) {}

Result<ScanPageSource::Pages> ScanPageSource::find_or_make(std::span<const PageId> pages,
                                                           PageFrameKind kind) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(shown_, [](const auto& entry) { return entry.second.expired(); });
  }
  Pages found;
  found.reserve(pages.size());
  for (const PageId page : pages) {
    auto live = find({page, kind});
    if (!live) {
      ASSIGN_OR_RETURN(live, make({page, kind}));
    }
    found.push_back(std::move(live));
  }
  return found;
}

// Two clients may make a page at the same time; then the first one counts.
Result<std::shared_ptr<const LivePage>> ScanPageSource::make(const Key& key) {
  const auto [number, kind] = key;
  const SparseGrid& grid = mesh_->hierarchy->at(mesh_->hierarchy->finest).grid;
  const PageGrid& lattice = file().directory().head.grid;
  ASSIGN_OR_RETURN(Page page, store_.read_page(*scan_, page_in_file(number)));
  page.id = number;
  const PageSize size =
      measure_page(page, lattice.bits, grid.depth, !mesh_->prepared->statistics.is_closed());
  ASSIGN_OR_RETURN(Quota::Share memory,
                   store_.memory().take(kServer, predict_page_bytes(size, kind)));
  auto made = std::make_shared<LivePage>(make_live_page(page, size, lattice, grid, kind));
  made->memory = std::move(memory);
  return keep(key, std::move(made));
}

std::shared_ptr<const LivePage> ScanPageSource::find(const Key& key) const {
  const std::lock_guard lock(mutex_);
  const auto known = shown_.find(key);
  return known == shown_.end() ? nullptr : known->second.lock();
}

std::shared_ptr<const LivePage> ScanPageSource::keep(const Key& key,
                                                     std::shared_ptr<const LivePage> made) {
  const std::lock_guard lock(mutex_);
  std::weak_ptr<const LivePage>& known = shown_[key];
  if (auto first = known.lock()) return first;
  known = made;
  return made;
}

std::shared_ptr<ScanPageSource> PageSources::find_or_make(std::shared_ptr<const ScanPages> scan,
                                                          std::shared_ptr<const SharedMesh> mesh) {
  const std::lock_guard lock(mutex_);
  std::erase_if(sources_, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<ScanPageSource>& known = sources_[{scan.get(), mesh.get()}];
  auto source = known.lock();
  if (!source)
    known = source = std::make_shared<ScanPageSource>(store_, std::move(scan), std::move(mesh));
  return source;
}

}  // namespace burnish
