#include "common/archive/archive.h"

#include <algorithm>
#include <new>
#include <set>

#include <sys/stat.h>

#include "common/archive/directory.h"
#include "common/archive/entry_name.h"
#include "common/archive/zip_handle.h"
#include "common/base/limits.h"

namespace burnish {

/// The archive is released before its source.
struct Archive::Zip {
  ZipSource source;
  ZipHandle archive;
};

namespace {

bool is_of_unix(zip_uint8_t system) {
  return system == ZIP_OPSYS_UNIX || system == ZIP_OPSYS_OS_X;
}

/// Refuses links and devices, which Unix programs put into an entry's attributes.
Status check_kind(zip_uint8_t system, zip_uint32_t attributes) {
  if (!is_of_unix(system)) return Status::ok();
  const mode_t kind = (attributes >> 16) & S_IFMT;
  if (kind == S_IFLNK) return invalid_argument("is a link; only files and folders are taken");
  if (kind == 0 || kind == S_IFREG || kind == S_IFDIR) return Status::ok();
  return invalid_argument("is a device; only files and folders are taken");
}

Status check_description(const zip_stat_t& found) {
  constexpr zip_uint64_t kNeeded =
      ZIP_STAT_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
  if ((found.valid & kNeeded) != kNeeded) return invalid_argument("does not say how long it is");
  if (found.encryption_method != ZIP_EM_NONE)
    return invalid_argument("is encrypted; send an archive without a password");
  return Status::ok();
}

/// The sum of all unpacked entries, held within the limits: a small archive may unpack to a full
/// disk.
class UnpackedSum {
 public:
  explicit UnpackedSum(uint64_t archive_bytes)
      : max_(std::min(
            kArchiveUnpackedBytesMax,
            std::max(kArchiveUnpackedBytesInAnyCase, archive_bytes * kArchiveUnpackedPerByteMax))),
        archive_bytes_(archive_bytes) {}

  Status add(uint64_t bytes) {
    if (bytes <= max_ - sum_) {
      sum_ += bytes;
      return Status::ok();
    }
    return invalid_argument("unpacks to " + std::to_string(bytes) + " bytes, " +
                            std::to_string(sum_) + " come before it; the limit for an archive of " +
                            std::to_string(archive_bytes_) + " bytes is " + std::to_string(max_));
  }

