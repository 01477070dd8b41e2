#pragma once

#include <memory>
#include <mutex>

#include "server/library/scan_catalogue.h"
#include "server/postgres/pg_connection.h"

namespace burnish {

/// The catalogue in the fleet's database. A scan's row is locked while its files change, and a
/// session's row refers to its scan's. A name is locked while it is given.
class PgCatalogue final : public ScanCatalogue {
 public:
  /// Needs: the tables of the journal. Fails: unavailable.
  static Result<std::unique_ptr<PgCatalogue>> open(const PgAddress& address);

  Result<std::optional<Page>> read(const std::string& mark) override;
  Result<ScanInfo> enter(const ScanInfo& scan, const Files& put) override;
  Result<ScanInfo> change(const std::string& id, const std::function<void(ScanInfo&)>& by) override;
  Status remove(const std::string& id, const Files& remove_files) override;

 private:
  PgCatalogue(const PgAddress& address, PgConnection connection)
      : address_(address), connection_(std::move(connection)) {}

  Status connect();
  /// Runs `work` in a transaction, which ends without a change if it fails.
  Status transact(const std::function<Status()>& work);
  Result<Page> read_all(std::string mark);
  /// Holds the scan's name for it until the transaction ends. Fails: already_exists.
  Status take_name(const ScanInfo& scan);

  const PgAddress address_;
  std::mutex mutex_;
  PgConnection connection_;  // under the mutex
};

}  // namespace burnish
