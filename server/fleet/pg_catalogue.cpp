#include "server/fleet/pg_catalogue.h"

#include <utility>

#include <spdlog/spdlog.h>

#include "server/library/kept_name.h"
#include "server/library/scan_names.h"
#include "server/library/scan_record.h"

namespace burnish {

static constexpr char kCatalogueApplication[] = "burnish scans";

Result<std::unique_ptr<PgCatalogue>> PgCatalogue::open(const PgAddress& address) {
  ASSIGN_OR_RETURN(PgConnection connection, PgConnection::open(address, {}, kCatalogueApplication));
  return std::unique_ptr<PgCatalogue>(new PgCatalogue(address, std::move(connection)));
}

Status PgCatalogue::connect() {
  if (connection_.is_open()) return Status::ok();
  ASSIGN_OR_RETURN(connection_, PgConnection::open(address_, {}, kCatalogueApplication));
  return Status::ok();
}

Status PgCatalogue::transact(const std::function<Status()>& work) {
  RETURN_IF_ERROR(connect());
  // The database ends the transaction of a server that was stopped in it.
  RETURN_IF_ERROR(
      connection_.script("BEGIN; SET LOCAL lock_timeout = '4s';"
                         "SET LOCAL idle_in_transaction_session_timeout = '30s'"));
  const Status done = work();
  if (done.is_ok()) return connection_.script("COMMIT");
  if (connection_.is_open()) (void)connection_.script("ROLLBACK");
  return done;
}

// The marks of two states differ: a version is used once.
static constexpr char kReadMark[] =
    "SELECT coalesce(md5(string_agg(CAST(version AS text), ' ' ORDER BY version)), '') FROM scans";

Result<std::optional<PgCatalogue::Page>> PgCatalogue::read(const std::string& mark) {
  const std::lock_guard lock(mutex_);
  RETURN_IF_ERROR(connect());
  auto now = connection_.run({kReadMark, {}});
  if (!now.is_ok() && !connection_.is_open()) {  // the database was started again
    RETURN_IF_ERROR(connect());
    now = connection_.run({kReadMark, {}});
  }
  RETURN_IF_ERROR(now.status());
  std::string found = "of " + now->bytes(0, 0);
  if (found == mark) return std::optional<Page>();
  ASSIGN_OR_RETURN(Page page, read_all(std::move(found)));
  return std::optional<Page>(std::move(page));
}

Result<PgCatalogue::Page> PgCatalogue::read_all(std::string mark) {
  ASSIGN_OR_RETURN(const PgReply rows, connection_.run({"SELECT id, info FROM scans", {}}));
  Page page{std::move(mark), {}};
  for (size_t row = 0; row < rows.rows(); ++row) {
    auto scan = scan_from_json(rows.bytes(row, 1));
    if (scan.is_ok() && scan->id != rows.bytes(row, 0)) scan = data_loss("it is another scan's");
    if (scan.is_ok()) {
      page.scans.push_back(std::move(*scan));
    } else {
      spdlog::error("the catalogue's row of scan {} is damaged: {}", rows.bytes(row, 0),
                    scan.status().message());
    }
  }
  return page;
}

// The lock is for servers that enter scans at the same moment; names that look alike share one.
Status PgCatalogue::take_name(const ScanInfo& scan) {
  ASSIGN_OR_RETURN(
      const PgReply lock,
      connection_.run({"SELECT pg_try_advisory_xact_lock(hashtextextended(encode($1, 'hex'), 0))",
                       {look_of_name(scan.name)}}));
  if (lock.integer(0, 0) == 0)
    return already_exists("the name '" + scan.name +
                          "' is being given to another scan; choose another");
  ASSIGN_OR_RETURN(const Page page, read_all({}));
  return check_name_is_free(scan, page.scans);
}

// The second to enter a scan waits at its row, and finds the first one's.
Result<ScanInfo> PgCatalogue::enter(const ScanInfo& scan, const Files& put) {
  const std::lock_guard lock(mutex_);
  std::string info;
  const auto enter_row = [&]() -> Status {
    ASSIGN_OR_RETURN(const PgReply row,
                     connection_.run({"INSERT INTO scans (id, info) VALUES ($1, $2)"
                                      " ON CONFLICT (id) DO UPDATE SET info = scans.info"
                                      " RETURNING info, xmax = 0",
                                      {scan.id, scan_to_json(scan)}}));
    info = row.bytes(0, 0);
    const bool is_new = row.integer(0, 1) != 0;
    if (is_new) RETURN_IF_ERROR(take_name(scan));
    RETURN_IF_ERROR(put());
    return connection_
        .run({"UPDATE sessions SET shared_scan = scan_id WHERE scan_id = $1"
              " AND shared_scan IS NULL",
              {scan.id}})
        .status();
  };
  RETURN_IF_ERROR(transact(enter_row));
  return scan_from_json(info);
}

Result<ScanInfo> PgCatalogue::change(const std::string& id,
                                     const std::function<void(ScanInfo&)>& by) {
  const std::lock_guard lock(mutex_);
  ScanInfo scan;
  const auto change_row = [&]() -> Status {
    ASSIGN_OR_RETURN(
        const PgReply row,
        connection_.run({"SELECT info FROM scans WHERE id = $1 FOR NO KEY UPDATE", {id}}));
    if (row.rows() == 0) return not_found("no scan has the id '" + id + "'");
    ASSIGN_OR_RETURN(scan, scan_from_json(row.bytes(0, 0)));
    const std::string before = scan.name;
    by(scan);
    if (scan.name != before) RETURN_IF_ERROR(take_name(scan));
    return connection_
        .run({"UPDATE scans SET info = $2, version = nextval('scan_versions') WHERE id = $1",
              {id, scan_to_json(scan)}})
        .status();
  };
  RETURN_IF_ERROR(transact(change_row));
  return scan;
}

static Status is_edited_by(PgConnection& database, const std::string& id) {
  ASSIGN_OR_RETURN(const PgReply editing,
                   database.run({"SELECT name FROM sessions WHERE scan_id = $1 LIMIT 1", {id}}));
  if (editing.rows() == 0) return Status::ok();
  return failed_precondition("session " + editing.bytes(0, 0) +
                             " edits the scan; delete the session first");
}

Status PgCatalogue::remove(const std::string& id, const Files& remove_files) {
  const std::lock_guard lock(mutex_);
  return transact([&]() -> Status {
    RETURN_IF_ERROR(is_edited_by(connection_, id));
    const Status removed = connection_.run({"DELETE FROM scans WHERE id = $1", {id}}).status();
    if (removed.code() == StatusCode::kNotFound)  // a session was made at this moment
      return failed_precondition("a session edits the scan; delete the session first");
    RETURN_IF_ERROR(removed);
    return remove_files();
  });
}

}  // namespace burnish
