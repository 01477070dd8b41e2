#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/edit/proposed_edges.h"
#include "common/mesh/rewrite/moved/seam_wish.h"
#include "common/mesh/rewrite/rewrite.h"
#include "common/service/scan_info.h"
#include "common/service/scan_pages.h"
#include "common/service/scan_sheets.h"
#include "server/library/data_folder.h"
#include "server/library/known_proposals.h"
#include "server/library/known_scans.h"
#include "server/library/mesh_cache.h"
#include "server/library/open_pages.h"
#include "server/library/original_store.h"
#include "server/library/preparing_line.h"
#include "server/library/scan_catalogue.h"
#include "server/library/scan_index.h"
#include "server/library/scan_names.h"
#include "server/library/shared_wishes.h"
#include "server/library/staging_folder.h"
#include "server/library/unfinished_bake.h"
#include "server/library/upload.h"
#include "server/memory/quota.h"
#include "server/prepare/prepared_mesh.h"
#include "server/scheduling/executor.h"
#include "server/scheduling/fair_mutex.h"

namespace burnish {

struct MeshStoreOptions {
  uint64_t upload_bytes_max = uint64_t{8} << 30;
  uint64_t upload_bytes_per_user = uint64_t{16} << 30;  ///< uploads that are not finished
  uint64_t memory_bytes_max = uint64_t{16} << 30;       ///< meshes, sessions, their clients
  uint64_t device_memory_bytes_max = 0;                 ///< of a device; 0: sessions take none
  int threads = 0;                                      ///< for preparing; 0: all cores
};

/// The scans that all servers of a fleet have.
struct SharedLibrary {
  std::unique_ptr<OriginalStore> originals;
  std::unique_ptr<ScanCatalogue> catalogue;
};

/// The library of scans on disk. A scan's folder appears complete, by one rename, or not at all.
/// Prepared files can always be rebuilt from the original. With a shared library it lists the scans
/// of all servers, and fetches an original when it is needed for the first time. A call
/// that prepares a scan waits in line with other users, in the place of its `user`. Thread-safe.
class MeshStore {
 public:
  /// Reads the library. Needs: `folder` outlives the store. Fails: as errno says.
  static Result<std::unique_ptr<MeshStore>> open(const DataFolder& folder,
                                                 const MeshStoreOptions& options);
  ~MeshStore();

  /// From now on shares the scans with other servers: gives them those that this server alone has.
  /// Needs: one call, before others. Fails: unavailable; as OriginalStore and ScanCatalogue say.
  Status share(SharedLibrary shared);
  bool is_shared() const { return shared_.has_value(); }

  /// Takes in which scans other servers have imported, changed and deleted. Does nothing without a
  /// shared library. Fails: unavailable.
  Status refresh();
  /// Does the same unless a scan is being shared or removed, which may wait for a slow store.
  Status refresh_unless_busy();

  /// Fails: resource_exhausted above upload_bytes_max, or if the user's unfinished uploads together
  /// are above upload_bytes_per_user.
  Result<std::unique_ptr<Upload>> begin_upload(const ImportHeader& header,
                                               const std::string& user = {});

  /// Checks before an upload whether a scan that is not there may have this name. Fails:
  /// invalid_argument, already_exists.
  Status check_new_name(const ImportHeader& header);

  /// Reads, checks, prepares and keeps the uploaded file. Known bytes only get the requested
  /// prepared mesh, and replace damaged files of the scan. Fails: invalid_argument (not a valid
  /// mesh, or not a name), already_exists (another scan's name), data_loss (not the announced
  /// bytes), resource_exhausted (disk), cancelled; then nothing is kept.
  Result<ImportOutcome> import(Upload& upload, const ImportHeader& header, const Progress& progress,
                               const std::string& user = {});

  /// Returns the outcome of importing bytes with this hash, if the library has them. Fails:
  /// not_found if they are missing or damaged.
  Result<ImportOutcome> import_known(const std::string& id, const PreparedKey& key,
                                     const Progress& progress, const std::string& user = {});

  /// Returns the scans by name, then id, from memory. Damaged folders were logged at the start and
  /// left out.
  std::vector<ScanInfo> list() const { return index_.list(); }