 private:
  const uint64_t max_;
  const uint64_t archive_bytes_;
  uint64_t sum_ = 0;
};

Status ambiguous() {
  return invalid_argument("the archive is damaged: it has two directories");
}

}  // namespace

Archive::Archive() : zip_(std::make_unique<Zip>()) {}
Archive::Archive(Archive&& other) noexcept = default;
Archive& Archive::operator=(Archive&& other) noexcept = default;
Archive::~Archive() = default;

Result<Archive> Archive::open(std::span<const uint8_t> bytes, const std::string& name) {
  Archive archive;
  archive.name_ = name;
  const auto opened = [&]() -> Status {
    if (bytes.empty()) return invalid_argument("the file is empty (0 bytes)");
    ASSIGN_OR_RETURN(archive.zip_->source, source_of(bytes));
    ASSIGN_OR_RETURN(archive.zip_->archive, open_zip(archive.zip_->source, ZIP_RDONLY));
    return archive.list_entries(bytes);
  }();
  RETURN_IF_ERROR(opened.with_context(name));
  return archive;
}

/// libzip reads the entries; the directory here is for what it does not tell. Both must have found
/// the same one.
Status Archive::list_entries(std::span<const uint8_t> bytes) {
  zip_t* zip = zip_->archive.get();
  const auto count = static_cast<uint64_t>(zip_get_num_entries(zip, 0));
  if (count > kArchiveEntriesMax)
    return invalid_argument("the archive has " + std::to_string(count) + " entries, the limit is " +
                            std::to_string(kArchiveEntriesMax));
  ASSIGN_OR_RETURN(const std::vector<DirectoryRecord> records, read_directory(bytes));
  if (records.size() != count) return ambiguous();
  UnpackedSum unpacked(bytes.size());
  std::set<std::string> names;
  for (zip_uint64_t e = 0; e < count; ++e) {
    zip_stat_t found;
    if (zip_stat_index(zip, e, ZIP_FL_ENC_RAW, &found) != 0) return zip_status(zip_get_error(zip));
    const std::string raw_name = (found.valid & ZIP_STAT_NAME) != 0 ? found.name : "";
    zip_uint8_t system = ZIP_OPSYS_DOS;
    zip_uint32_t attributes = 0;
    zip_file_get_external_attributes(zip, e, 0, &system, &attributes);
    const std::string entry = plain_entry_name(raw_name, !is_of_unix(system));
    if (entry != kArchiveRoot) RETURN_IF_ERROR(check_entry_name(entry));
    const std::string what = "entry " + shown_entry(entry);
    RETURN_IF_ERROR(check_description(found).with_context(what));
    RETURN_IF_ERROR(check_kind(system, attributes).with_context(what));
    RETURN_IF_ERROR(unpacked.add(found.size).with_context(what));
    if (!names.insert(entry.ends_with('/') ? entry.substr(0, entry.size() - 1) : entry).second)
      return invalid_argument(what + " is there twice");
    if (records[e].name != raw_name || records[e].bytes != found.size) return ambiguous();
    RETURN_IF_ERROR(check_header(bytes, records[e]).with_context(what));
    entries_.push_back({entry, found.size});
  }
  return Status::ok();
}

std::optional<size_t> Archive::find(std::string_view name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const ArchiveEntry& entry) { return entry.name == name; });
  if (found == entries_.end()) return std::nullopt;
  return static_cast<size_t>(found - entries_.begin());
}

Status Archive::in_entry(size_t entry, const Status& status) const {
  return status.with_context(name_ + ": entry " + shown_entry(entries_[entry].name));
}

Result<std::vector<uint8_t>> Archive::read(size_t entry, const FileBudget& budget) const {
  std::vector<uint8_t> content;
  try {
    RETURN_IF_ERROR(in_entry(entry, unpack(entry, budget, content)));
  } catch (const std::bad_alloc&) {
    return in_entry(entry,
                    resource_exhausted("not enough memory for " +
                                       std::to_string(entries_[entry].size_bytes) + " bytes"));
  }
  return content;
}

/// Grows with the bytes that come, because the announced size may be a lie. libzip compares the sum
/// when it meets the end, so one byte more than announced is asked for.
Status Archive::unpack(size_t entry, const FileBudget& budget,
                       std::vector<uint8_t>& content) const {
  constexpr uint64_t kPieceBytes = uint64_t{1} << 20;
  zip_t* zip = zip_->archive.get();
  zip_stat_t found;
  if (zip_stat_index(zip, entry, 0, &found) != 0) return zip_status(zip_get_error(zip));
  if (found.comp_method != ZIP_CM_STORE && found.comp_method != ZIP_CM_DEFLATE)
    return invalid_argument("is packed by method " + std::to_string(found.comp_method) +
                            "; only stored (0) and deflated (8) entries are read");
  const ZipFile file(zip_fopen_index(zip, entry, 0));
  if (!file) return zip_status(zip_get_error(zip));
  const uint64_t size = entries_[entry].size_bytes;
  for (uint64_t have = 0;;) {
    RETURN_IF_ERROR(hear(budget));
    content.resize(have + std::min(kPieceBytes, size - have + 1));
    const zip_int64_t got = zip_fread(file.get(), content.data() + have, content.size() - have);
    if (got < 0) return zip_status(zip_file_get_error(file.get()));
    have += static_cast<uint64_t>(got);
    if (got > 0 && have <= size) continue;
    content.resize(have);
    if (have == size) return Status::ok();
    return invalid_argument("has " + std::string(have > size ? "more" : "fewer") +
                            " bytes than the " + std::to_string(size) + " that it announces");
  }
}

}  // namespace burnish
