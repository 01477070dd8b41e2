// The part of MeshStore for clients that draw a scan's pictures.

#include <span>

#include <spdlog/spdlog.h>

#include "common/mesh/io/mesh_io.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/pages/directory_codec.h"
#include "server/lease/held_file.h"
#include "server/library/levelled_sheets.h"
#include "server/library/mesh_store.h"
#include "server/library/original_texels.h"
#include "server/library/read_original.h"
#include "server/library/scan_record.h"
#include "server/memory/library_budget.h"
#include "server/prepare/sheets/build_sheets.h"
#include "server/prepare/sheets/unfinished_sheets.h"

namespace burnish {

namespace fs = std::filesystem;

static constexpr size_t kDescribedSheetBlockBytesMax = 64 << 10;

fs::path MeshStore::sheets_path(const std::string& id, uint64_t version) const {
  return scan_folder(id) / sheets_file_name(version);
}

static auto is_of(uint64_t version) {
  return [version](const ScanSheets& sheets) { return sheets.version == version; };
}

Result<std::shared_ptr<const ScanSheets>> MeshStore::open_sheet_file(
    const std::shared_ptr<const ScanPages>& pages, uint64_t version) {
  const uint64_t fingerprint = pages_fingerprint(pages->file.head_bytes());
  const auto open = sheets_.find(pages->scan_id, is_of(version));
  if (open && open->file.head().pages_fingerprint == fingerprint) return open;
  sheets_.forget(pages->scan_id, is_of(version));
  auto file = SheetFile::open(sheets_path(pages->scan_id, version), pages->file.directory().head,
                              fingerprint);
  RETURN_IF_ERROR(file.status());
  const auto sheets = std::make_shared<ScanSheets>(
      ScanSheets{pages->scan_id, version, pages, std::move(file).value(), {}});
  ASSIGN_OR_RETURN(sheets->memory, memory_.take(kServer, sheets->file.byte_count()));
  sheets_.add(sheets);
  return std::shared_ptr<const ScanSheets>(sheets);
}

// Sheets of other pages are of no use either.
static bool is_to_be_made(StatusCode code) {
  return code == StatusCode::kNotFound || code == StatusCode::kDataLoss ||
         code == StatusCode::kUnimplemented || code == StatusCode::kFailedPrecondition;
}

std::optional<bool> MeshStore::may_have_pictures_inside(const std::string& id) {
  if (maybe_with_pictures_.has(id)) return true;
  if (plain_.has(id)) return false;
  const auto scan = read_scan_folder(scan_folder(id));
  if (!scan.is_ok()) return std::nullopt;
  const auto may_have_some =
      may_have_pictures(scan_folder(id) / original_file_name(scan->format), scan->format);
  if (!may_have_some.is_ok()) return std::nullopt;
  (*may_have_some ? maybe_with_pictures_ : plain_).add(id);
  return *may_have_some;
}

bool MeshStore::shows_no_picture(const std::string& id) {
  return without_pictures_.has(id) || !may_have_pictures_inside(id).value_or(true);
}

Result<bool> MeshStore::may_show_pictures(const std::string& id, const Progress& progress) {
  if (without_pictures_.has(id)) return false;
  RETURN_IF_ERROR(bring_here(id, progress));
  return !shows_no_picture(id);  // what cannot be read says why where it is made
}

Result<std::shared_ptr<const ScanSheets>> MeshStore::open_sheets(const std::string& id,
                                                                 const SeamWish& seams,
                                                                 const std::string& user,
                                                                 const Progress& progress) {
  const uint64_t version = seams_version(seams);
  ASSIGN_OR_RETURN(const bool may_have_sheets, may_show_pictures(id, progress));
  if (!may_have_sheets) return std::shared_ptr<const ScanSheets>();
  ASSIGN_OR_RETURN(const auto pages, open_pages(id, progress, user));
  const WishedSheets::Wish wish(wished_sheets_, {id, version});
  auto sheets = open_sheet_file(pages, version);
  if (sheets.is_ok() || !is_to_be_made(sheets.status().code())) return sheets;
  ASSIGN_OR_RETURN(auto turn, wait_to_prepare(id, user, progress));
  sheets = open_sheet_file(pages, version);  // somebody else may have made them meanwhile
  if (sheets.is_ok() || !is_to_be_made(sheets.status().code())) return sheets;
  if (sheets.status().code() != StatusCode::kNotFound)
    spdlog::warn("making sheets again: {}", sheets.status().message());
  if (without_pictures_.has(id)) return std::shared_ptr<const ScanSheets>();
  const Progress for_all = [&](std::string_view phase, double fraction) {
    return report(progress, phase, fraction) || wish.is_shared();  // others wait for these sheets
  };
  ASSIGN_OR_RETURN(const bool is_made, make_sheets(*pages, seams, turn.progress(for_all)));
  if (is_made) return open_sheet_file(pages, version);
  without_pictures_.add(id);
  return std::shared_ptr<const ScanSheets>();
}

/// Levels the seams of a surface, if it is wished. Hears the budget and a cancel.
static Result<std::optional<LevelledSeams>> level(const TexturedSurface& surface,
                                                  const SeamWish& seams, const std::string& name,
                                                  LibraryBudget& budget, const Progress& progress) {
  if (!seams.is_on()) return std::optional<LevelledSeams>();
  if (!seams.free.empty() && seams.free.size() != surface.mesh.vertices.size())
    return changed_original(name, "it has another number of vertices");
  const auto ask = [&, heard = heard_budget(progress, "levelling seams")](uint64_t bytes) {
    const Status goes_on = heard(0);
    return goes_on.is_ok() && bytes > 0 ? budget.ask_for_picture(bytes) : goes_on;
  };
  ASSIGN_OR_RETURN(LevelledSeams levelled, level_seams(surface, seams, ask));
  return std::optional(std::move(levelled));
}

Result<bool> MeshStore::make_sheets(const ScanPages& pages, const SeamWish& seams,
                                    const Progress& progress) {
  const fs::path folder = scan_folder(pages.scan_id);
  ASSIGN_OR_RETURN(const ScanInfo scan, read_scan_folder(folder));
  if (!report(progress, "reading", 0)) return cancelled("making sheets was cancelled");
  RETURN_IF_ERROR(check_or_fetch(scan, progress));
  const fs::path original = folder / original_file_name(scan.format);
  LibraryBudget budget(memory_, folder_.scans());
  RETURN_IF_ERROR(budget.ask_to_read(original, scan.format));
  ASSIGN_OR_RETURN(const uint64_t held_bytes, reading_bytes_max(original, scan.format));
  ASSIGN_OR_RETURN(const HeldFile file, HeldFile::open(original));
  bool is_made = false;
  SheetsReport made;
  const UnfinishedBake::Key key = {pages.scan_id, seams_version(seams)};
  const fs::path path = sheets_path(pages.scan_id, key.second);
  std::unique_ptr<UnfinishedSheets> unfinished = unfinished_bake_.take(key);
  const auto build = [&](const TexturedSurface& surface) -> Status {
    const auto levelled = level(surface, seams, scan.name, budget, progress);
    RETURN_IF_ERROR(levelled.status());
    const LevelledSeams* factors = *levelled ? &**levelled : nullptr;
    const uint64_t bytes = factors != nullptr ? factors->byte_count() : 0;
    const SheetsOptions options = {options_.threads, &budget, budget.space(), held_bytes + bytes,
                                   unfinished.get()};
    const auto built =
        build_sheets({surface, pages.file, scan.name, factors}, path, options, progress, &made);
    if (built.status().code() == StatusCode::kDataLoss)
      drop_damaged_pages(pages.scan_id, built.status());
    RETURN_IF_ERROR(built.status());
    is_made = *built;
    return Status::ok();
  };
  const Status done = read_textured_surface(file.bytes(), scan.format, scan.name, build,
                                            {.budget = reading_budget(budget, progress)});
  if (done.code() == StatusCode::kCancelled)
    unfinished_bake_.keep(key, std::move(unfinished), memory_, folder_.scans());
  RETURN_IF_ERROR(done);
  if (made.lost_triangles > 0)
    spdlog::warn("scan {}: {} triangles of its pages have no picture", scan.name,
                 made.lost_triangles);
  return is_made;
}

void MeshStore::drop_damaged_sheets(const std::string& id, uint64_t version, const Status& damage) {
  spdlog::warn("a sheet file is damaged and goes: {}", damage.message());
  sheets_.forget(id, is_of(version));
  std::error_code ignored;
  fs::remove(sheets_path(id, version), ignored);
}

// The coarsest blocks are the last ones; a client begins with them.
static Result<std::vector<PagePart>> last_sheet_blocks(const SheetFile& file) {
  std::vector<PagePart> blocks;
  size_t bytes = 0;
  for (auto block = static_cast<uint32_t>(file.head().blocks.size()); block-- > 0;) {
    bytes += file.head().blocks[block].bytes;
    if (!blocks.empty() && bytes > kDescribedSheetBlockBytesMax) break;
    ASSIGN_OR_RETURN(std::vector<uint8_t> part, file.read_block_bytes(block));
    blocks.insert(blocks.begin(), {block, std::move(part)});
  }
  return blocks;
}

Result<SheetsDescription> MeshStore::describe_sheets(const std::string& id,
                                                     const Progress& progress,
                                                     const SeamWish& seams,
                                                     const std::string& user) {
  ASSIGN_OR_RETURN(const auto sheets, open_sheets(id, seams, user, progress));
  SheetsDescription description;
  if (sheets == nullptr) return description;
  description.version = sheets->version;
  if (sheets->version != 0) keep_levelled_sheets(scan_folder(id), sheets->version);
  const auto head = sheets->file.head_bytes();
  description.head.assign(head.begin(), head.end());
  auto blocks = last_sheet_blocks(sheets->file);
  if (blocks.status().code() == StatusCode::kDataLoss)
    drop_damaged_sheets(id, sheets->version, blocks.status());
  RETURN_IF_ERROR(blocks.status());
  description.blocks = std::move(blocks).value();
  return description;
}

static Status check_number(const char* what, uint32_t number, size_t count) {
  if (number < count) return Status::ok();
  return invalid_argument(std::string(what) + " " + std::to_string(number) + " is outside 0.." +
                          std::to_string(count - 1));
}

static Status check_sheet(const ScanSheets& sheets, const SheetNumber& sheet, uint32_t pages) {
  RETURN_IF_ERROR(check_number("page", sheet.page, pages));
  const std::string name = "halving of page " + std::to_string(sheet.page) + ":";
  return check_number(name.c_str(), sheet.halving, sheets.file.sheet_entries(sheet.page).size());
}

static Status check_sheets_wish(const ScanSheets& sheets, const SheetsWish& wish) {
  const uint32_t pages = sheets.pages->file.directory().head.page_count();
  for (const uint32_t block : wish.blocks)
    RETURN_IF_ERROR(check_number("block", block, sheets.file.head().blocks.size()));
  for (const uint32_t page : wish.charts) RETURN_IF_ERROR(check_number("page", page, pages));
  uint64_t bytes = 0;
  for (const SheetNumber& sheet : wish.sheets) {
    RETURN_IF_ERROR(check_sheet(sheets, sheet, pages));
    bytes += sheets.file.sheet_entries(sheet.page)[sheet.halving].bytes;
  }
  if (bytes <= kSheetBytesPerFetchMax) return Status::ok();
  return invalid_argument("a request for sheets of " + std::to_string(bytes) +
                          " bytes; the limit is " + std::to_string(kSheetBytesPerFetchMax));
}

static Status read_sheet_parts(const SheetFile& file, const SheetsWish& wish,
                               const MeshStore::SheetTaker& take, const Progress& progress) {
  for (const uint32_t block : wish.blocks) {
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file.read_block_bytes(block));
    take.block({block, std::move(bytes)});
  }
  for (const uint32_t page : wish.charts) {
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file.read_chart_bytes(page));
    take.charts({page, std::move(bytes)});
  }
  for (const SheetNumber& sheet : wish.sheets) {
    if (!report(progress, "reading sheets", 0)) return cancelled("reading sheets was cancelled");
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file.read_sheet_bytes(sheet.page, sheet.halving));
    take.sheet({sheet, std::move(bytes)});
  }
  return Status::ok();
}

Status MeshStore::read_sheets(const std::string& id, const SheetsWish& wish, const SheetTaker& take,
                              const Progress& progress) {
  ASSIGN_OR_RETURN(const auto sheets, find_sheets(id, wish.version));
  RETURN_IF_ERROR(check_sheets_wish(*sheets, wish));
  const Status status = read_sheet_parts(sheets->file, wish, take, progress);
  if (status.code() == StatusCode::kDataLoss) drop_damaged_sheets(id, wish.version, status);
  return status;
}

Result<std::shared_ptr<const ScanSheets>> MeshStore::find_sheets(const std::string& id,
                                                                 uint64_t version) {
  const std::string of_version = version == 0 ? "" : " of version " + std::to_string(version);
  const auto none = failed_precondition("scan " + short_id(id) + " has no sheets" + of_version +
                                        "; call DescribeSheets");
  const auto pages = open_page_file(id);
  if (is_to_be_made(pages.status().code())) return none;
  RETURN_IF_ERROR(pages.status());
  auto sheets = open_sheet_file(*pages, version);
  if (is_to_be_made(sheets.status().code())) return none;
  return sheets;
}

}  // namespace burnish