  /// Finds a scan by name, id, or the beginning of one id, from memory; asks the other servers if
  /// it is not there. Fails: not_found; invalid_argument if several scans match.
  Result<ScanInfo> find(const std::string& reference);

  /// Returns the name of the scan with this id, from memory; the id for an unknown one.
  std::string name_of(const std::string& id) const;

  /// Returns the imported file of a scan, checked against its hash. Fails: not_found; data_loss if
  /// the file is damaged.
  Result<OriginalFile> find_original(const std::string& id, const Progress& progress);

  /// Describes the prepared mesh of `depth`; 0 means the deepest one.
  Result<ScanDescription> describe(const std::string& reference, int depth);

  /// Makes the prepared file if it is missing or its header is damaged. Needs: a resolved key.
  /// Fails: resource_exhausted if memory_bytes_max or the disk has no room for it, before anything
  /// is taken; the message names the deepest depth that fits. not_found; cancelled.
  Status prepare_scan(const std::string& id, const PreparedKey& key, const Progress& progress,
                      const std::string& user = {});

  /// Returns the mesh for a session: shared with others, else read, else prepared now. The caller
  /// holds it while using it. Needs: a resolved key. Fails: resource_exhausted if memory_bytes_max
  /// or the disk has no room, or an allocation fails; not_found; cancelled. Then nothing is held.
  Result<std::shared_ptr<const SharedMesh>> open_mesh(const std::string& id, const PreparedKey& key,
                                                      const Progress& progress,
                                                      const std::string& user = {});

  /// Writes the hierarchy of an open mesh beside its prepared file, unless it is there: the next
  /// opening reads it. A thread of low priority does so while somebody else holds the mesh, and
  /// nobody waits for it. If it cannot, it says why in the log. The future is ready when the work
  /// is done, or needless.
  std::future<void> keep_hierarchy(const std::string& id, const PreparedKey& key,
                                   std::shared_ptr<const SharedMesh> mesh);

  /// Describes a scan's pages. Makes missing and damaged ones now.
  /// Fails: resource_exhausted when the memory or the disk has no room; not_found; cancelled.
  Result<PagesDescription> describe_pages(const std::string& id, const Progress& progress,
                                          const std::string& user = {});

  /// Reads blocks and pages in the order of the wish, and hands them over one by one.
  /// Fails: invalid_argument naming a block or page that the scan does not have;
  /// failed_precondition when the scan has no pages; data_loss when they are damaged: the next
  /// describe_pages() makes them again; cancelled.
  struct PageTaker {
    std::function<void(const PagePart&)> block;
    std::function<void(const PagePart&)> page;
  };
  Status read_pages(const std::string& id, const PagesWish& wish, const PageTaker& take,
                    const Progress& progress);

  /// Describes a scan's sheets, with their seams levelled if it is wished. Makes missing and
  /// damaged ones now, and the pages before. The head is empty if the scan shows no picture. Keeps
  /// levelled sheets of the last kLevelledSheetsMax wishes. A call that is cancelled makes them to
  /// their end if another call waits for them. Fails: as describe_pages(); data_loss (damaged
  /// pages, which are made again with the next call).
  Result<SheetsDescription> describe_sheets(const std::string& id, const Progress& progress,
                                            const SeamWish& seams = {},
                                            const std::string& user = {});

  /// Returns whether a scan is known to show no picture: its original is here, and its directory
  /// names none. Reads the directory once.
  bool shows_no_picture(const std::string& id);

  /// Reads blocks, charts and sheets in the order of the wish, and hands them over one by one.
  /// Fails: invalid_argument naming a part that the scan does not have; failed_precondition when
  /// the scan has no sheets of this version; data_loss when they are damaged: the next
  /// describe_sheets() makes them again; cancelled.
  struct SheetTaker {
    std::function<void(const PagePart&)> block;
    std::function<void(const PagePart&)> charts;
    std::function<void(const SheetPart&)> sheet;
  };
  Status read_sheets(const std::string& id, const SheetsWish& wish, const SheetTaker& take,
                     const Progress& progress);

