#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// A file or a folder in an archive.
struct ArchiveEntry {
  std::string name;         ///< plain_entry_name(), checked; a folder's ends in '/'
  uint64_t size_bytes = 0;  ///< unpacked, as the archive announces it

  bool is_folder() const { return name.ends_with('/'); }
};

/// A ZIP archive in memory, read only. The archive is somebody's upload: open() refuses names that
/// lead elsewhere, links, devices, two entries of one name, encrypted entries, too many entries,
/// and more unpacked bytes than the limits allow. read() refuses an entry that is damaged or longer
/// than announced.
class Archive {
 public:
  /// `name` is for messages. Needs: `bytes` outlive this. Fails: invalid_argument that names the
  /// entry, the value and the limit; resource_exhausted.
  static Result<Archive> open(std::span<const uint8_t> bytes, const std::string& name);

  Archive(Archive&& other) noexcept;
  Archive& operator=(Archive&& other) noexcept;
  ~Archive();

  /// In the archive's order.
  const std::vector<ArchiveEntry>& entries() const { return entries_; }
  const std::string& name() const { return name_; }

  /// Returns the entry of exactly this name.
  std::optional<size_t> find(std::string_view name) const;

  /// Unpacks an entry and checks its sum. Needs: a file of entries(). Fails: invalid_argument
  /// (damaged, a method other than stored and deflated); resource_exhausted; as `budget` does.
  Result<std::vector<uint8_t>> read(size_t entry, const FileBudget& budget = {}) const;

 private:
  struct Zip;  // libzip's objects

  Archive();
  Status list_entries(std::span<const uint8_t> bytes);
  Status in_entry(size_t entry, const Status& status) const;
  Status unpack(size_t entry, const FileBudget& budget, std::vector<uint8_t>& content) const;

  std::unique_ptr<Zip> zip_;
  std::string name_;
  std::vector<ArchiveEntry> entries_;
};

}  // namespace burnish
