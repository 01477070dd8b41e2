#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/scan_info.h"
#include "server/prepare/prepared_mesh.h"
#include "server/session/data_folder.h"
#include "server/session/fair_mutex.h"
#include "server/session/mesh_cache.h"
#include "server/session/quota.h"
#include "server/session/upload.h"
#include "server/session/view_cache.h"

namespace burnish {

struct MeshStoreOptions {
  uint64_t upload_bytes_max = uint64_t{8} << 30;
  uint64_t upload_bytes_per_user = uint64_t{16} << 30;  ///< uploads under way
  uint64_t memory_bytes_max = uint64_t{16} << 30;       ///< meshes, sessions, their clients
  uint64_t view_bytes_max = uint64_t{1} << 30;          ///< views kept for the next client
  int threads = 0;                                      ///< for preparing; 0: all cores
};

/// The library of scans on disk. A scan's folder appears complete, by one rename, or not at all;
/// prepared files can always be rebuilt from the original. Thread-safe.
class MeshStore {
 public:
  /// Needs: `folder` outlives the store.
  MeshStore(const DataFolder& folder, const MeshStoreOptions& options);

  /// Fails: resource_exhausted above upload_bytes_max, and when the user's uploads under way are
  /// above upload_bytes_per_user together.
  Result<std::unique_ptr<Upload>> begin_upload(const ImportHeader& header,
                                               const std::string& user = {});

  /// Reads, checks, prepares and keeps the uploaded file; bytes that are known already only get
  /// the prepared mesh that was asked for, and replace what is damaged of the scan. Fails:
  /// invalid_argument (no good mesh), data_loss (bytes other than announced), resource_exhausted
  /// (disk), cancelled; then nothing is kept.
  Result<ImportOutcome> import(Upload& upload, const ImportHeader& header,
                               const Progress& progress);

  /// The outcome of importing bytes with this hash, if the library has them; not_found if it has
  /// not, or only damaged ones.
  Result<ImportOutcome> import_known(const std::string& id, const PreparedKey& key,
                                     const Progress& progress);

  /// By name, then id. Damaged folders are logged and left out.
  std::vector<ScanInfo> list() const;

  /// By name, id, or the beginning of one id.
  /// Fails: not_found; invalid_argument when several scans answer to it.
  Result<ScanInfo> find(const std::string& reference) const;

  /// Describes the prepared mesh of `depth`, or the deepest there is for 0.
  Result<ScanDescription> describe(const std::string& reference, int depth) const;

  /// Makes the prepared file when it is missing or damaged. Needs: a resolved key.
  Status prepare_scan(const std::string& id, const PreparedKey& key, const Progress& progress);

  /// The mesh for a session: shared with others, else mapped, else prepared now. The caller holds
  /// it for as long as it uses it. Needs: a resolved key.
  /// Fails: resource_exhausted when memory_bytes_max has no room; not_found; cancelled.
  Result<std::shared_ptr<const SharedMesh>> open_mesh(const std::string& id, const PreparedKey& key,
                                                      const Progress& progress);

  /// What a client draws a prepared mesh from, made now or kept from the last time.
  /// triangles_max: 0 for the whole scan. Needs: a resolved key. Fails: failed_precondition when
  /// nobody has prepared that depth; not_found; resource_exhausted; cancelled.
  Result<std::shared_ptr<const PackedView>> open_view(const std::string& id, const PreparedKey& key,
                                                      uint64_t triangles_max,
                                                      const Progress& progress);

  /// The budget of meshes, sessions and their clients together, and what meshes take of it.
  Quota& memory() { return memory_; }
  uint64_t mesh_bytes() const { return cache_.byte_count(); }

  /// Also a damaged one. Needs: no session edits it. Fails: not_found.
  Status remove(const std::string& id);

 private:
  std::filesystem::path scan_folder(const std::string& id) const { return folder_.scans() / id; }
  Result<ImportOutcome> import_new(Upload& upload, const std::string& id,
                                   const ImportHeader& header, const Progress& progress);
  Result<ImportOutcome> prepare_known(const std::string& id, const PreparedKey& key,
                                      const Progress& progress);
  Result<std::shared_ptr<const PreparedMesh>> map_or_rebuild(const std::string& id,
                                                             const PreparedKey& key,
                                                             const Progress& progress);
  Result<std::shared_ptr<const PreparedMesh>> find_prepared(const std::string& id,
                                                            const PreparedKey& key);
  Status rebuild(const std::string& id, const PreparedKey& key, const Progress& progress);

  const DataFolder& folder_;
  const MeshStoreOptions options_;
  MeshCache cache_;
  ViewCache views_;
  Quota memory_;
  Quota uploads_;
  FairMutex preparing_;    // one at a time: it uses all cores and much memory
  FairMutex making_view_;  // one at a time: the next may want the same
};

/// The key with its depth chosen: 0 becomes the scan's default depth.
PreparedKey resolve(const PreparedKey& key, const ScanInfo& scan);

}  // namespace burnish
