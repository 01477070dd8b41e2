// The part of MeshStore for clients that draw pages.

#include <spdlog/spdlog.h>

#include "common/mesh/statistics/heard_statistics.h"
#include "server/library/mesh_store.h"
#include "server/library/original_texels.h"
#include "server/library/read_original.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/prepare/pages/build_pages.h"

namespace burnish {

namespace fs = std::filesystem;

static constexpr size_t kDescribedBlockBytesMax = 64 << 10;

// A scan whose original is lost keeps the pages that it has.
fs::path MeshStore::pages_path(const std::string& id) {
  const fs::path with_pictures = scan_folder(id) / pages_file_name(true);
  std::error_code error;
  if (fs::exists(with_pictures, error) || may_have_pictures_inside(id).value_or(false))
    return with_pictures;
  return scan_folder(id) / pages_file_name();
}

Result<std::shared_ptr<const ScanPages>> MeshStore::open_page_file(const std::string& id) {
  if (auto open = pages_.find(id)) return open;
  auto file = PageFile::open(pages_path(id));
  RETURN_IF_ERROR(file.status());
  const auto pages = std::make_shared<ScanPages>(ScanPages{id, std::move(file).value(), {}});
  ASSIGN_OR_RETURN(pages->memory, memory_.take(kServer, pages->file.byte_count()));
  pages_.add(pages);
  return std::shared_ptr<const ScanPages>(pages);
}

static bool can_be_made_again(StatusCode code) {
  return code == StatusCode::kNotFound || code == StatusCode::kDataLoss ||
         code == StatusCode::kUnimplemented;
}

Result<std::shared_ptr<const ScanPages>> MeshStore::open_pages(const std::string& id,
                                                               const Progress& progress,
                                                               const std::string& user) {
  auto pages = open_page_file(id);
  if (pages.is_ok() || !can_be_made_again(pages.status().code())) return pages;
  RETURN_IF_ERROR(bring_here(id, progress));
  ASSIGN_OR_RETURN(auto turn, wait_to_prepare(id, user, progress));
  pages = open_page_file(id);  // somebody else may have made them meanwhile
  if (pages.is_ok() || !can_be_made_again(pages.status().code())) return pages;
  if (pages.status().code() == StatusCode::kDataLoss)
    spdlog::warn("making pages again: {}", pages.status().message());
  RETURN_IF_ERROR(make_pages(id, turn.progress(progress)));
  return open_page_file(id);
}

Result<std::shared_ptr<const ScanPages>> MeshStore::find_pages(const std::string& id) {
  auto pages = open_page_file(id);
  if (!can_be_made_again(pages.status().code())) return pages;
  return failed_precondition("scan " + short_id(id) + " has no pages; call DescribePages");
}

void MeshStore::drop_damaged_pages(const std::string& id, const Status& damage) {
  spdlog::warn("a page file is damaged and goes: {}", damage.message());
  pages_.forget(id);
  std::error_code ignored;
  fs::remove(pages_path(id), ignored);
}

Result<Page> MeshStore::read_page(const ScanPages& pages, PageId page) {
  auto read = pages.file.read_page(page);
  if (read.status().code() != StatusCode::kDataLoss) return read;
  const auto present = pages_.find(pages.scan_id);  // the pages may have been made again since
  if (!present || present.get() == &pages) drop_damaged_pages(pages.scan_id, read.status());
  return read;
}

static Result<MeshStatistics> statistics_of(const MeshView& mesh, const ScratchSpace& space,
                                            const Progress& progress) try {
  return compute_statistics(mesh, space, {progress, "reading"});
} catch (const WorkCancelled&) {
  return cancelled("making pages was cancelled");
}

Status MeshStore::make_pages(const std::string& id, const Progress& progress) {
  const fs::path folder = scan_folder(id);
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(folder));
  if (!report(progress, "reading", 0)) return cancelled("making pages was cancelled");
  RETURN_IF_ERROR(check_or_fetch(scan, progress));
  LibraryBudget budget(memory_, folder_.scans());
  const fs::path original = folder / original_file_name(scan.format);
  RETURN_IF_ERROR(budget.ask_to_read(original, scan.format));
  ASSIGN_OR_RETURN(const CountedTexels texels,
                   texels_of_original(original, scan.format, scan.name, budget, progress));
  ASSIGN_OR_RETURN(const auto mesh,
                   read_original(original, scan.format, scan.name, budget, progress));
  ASSIGN_OR_RETURN(const MeshStatistics statistics,
                   statistics_of(mesh->view(), budget.space(), progress));
  const fs::path path = pages_path(id);
  RETURN_IF_ERROR(
      build_pages({mesh->vertices, mesh->triangles, mesh->colours, statistics, texels.for_pages()},
                  path, {options_.threads, &budget, budget.space()}, progress));
  std::error_code ignored;
  if (path != folder / pages_file_name()) fs::remove(folder / pages_file_name(), ignored);
  return Status::ok();
}

// The coarsest blocks are the last ones; a client begins with them.
static Result<std::vector<PagePart>> last_blocks(const PageFile& file) {
  std::vector<PagePart> blocks;
  size_t bytes = 0;
  for (uint32_t block = file.directory().head.block_count(); block-- > 0;) {
    bytes += file.directory().head.blocks[block].bytes;
    if (!blocks.empty() && bytes > kDescribedBlockBytesMax) break;
    ASSIGN_OR_RETURN(std::vector<uint8_t> part, file.read_block_bytes(block));
    blocks.insert(blocks.begin(), {block, std::move(part)});
  }
  return blocks;
}

Result<PagesDescription> MeshStore::describe_pages(const std::string& id, const Progress& progress,
                                                   const std::string& user) {
  ASSIGN_OR_RETURN(const auto pages, open_pages(id, progress, user));
  PagesDescription description;
  const auto head = pages->file.head_bytes();
  description.head.assign(head.begin(), head.end());
  ASSIGN_OR_RETURN(description.blocks, last_blocks(pages->file));
  return description;
}

static Status check_numbers(const char* what, std::span<const uint32_t> numbers, uint32_t count) {
  for (const uint32_t number : numbers)
    if (number >= count)
      return invalid_argument(std::string(what) + " " + std::to_string(number) + " is outside 0.." +
                              std::to_string(count - 1));
  return Status::ok();
}

static Status read_parts(const PageFile& file, const PagesWish& wish,
                         const MeshStore::PageTaker& take, const Progress& progress) {
  RETURN_IF_ERROR(check_numbers("block", wish.blocks, file.directory().head.block_count()));
  RETURN_IF_ERROR(check_numbers("page", wish.pages, file.directory().head.page_count()));
  for (const uint32_t block : wish.blocks) {
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file.read_block_bytes(block));
    take.block({block, std::move(bytes)});
  }
  for (const uint32_t page : wish.pages) {
    if (!report(progress, "reading pages", 0)) return cancelled("reading pages was cancelled");
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file.read_page_bytes(page));
    take.page({page, std::move(bytes)});
  }
  return Status::ok();
}

Status MeshStore::read_pages(const std::string& id, const PagesWish& wish, const PageTaker& take,
                             const Progress& progress) {
  ASSIGN_OR_RETURN(const auto pages, find_pages(id));
  const Status status = read_parts(pages->file, wish, take, progress);
  if (status.code() == StatusCode::kDataLoss) drop_damaged_pages(id, status);
  return status;
}

}  // namespace burnish
