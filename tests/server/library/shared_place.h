#pragma once

#include <memory>
#include <string>

#include "server/library/original_store.h"

namespace burnish {

/// Where the servers of a test have their originals, and a look into it past the product.
class SharedPlace {
 public:
  virtual ~SharedPlace() = default;

  /// Opens it for a server.
  virtual std::unique_ptr<OriginalStore> open(const std::string& server) = 0;
  /// Returns its name in messages, and what they must not say.
  virtual std::string name() const = 0;
  virtual std::string place() const = 0;

  /// Return the content of a scan's files; "" if there is none.
  virtual std::string original(const ScanInfo& scan) const = 0;
  virtual std::string info(const ScanInfo& scan) const = 0;
  virtual void put_original(const ScanInfo& scan, const std::string& content) = 0;
  /// Removes all files.
  virtual void clear() = 0;
  /// Return the number of scans' files, and of what is not finished.
  virtual size_t file_count() const = 0;
  virtual size_t unfinished() const = 0;
};

/// `store`: "Folder", "Bucket".
std::unique_ptr<SharedPlace> make_shared_place(const std::string& store);
/// Says what is not installed for it; "" if all is there.
std::string missing_for(const std::string& store);

}  // namespace burnish