  /// Opens a scan's page file. Makes a missing or damaged one now. Fails: as describe_pages().
  Result<std::shared_ptr<const ScanPages>> open_pages(const std::string& id,
                                                      const Progress& progress,
                                                      const std::string& user = {});
  /// Opens it as it is. Fails: failed_precondition when the scan has no pages.
  Result<std::shared_ptr<const ScanPages>> find_pages(const std::string& id);
  /// Reads and decodes a page. Needs: a page of the scan. Fails: data_loss when it is damaged: the
  /// next open_pages() makes all pages again.
  Result<Page> read_page(const ScanPages& pages, PageId page);

  /// Measures a scan's noise, and proposes how to keep its edges. Remembers the answer: only the
  /// first call of a scan reads it. One scan at a time. Fails: resource_exhausted if
  /// memory_bytes_max or the disk has no room; not_found; data_loss as find_original(); cancelled.
  Result<EdgeProposal> propose_edges(const std::string& id, const Progress& progress);

  /// Sets a function that says whether somebody may soon want a prepared mesh again. At most
  /// kPreparedPerScanMax of the others are kept per scan. Null: nobody wants any. Needs: it
  /// outlives the calls.
  using IsWanted = std::function<bool(const std::string& id, const PreparedKey& key)>;
  void set_wanted(IsWanted is_wanted);

  /// The budget of meshes, sessions and their clients together, and the meshes' part of it.
  Quota& memory() { return memory_; }
  uint64_t mesh_bytes() const { return cache_.byte_count(); }

  /// Gives a scan another name. Fails: as find(); invalid_argument (not a name); already_exists
  /// (another scan's name); as errno says.
  Result<ScanInfo> rename(const std::string& reference, const std::string& name);
  /// Names the unit of a scan's coordinates. Fails: likewise.
  Result<ScanInfo> set_unit(const std::string& reference, const std::string& unit);

  /// Also removes a damaged scan. Needs: no session of this server edits it. Fails: not_found;
  /// failed_precondition that names a session of another server.
  Status remove(const std::string& id);

 private:
  MeshStore(const DataFolder& folder, const MeshStoreOptions& options);

  /// Changes a scan's record, in memory and on disk.
  Result<ScanInfo> change(const std::string& reference, const std::function<void(ScanInfo&)>& by);
  std::filesystem::path scan_folder(const std::string& id) const { return folder_.scans() / id; }
  bool is_here(const std::string& id) const;
  Status bring_here(const std::string& id, const Progress& progress);
  Status put_here(const StagingFolder& staging, const ScanInfo& scan);
  Status put_shared_here(const StagingFolder& staging, const ScanInfo& scan);
  Status take_fetched(const StagingFolder& staging, const ScanInfo& scan);
  Status repair_shared(const std::string& id, const Progress& progress);
  Status take_upload(Upload& upload, const std::string& id, const Progress& progress);
  Status check_or_fetch(const ScanInfo& scan, const Progress& progress);
  Status put_new(const StagingFolder& staging, const ScanInfo& scan, const ImportHeader& header,
                 const Progress& progress);
  Result<ScanInfo> enter_new(ScanInfo scan, const std::string& wanted, bool exact,
                             const ScanCatalogue::Files& put);
  Status read_catalogue();
  Status share_own(const ScanInfo& scan);
  void take_info(const ScanInfo& scan);
  void drop_here(const std::string& id);
  std::filesystem::path prepared_path(const std::string& id, const PreparedKey& key) const;
  std::filesystem::path hierarchy_path(const std::string& id, const PreparedKey& key) const;
  Result<ImportOutcome> import_new(Upload& upload, const std::string& id,
                                   const ImportHeader& header, const Progress& progress);
  Result<ImportOutcome> prepare_known(const std::string& id, const PreparedKey& key,
                                      const std::string& user, const Progress& progress);
  Status read_again(const std::string& id);
  Result<PreparingLine::Turn> wait_to_prepare(const std::string& id, const std::string& user,
                                              const Progress& progress);
  bool is_prepared_in_a_moment(const std::filesystem::path& original, MeshFormat format) const;
  Status make_prepared(const std::string& id, const PreparedKey& key, const Progress& progress);
  Status rebuild(const std::string& id, const PreparedKey& key, const Progress& progress);
  Status make_room(const std::string& id, const PreparedKey& key);
  bool is_in_use(const std::string& id, const PreparedKey& key);
  Status hold_or_copy(const std::filesystem::path& path, const PreparedSummary& summary,
                      SharedMesh& mesh);
  Result<std::shared_ptr<SharedMesh>> read_charged(const std::string& id, const PreparedKey& key);
  Result<std::shared_ptr<SharedMesh>> read_kept(const std::string& id, const PreparedKey& key,
                                                const Progress& progress);
  Result<std::shared_ptr<SharedMesh>> read_with_hierarchy(const std::string& id,
                                                          const PreparedKey& key,
                                                          const std::string& user,
                                                          const Progress& progress);

