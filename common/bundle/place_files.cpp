#include "common/bundle/place_files.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "common/archive/entry_name.h"
#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"

namespace burnish {

namespace fs = std::filesystem;

/// Returns whether the file is there with these bytes. Fails: already_exists if it is there with
/// others.
static Result<bool> is_there(const fs::path& target, const std::vector<uint8_t>& bytes) {
  std::error_code ignored;
  if (!fs::exists(target, ignored)) return false;
  ASSIGN_OR_RETURN(const MappedFile there, MappedFile::open(target));
  if (std::equal(bytes.begin(), bytes.end(), there.bytes().begin(), there.bytes().end()))
    return true;
  return already_exists(target.string() +
                        " is there with other content, and the mesh names a file "
                        "of its own by that name. Nothing is written: choose another folder, or "
                        "replace the file with --force");
}

static Status check_target(const FilesBeside& from, const FileToPlace& file,
                           const fs::path& folder) {
  RETURN_IF_ERROR(check_entry_name(file.target));
  std::error_code ignored;
  if (!fs::exists(folder / file.target, ignored)) return Status::ok();
  ASSIGN_OR_RETURN(const auto bytes, from.read(file.source));
  return is_there(folder / file.target, bytes).status();
}

static Status place(const FilesBeside& from, const FileToPlace& file, const fs::path& folder) {
  RETURN_IF_ERROR(check_entry_name(file.target));
  const fs::path target = folder / file.target;
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  if (error) return errno_status("cannot make " + target.parent_path().string(), error.value());
  ASSIGN_OR_RETURN(const auto bytes, from.read(file.source));
  const auto there = is_there(target, bytes);
  if (there.is_ok() && *there) return Status::ok();
  return write_file(target, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Status check_places(const FilesBeside& from, std::span<const FileToPlace> files,
                    const fs::path& folder) {
  for (const FileToPlace& file : files) RETURN_IF_ERROR(check_target(from, file, folder));
  return Status::ok();
}

Status place_files(const FilesBeside& from, std::span<const FileToPlace> files,
                   const fs::path& folder, bool replaces) {
  if (!replaces) RETURN_IF_ERROR(check_places(from, files, folder));
  for (const FileToPlace& file : files) RETURN_IF_ERROR(place(from, file, folder));
  return Status::ok();
}

}  // namespace burnish
