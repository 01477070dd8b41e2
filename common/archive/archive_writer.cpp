#include "common/archive/archive_writer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "common/archive/entry_name.h"
#include "common/archive/rewritten_bytes.h"
#include "common/archive/zip_handle.h"

namespace burnish {

namespace {

constexpr int kFastDeflate = 1;  // the upload is shorter, and packing does not hold it up
constexpr zip_uint16_t kMidnight = 0;
constexpr zip_uint16_t kFirstDay = 0x21;  // 1980-01-01, the earliest day of the format

Status failure_of(const ZipHandle& archive) {
  return zip_status(zip_get_error(archive.get()));
}

Status add_file(const ZipHandle& archive, const FileToPack& file) {
  RETURN_IF_ERROR(check_entry_name(file.name));
  ASSIGN_OR_RETURN(ZipSource source, source_of(file.bytes));
  const zip_int64_t added =
      zip_file_add(archive.get(), file.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
  if (added < 0) return failure_of(archive).with_context("entry " + shown_entry(file.name));
  (void)source.release();  // the archive's now
  const auto entry = static_cast<zip_uint64_t>(added);
  const auto method = is_compressed_by_name(file.name) ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
  zip_set_file_compression(archive.get(), entry, method, kFastDeflate);
  zip_file_set_dostime(archive.get(), entry, kMidnight, kFirstDay, 0);
  return Status::ok();
}

/// Writes the archive, and ends it. libzip asks whether to go on after each piece that it packs.
Status close_zip(ZipHandle archive, const FileBudget& budget) {
  const auto is_cancelled = [](zip_t*, void* asked) {
    return hear(*static_cast<const FileBudget*>(asked)).is_ok() ? 0 : 1;
  };
  zip_register_cancel_callback_with_state(archive.get(), is_cancelled, nullptr,
                                          const_cast<FileBudget*>(&budget));
  if (zip_close(archive.get()) != 0) return failure_of(archive);
  (void)archive.release();  // closed
  return Status::ok();
}

}  // namespace

bool is_compressed_by_name(std::string_view name) {
  constexpr std::array<std::string_view, 10> kExtensions = {
      ".png", ".jpg", ".jpeg", ".webp", ".gif", ".jp2", ".ktx2", ".glb", ".zip", ".drc"};
  const size_t dot = std::min(name.rfind('.'), name.size());
  std::string extension(name.substr(dot));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

Result<std::vector<uint8_t>> pack_archive(std::span<const FileToPack> files,
                                          const FileBudget& budget) {
  RewrittenBytes bytes({});
  ASSIGN_OR_RETURN(const ZipSource source, bytes.source());
  ASSIGN_OR_RETURN(ZipHandle archive, open_zip(source, ZIP_CREATE | ZIP_TRUNCATE));
  for (const FileToPack& file : files) RETURN_IF_ERROR(add_file(archive, file));
  RETURN_IF_ERROR(close_zip(std::move(archive), budget));
  return bytes.take();
}

static Status replace(const ZipHandle& zip, const ChangedEntry& changed) {
  const zip_uint64_t entry = changed.entry;
  zip_stat_t before;
  if (zip_stat_index(zip.get(), entry, 0, &before) != 0) return failure_of(zip);
  ASSIGN_OR_RETURN(ZipSource content, source_of(changed.bytes));
  if (zip_file_replace(zip.get(), entry, content.get(), 0) != 0) return failure_of(zip);
  (void)content.release();  // the archive's now
  // libzip drops the level where the method stays by name; its default is to deflate.
  const auto method = before.comp_method == ZIP_CM_STORE ? ZIP_CM_STORE : ZIP_CM_DEFAULT;
  zip_set_file_compression(zip.get(), entry, method, kFastDeflate);
  zip_file_set_mtime(zip.get(), entry, before.mtime, 0);
  return Status::ok();
}

Result<std::vector<uint8_t>> replace_entries(std::span<const uint8_t> archive,
                                             std::span<const ChangedEntry> changed,
                                             const FileBudget& budget) {
  RewrittenBytes bytes(archive);
  ASSIGN_OR_RETURN(const ZipSource source, bytes.source());
  ASSIGN_OR_RETURN(ZipHandle zip, open_zip(source, 0));
  for (const ChangedEntry& each : changed) RETURN_IF_ERROR(replace(zip, each));
  RETURN_IF_ERROR(close_zip(std::move(zip), budget));
  return bytes.take();
}

}  // namespace burnish