  Status find_hierarchy(const std::string& id, const PreparedKey& key, SharedMesh& mesh,
                        const Progress& progress);
  Status read_kept_hierarchy(const std::string& id, const PreparedKey& key, SharedMesh& mesh,
                             const Progress& progress);
  Status plan(const std::string& id, SharedMesh& mesh, const Progress& progress);
  Status write_kept_hierarchy(const std::string& id, const PreparedKey& key,
                              const std::shared_ptr<const SharedMesh>& mesh);

  /// Returns what the directory of a scan's original says, which is read once; nothing if it cannot
  /// be read.
  std::optional<bool> may_have_pictures_inside(const std::string& id);
  std::filesystem::path pages_path(const std::string& id);
  Status make_pages(const std::string& id, const Progress& progress);
  Result<std::shared_ptr<const ScanPages>> open_page_file(const std::string& id);
  std::filesystem::path sheets_path(const std::string& id, uint64_t version) const;
  Result<bool> may_show_pictures(const std::string& id, const Progress& progress);
  Result<bool> make_sheets(const ScanPages& pages, const SeamWish& seams, const Progress& progress);
  Result<std::shared_ptr<const ScanSheets>> open_sheet_file(
      const std::shared_ptr<const ScanPages>& pages, uint64_t version);
  Result<std::shared_ptr<const ScanSheets>> open_sheets(const std::string& id,
                                                        const SeamWish& seams,
                                                        const std::string& user,
                                                        const Progress& progress);
  Result<std::shared_ptr<const ScanSheets>> find_sheets(const std::string& id, uint64_t version);
  void drop_damaged_sheets(const std::string& id, uint64_t version, const Status& damage);

  Result<EdgeProposal> measure_noise(const std::string& id, const Progress& progress);
  void drop_damaged_pages(const std::string& id, const Status& damage);

  const DataFolder& folder_;
  const MeshStoreOptions options_;
  ScanIndex index_;
  ScanNames names_{index_};
  std::optional<SharedLibrary> shared_;
  std::mutex sharing_mutex_;  // the catalogue and this folder change together
  std::string mark_;          // of the catalogue, when it was last read; under that mutex
  FairMutex fetching_;
  std::mutex folders_mutex_;  // a folder must not disappear between being read and being listed
  Quota memory_;
  Quota uploads_;
  MeshCache cache_;
  OpenPages pages_;
  OpenSheets sheets_;
  using WishedSheets = SharedWishes<std::pair<std::string, uint64_t>>;  // of a scan and a version
  WishedSheets wished_sheets_;
  UnfinishedBake unfinished_bake_;
  KnownScans without_pictures_, maybe_with_pictures_, plain_;
  std::mutex wanted_mutex_;
  IsWanted is_wanted_;
  PreparingLine preparing_;
  KnownProposals proposals_;
  FairMutex measuring_;  // likewise, beside what prepares
  std::atomic<bool> is_ending_ = false;
  Executor keeping_{1};  // last member: its thread ends before the others are destroyed
};

/// Returns the key with its depth chosen: 0 becomes the scan's default depth.
PreparedKey resolve(const PreparedKey& key, const ScanInfo& scan);

}  // namespace burnish
