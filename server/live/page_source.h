#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "server/library/mesh_store.h"
#include "server/live/live_page.h"

namespace burnish {

/// The pages of one mesh that clients show now. Clients own them together; this only finds them
/// again. Thread-safe.
class ScanPageSource {
 public:
  /// Needs: the store outlives it.
  ScanPageSource(MeshStore& store, std::shared_ptr<const ScanPages> scan,
                 std::shared_ptr<const SharedMesh> mesh);

  const PageFile& file() const { return scan_->file; }
  uint32_t page_count() const { return file().directory().head.page_count(); }

  /// Returns pages in the given order. Reads those that no client shows. Needs: pages of the scan.
  /// Fails: data_loss that names the damage of the page file; resource_exhausted when the server's
  /// memory has no room.
  using Pages = std::vector<std::shared_ptr<const LivePage>>;
  Result<Pages> find_or_make(std::span<const PageId> pages, PageFrameKind kind);

 private:
  using Key = std::pair<PageId, PageFrameKind>;

  Result<std::shared_ptr<const LivePage>> make(const Key& key);
  std::shared_ptr<const LivePage> find(const Key& key) const;
  std::shared_ptr<const LivePage> keep(const Key& key, std::shared_ptr<const LivePage> made);

  MeshStore& store_;
  const std::shared_ptr<const ScanPages> scan_;
  const std::shared_ptr<const SharedMesh> mesh_;
  mutable std::mutex mutex_;  // not held while a page is made
  std::map<Key, std::weak_ptr<const LivePage>> shown_;
};

/// The sources in use. Clients own them together; this only finds them again. Thread-safe.
class PageSources {
 public:
  /// Needs: the store outlives it.
  explicit PageSources(MeshStore& store) : store_(store) {}

  std::shared_ptr<ScanPageSource> find_or_make(std::shared_ptr<const ScanPages> scan,
                                               std::shared_ptr<const SharedMesh> mesh);

 private:
  // After damage a scan has another page file, so the mesh alone is no key.
  using Key = std::pair<const ScanPages*, const SharedMesh*>;

  MeshStore& store_;
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<ScanPageSource>> sources_;
};

}  // namespace burnish
