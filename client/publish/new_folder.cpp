#include "client/publish/new_folder.h"

#include <string>
#include <unistd.h>
#include <utility>

#include "common/base/atomic_file.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

fs::path hidden_beside(const fs::path& target, const char* what) {
  return target.parent_path() /
         ("." + target.filename().string() + ".burnish-" + what + "-" + std::to_string(::getpid()));
}

Status check_target(const fs::path& target, const NewFolder::Guard& may_replace) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(target, error))) return Status::ok();
  if (!fs::is_directory(target, error))
    return already_exists(target.string() + " is there and is no folder");
  if (fs::is_empty(target, error)) return Status::ok();
  const std::string objection = may_replace(target);
  return objection.empty() ? Status::ok() : already_exists(objection);
}

Status rename_to(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error) return Status::ok();
  return errno_status("cannot move " + from.string() + " to " + to.string(), error.value());
}

/// Returns the target without a link and without a '/' at its end.
fs::path plain(const fs::path& target) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(target, error), error);
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

NewFolder::NewFolder(fs::path target, fs::path path)
    : target_(std::move(target)), path_(std::move(path)) {}

NewFolder::NewFolder(NewFolder&& other) noexcept
    : target_(std::move(other.target_)), path_(std::exchange(other.path_, {})) {}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Result<NewFolder> NewFolder::create(const fs::path& target, const Guard& may_replace) {
  const fs::path whole = plain(target);
  RETURN_IF_ERROR(check_target(whole, may_replace));
  const fs::path path = hidden_beside(whole, "new");
  std::error_code error;
  if (!fs::create_directory(path, error) && !error)
    error = std::make_error_code(std::errc::file_exists);
  if (error)
    return errno_status("cannot make a folder in " + whole.parent_path().string(), error.value());
  return NewFolder(whole, path);
}

Status NewFolder::commit() {
  RETURN_IF_ERROR(sync_folder(path_));
  std::error_code error;
  const fs::path old = hidden_beside(target_, "old");
  const bool is_replaced = fs::exists(target_, error);
  if (is_replaced) RETURN_IF_ERROR(rename_to(target_, old));
  const Status moved = rename_to(path_, target_);
  if (!moved.is_ok()) {
    if (is_replaced) fs::rename(old, target_, error);
    return moved;
  }
  path_.clear();
  if (is_replaced) fs::remove_all(old, error);
  return sync_folder(target_.parent_path());
}

}  // namespace burnish
