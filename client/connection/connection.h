#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/connection/scan_source.h"
#include "common/base/progress.h"
#include "common/edit/edit.h"
#include "common/edit/proposed_edges.h"
#include "common/measure/section.h"
#include "common/service/page_values.h"
#include "common/service/scan_pages.h"
#include "common/service/scan_sheets.h"
#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "common/service/surface_measures.h"

namespace burnish {

class ScanBundle;
class ServerRoute;

/// How a client knows its server, and how it shows who it is. Files are PEM.
struct ConnectionTrust {
  bool tls = false;          ///< implied by the files of certificates
  std::filesystem::path ca;  ///< the server's certificate must be of it; empty: the system's
  std::filesystem::path certificate;  ///< of the client, with its key
  std::filesystem::path key;
  std::string token;
  bool insecure = false;  ///< send the token in plain text to other machines too
};

/// A client's connection to one server. Every failure names the server. Calls that answer at once
/// have a deadline; long ones end when the server ends them, when `progress` says so, or when
/// keepalive finds the server gone.
class Connection {
 public:
  /// Fails: unavailable when nobody answers at `server` (HOST:PORT, or unix:PATH as it is)
  /// within `timeout`, or the certificates do not please either side; invalid_argument and as errno
  /// says for wrong files; failed_precondition when a token would travel in plain text.
  static Result<Connection> open(const std::string& server, std::chrono::milliseconds timeout,
                                 const ConnectionTrust& trust = {});
  Connection(Connection&&) noexcept;
  ~Connection();

  const std::string& server() const;

  /// Who edits, where the server cannot know better: the author of edits, and the holder of roles.
  /// Returns the way to the server of the sessions, which all that talk about them share.
  const std::shared_ptr<ServerRoute>& route() const;

  void set_user(std::string user);
  const std::string& user() const;

  /// Starts the server where it does not run. From any thread; ends soon when progress says so.
  using Starter = std::function<Status(const Progress&)>;
  /// For a server that may end at any time and is started on demand. Live sessions call it before
  /// each try to come back.
  void set_starter(Starter starter);
  /// Has the server started again if need be, and waits until it is connected. The next call tells
  /// of a failure. Does nothing without a starter.
  void bring_back(const Progress& progress = {});

  /// Uploads a scan and has it prepared. A name that no scan may have, or that another has, is
  /// changed, or refused if it must be `exact_name`. Fails: as the server says; as reading does;
  /// cancelled.
  Result<ImportOutcome> import_scan(ScanSource& scan, const std::string& name,
                                    const PreparedKey& key, const Progress& progress,
                                    bool exact_name = false);
  Result<ImportOutcome> import_scan(const ScanBundle& scan, const std::string& name,
                                    const PreparedKey& key, const Progress& progress,
                                    bool exact_name = false);
  /// Does the same with a mesh file, or the mesh of a folder, and the files that it names. Fails:
  /// as reading the files does; likewise.
  Result<ImportOutcome> import_scan(const std::filesystem::path& file, const std::string& name,
                                    const PreparedKey& key, const Progress& progress,
                                    bool exact_name = false);
  Result<std::vector<ScanInfo>> list_scans();
  Result<ScanDescription> describe_scan(const std::string& scan, int depth);
  Result<ScanInfo> prepare_scan(const std::string& scan, const PreparedKey& key,
                                const Progress& progress);
  /// Has the scan's pages made where they are missing. Fails: as the server says; cancelled.
  Result<PagesDescription> describe_pages(const std::string& scan, const Progress& progress);
  /// Takers return false to cancel.
  struct PageTaker {
    std::function<bool(PagePart)> block;
    std::function<bool(PagePart)> page;
  };
  /// Fetches blocks, then pages, in the order of the wish. The bytes are not checked.
  /// Needs: at most kPagePartsPerFetchMax parts. Fails: as the server says; cancelled.
  Status fetch_pages(const PagesWish& wish, const PageTaker& take);
  /// Has the server measure the scan's noise. Fails: as the server says; cancelled.
  Result<EdgeProposal> propose_edges(const std::string& scan, const Progress& progress);
  /// Returns the id of what is gone.
  Result<std::string> delete_scan(const std::string& scan);
  /// Returns the scan with its new name, 1 to 200 bytes of UTF-8. Fails: as the server says.
  Result<ScanInfo> rename_scan(const std::string& scan, const std::string& name);

  Result<OpenedSession> open_session(const SessionWish& wish);
  Result<std::vector<SessionInfo>> list_sessions();
  Status close_session(const std::string& session);
  Status delete_session(const std::string& session);
  /// Returns the session with its new name, 1 to 200 bytes of UTF-8. Fails: as the server says.
  Result<SessionInfo> rename_session(const std::string& session, const std::string& name);

  /// Sends the edits in order, in as many requests as they need. Edits sent before a failure stay;
  /// sending all again is harmless.
  Result<ApplyOutcome> apply(const std::string& session, std::span<const Edit> edits);
  /// All of a session's history.
  Result<std::vector<HistoryEntry>> history(const std::string& session);
  Result<ForkedSession> fork_session(const ForkWish& wish);
  Result<SessionPeople> people(const std::string& session);
  Status set_role(const std::string& session, const std::string& user, SessionRole role);

  Result<SessionState> state(const std::string& session);
  /// One value per cell, in the Morton order of the cells.
  Result<std::vector<float>> cells(const std::string& session, CellValue value);

  /// Has the scan's sheets made where they are missing; a scan without pictures has none. With a
  /// session of the scan, asks where it is, and gets its seams levelled as it says; an older server
  /// levels none. Fails: as the server says; unimplemented (an older server); cancelled.
  Result<SheetsDescription> describe_sheets(const std::string& scan, const Progress& progress,
                                            const std::string& session = {});

  struct SheetTaker {
    std::function<bool(PagePart)> block;
    std::function<bool(PagePart)> charts;  ///< the number is the page's
    std::function<bool(SheetPart)> sheet;
  };
  /// Fetches blocks, then charts, then sheets, in the order of the wish: levelled ones from where a
  /// session was found last, which has made them. The bytes are not checked.
  /// Needs: at most kSheetPartsPerFetchMax parts. Fails: as the server says; cancelled.
  Status fetch_sheets(const SheetsWish& wish, const SheetTaker& take);

  /// The value of the cell of each vertex, for pages of the session's scan, in the given order.
  /// Fails: as the server says; data_loss when it sends other pages.
  Result<std::vector<PageValues>> page_values(const std::string& session, CellValue value,
                                              std::span<const PageId> pages);

  /// How far the edits moved the surface as it is now.
  Result<SessionDeviation> deviation(const std::string& session);
  /// Returns the lines in which a plane cuts the surface, before the edits and as it is now.
  Result<Section> section(const SectionWish& wish);
  /// Names the unit of a scan's coordinates. Fails: invalid_argument as check_unit().
  Result<ScanInfo> set_scan_unit(const std::string& scan, const std::string& unit);

  /// Solves on the server and writes the edited mesh to `file`, whole or not at all.
  Result<ExportSummary> export_mesh(const std::string& session, const ExportWish& wish,
                                    const std::filesystem::path& file, const Progress& progress);

 private:
  friend class PageFetcher;
  friend class SessionLink;
  struct State;
  explicit Connection(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
