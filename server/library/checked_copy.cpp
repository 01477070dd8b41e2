#include "server/library/checked_copy.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

#include "common/transfer/content_hash.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

constexpr size_t kPieceBytes = 4 << 20;

/// A file that is closed with this object.
class OpenFile {
 public:
  explicit OpenFile(int file) : file_(file) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }

  int number() const { return file_; }

  /// Puts it on disk. A network's file system tells a full disk as late as here.
  bool close() { return ::fsync(file_) == 0 && ::close(std::exchange(file_, -1)) == 0; }

 private:
  int file_;
};

/// Hands the file over in pieces.
Status read_pieces(const fs::path& path, const Progress& progress, const TakePiece& take) {
  const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) return errno_status("cannot read " + path.string(), errno);
  std::error_code error;
  const auto size = static_cast<double>(fs::file_size(path, error));
  std::vector<char> piece(kPieceBytes);
  for (double done = 0;;) {
    const ssize_t bytes = ::read(file.number(), piece.data(), piece.size());
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) return errno_status("cannot read " + path.string(), errno);
    if (bytes == 0) return Status::ok();
    RETURN_IF_ERROR(take({piece.data(), static_cast<size_t>(bytes)}));
    done += static_cast<double>(bytes);
    if (!report(progress, "fetching", error ? 0 : done / size))
      return cancelled("fetching the scan was cancelled");
  }
}

Status write_all(int file, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno_status("cannot write " + path.string(), errno);
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return Status::ok();
}

/// Makes a file of what `fill` writes.
Status make_file(const fs::path& path, const std::function<Status(int)>& fill) {
  OpenFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (file.number() < 0) return errno_status("cannot write " + path.string(), errno);
  RETURN_IF_ERROR(fill(file.number()));
  return file.close() ? Status::ok() : errno_status("cannot write " + path.string(), errno);
}

Status compare(ContentHash& hash, const std::string& sha256, const std::string& name) {
  const std::string found = hash.finish();
  if (found == sha256) return Status::ok();
  return data_loss(name + " has SHA-256 " + found + ", not " + sha256);
}

}  // namespace

Status write_checked(const std::string& name, const std::string& sha256, const fs::path& to,
                     const Pieces& from) {
  ContentHash hash;
  RETURN_IF_ERROR(make_file(to, [&](int file) {
    return from([&](std::string_view piece) {
      hash.update(piece);
      return write_all(file, piece, to);
    });
  }));
  return compare(hash, sha256, name);
}

Status check_pieces(const std::string& name, const std::string& sha256, const Pieces& from) {
  ContentHash hash;
  RETURN_IF_ERROR(from([&](std::string_view piece) {
    hash.update(piece);
    return Status::ok();
  }));
  return compare(hash, sha256, name);
}

Status copy_checked(const fs::path& from, const std::string& sha256, const fs::path& to,
                    const Progress& progress) {
  return write_checked(from.string(), sha256, to,
                       [&](const TakePiece& take) { return read_pieces(from, progress, take); });
}

Status check_file(const fs::path& path, const std::string& sha256, const Progress& progress) {
  return check_pieces(path.string(), sha256,
                      [&](const TakePiece& take) { return read_pieces(path, progress, take); });
}

Status write_new_file(const fs::path& path, std::string_view text) {
  return make_file(path, [&](int file) { return write_all(file, text, path); });
}

}  // namespace burnish
