#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/model/documents/document.h"
#include "client/model/local_server/private_server.h"
#include "client/model/settings/preferences.h"
#include "client/model/tasks/activity.h"
#include "client/model/tasks/message_log.h"
#include "client/model/tasks/tasks.h"
#include "client/model/view/raw_scan.h"
#include "client/model/view/view_state.h"
#include "client/model/view/viewport.h"
#include "client/model/workspace/strength_strip.h"
#include "client/model/workspace/unsaved.h"

namespace burnish {

struct WorkspaceOptions {
  std::filesystem::path preferences;  ///< file; empty: nothing is kept
  PrivateServerOptions private_server;
  ConnectionTrust trust;
  std::chrono::milliseconds timeout{10'000};
  PageBudget budget;                             ///< of pictures
  bool is_software = false;                      ///< pictures are drawn without a graphics card
  bool shows_raw = false;                        ///< a file is shown before it is imported
  std::filesystem::path pages;                   ///< folder that keeps fetched pages; empty: none
  std::function<void()> wake = [] {};            ///< called from any thread when update() has work
  Clock clock = std::chrono::steady_clock::now;  ///< used by the server link
};

/// A server's state on the start page.
struct Library {
  enum class State { kUnconnected, kConnecting, kConnected, kFailed };
  State state = State::kUnconnected;
  std::string server;  ///< address; "this computer" is the private one
  bool is_private = false;
  std::string problem;        ///< the reason of kFailed
  bool refuses_user = false;  ///< kFailed, for the server wants a token or another user
  std::vector<ScanInfo> scans;
  std::vector<SessionInfo> sessions;
};

/// The session in which a scan opens.
enum class Opening {
  kGoOn,  ///< where its editing goes on; a new session if there is none
  kAnew,  ///< a new session
};

/// A session that is being opened.
struct Coming {
  Coming(std::shared_ptr<Connection> server, SessionWish wanted, std::shared_ptr<Activity> work)
      : connection(std::move(server)), wish(std::move(wanted)), activity(std::move(work)) {}

  const std::shared_ptr<Connection> connection;
  const SessionWish wish;
  const std::shared_ptr<Activity> activity;
  std::atomic<bool> is_over{false};  ///< it is open, or it failed
};

/// Everything that the window shows and a script can do, without the drawing. No call waits for the
/// network; update() handles the results, once per picture, and in between without `draws`. Used
/// from one thread.
class Workspace {
 public:
  Workspace(PageRenderer& renderer, Preferences preferences, WorkspaceOptions options);

  Preferences preferences;
  MessageLog log;
  Recorder recorder;
  Viewport viewport;
  StrengthStrip strip;   ///< of the open session
  bool has_pen = false;  ///< a pen has drawn in this window

  /// Handles all news since the last picture.
  void update(bool draws = true);
  /// A picture took so long, from its look() until the card had drawn it.
  /// `surface_ms`: of that, for the surface, where panels take as long as it does.
  void on_picture(double ms, std::optional<double> surface_ms = {});
  /// Brings what the viewport's picture needs to the renderer. Fails: as the renderer does.
  Status look();

  // The start page.
  const Library& library() const { return library_; }
  /// Without a port it is the usual one, 7411.
  void connect(const std::string& server);
  void connect(const KnownServer& server);
  void connect_privately();
  void refresh_library();
  /// Imports a file, and opens it if no session is open at the end. Uses this computer if no server
  /// was chosen.
  void import_scan(const std::filesystem::path& file, Opening opening = Opening::kGoOn);
  /// Imports a file, and opens it in the place of the open session, unless edits of that wait then.
  /// Further files are only imported meanwhile.
  void import_in_place(const std::filesystem::path& file);
  void delete_session(const SessionInfo& session);
  void rename_session(const SessionInfo& session, const std::string& name);
  /// Deletes a scan with the sessions that edit it.
  void delete_scan(const std::string& id);
  void rename_scan(const std::string& id, const std::string& name);
  /// `depth`: 0 is any that a session has, or the scan's default.
  void open_scan(const ScanInfo& scan, Opening opening, int depth = 0);
  void open(const SessionWish& wish);
  void join(const SessionInfo& session);
  /// Joins a session by name or id, once the list of sessions has arrived.
  void join_by_name(const std::string& session);
  void reopen(const RecentSession& recent);

  /// Runs `what` once the server answers; forgets it if the server cannot be reached. Connects to
  /// this computer if no server was chosen.
  void when_connected(std::function<void()> what);

  // The open session; null on the start page.
  Document* document() { return document_.get(); }
  const Document* document() const { return document_.get(); }
  /// Returns the surface that is shown until its session is there; null: none.
  const RawScan* raw() const { return raw_ ? &*raw_ : nullptr; }
  /// Returns whether the last picture of the raw scan stays, though its session is there: that of
  /// the session is not as fine yet. `shown`: the camera of the last picture.
  bool keeps_raw_picture(const Camera& shown) const;
  /// Returns whether there is a surface to look at.
  bool has_picture() const { return document_ || raw_; }
  /// Opens the raw scan of a file at this depth. Begins again if it is being prepared at another.
  void choose_depth(int depth);
  /// Returns the depth that was chosen for the raw scan; 0: none.
  int chosen_depth() const { return raw_depth_; }
  /// Opens a fork of the open session at another depth. Tells of the edits that it lacks.
  void open_again(int depth);
  /// Returns the memory of the server, bytes; 0: not known.
  uint64_t server_memory_bytes() const;
  /// Draws the document, or the raw scan. Fails: as the renderer does.
  Status draw();
  /// Returns a number that rises with each surface that begins to be shown.
  uint64_t pictures_begun() const { return pictures_begun_; }
  void close_document();
  /// `with_record`: also writes who did what beside the file, as a page and as JSON.
  void export_mesh(const std::filesystem::path& file, bool exact, bool with_record = false);
  void fork(const std::string& name, const std::string& checkpoint);

  /// Returns imports and other long work in progress.
  const std::vector<std::shared_ptr<Activity>>& activities() const { return activities_; }
  /// Returns true if no work is in progress.
  bool is_idle() const { return tasks_.is_idle(); }
  /// Says in the log whether all edits are saved.
  void tell_saved();
  /// Returns the number of edits of the open session that its server does not have on disk.
  Unsaved unsaved() const;
  /// Returns the link of the open session; kEnded without one.
  LinkState link() const { return document_ ? document_->link() : LinkState::kEnded; }
  bool is_opening() const { return opening_; }
  uint64_t exports_done() const { return exports_done_; }

  /// Records how the picture looks, and that it is saved to a file.
  void record_picture(const std::filesystem::path& file);
  /// Ends the trial of a strength: a picture that is to be saved shows the session's values. Call
  /// it again until Document::is_picture_settled().
  void want_picture() { strip.close(document_.get()); }
  /// Fails: unavailable while the surface may still be that of a trial, as over a lost link.
  Status check_picture() const;
  /// Reads the picture that the renderer has drawn, to be saved. One that lacks something says so
  /// in a corner and in its note. `bar`: lies over it. Fails: as the renderer does.
  Result<Image> read_picture(const std::optional<ScaleBar>& bar) const;
  /// Keeps a small picture of the open session, as it was drawn last. A trial is not kept.
  void keep_session_picture();
  /// Keeps the picture that was drawn last, if `strip` waits for it. Needs: it is at rest. Returns
  /// the small picture; null: none is waited for.
  const StrengthStrip::Picture* keep_strength_picture();
  /// Returns the folder of the sessions' pictures; empty: none are kept.
  std::filesystem::path picture_folder() const;

  /// Saves the window's state. Failures go to the log.
  void save_preferences();

 private:
  /// Work that returns a completion for the owner's thread.
  using Step = std::function<Tasks::Completion(const Progress&)>;
  void start_activity(const std::string& title, Step step);
  void start_activity(const std::shared_ptr<Activity>& activity, Step step);
  void take_connection(Result<Connection> connection);
  /// Chooses a session on a thread of its own.
  using Choice = std::function<Result<SessionWish>(Connection&)>;
  /// Opens a session on a thread of its own.
  using Opener =
      std::function<Result<OpenedDocument>(const std::shared_ptr<Connection>&, const Progress&)>;
  void tell_exported(const std::filesystem::path& file, const Result<ExportSummary>& outcome);
  void open_chosen(Choice choice) { open_chosen(std::move(choice), opening_activity()); }
  void open_chosen(Choice choice, const std::shared_ptr<Activity>& activity);
  void open_by(Opener opener, const std::shared_ptr<Activity>& activity);
  void open_wish(const std::shared_ptr<Connection>& connection, const SessionWish& wish,
                 const std::shared_ptr<Activity>& activity);
  bool begins_opening();
  void run_opener(const std::shared_ptr<Connection>& connection, Opener opener,
                  const std::shared_ptr<Activity>& activity);
  void take_opened(const std::shared_ptr<Activity>& activity, Result<OpenedDocument>& opened);
  void end_opening();
  void fail_opening(const std::shared_ptr<Activity>& activity, const Status& why);
  void look_early();
  void take_early(Result<RawScan>& early);
  static std::shared_ptr<Activity> opening_activity();
  void open_scan(const ScanInfo& scan, Opening opening, int depth,
                 const std::shared_ptr<Activity>& activity);
  void import_there(const std::filesystem::path& file, Opening opening,
                    const std::shared_ptr<Activity>& activity);
  void show_raw_and_import(const std::filesystem::path& file, Opening opening);
  void take_raw(const std::filesystem::path& file, Opening opening, Result<RawScan> read);
  void open_raw();
  bool begins_again();
  void delete_if_new(const OpenedDocument& opened);
  void close_raw(const std::filesystem::path& file);
  void forget_raw();
  /// Returns whether a file that was imported opens: no other surface is shown.
  bool may_open(const std::filesystem::path& file) const;
  bool takes_place(const std::filesystem::path& file);
  bool may_leave();
  void tell_imported(const std::filesystem::path& file, const ImportOutcome& outcome);
  void change_library(const std::string& what, std::function<Status(Connection&)> change);
  void show(OpenedDocument opened);
  void remember_document();
  void leave_document();
  std::optional<ViewState> kept_view(const std::string& session) const;
  void see_as_kept(const std::string& session);
  void restore_view(bool keeps_camera);
  void raise_axis();
  void save_view();
  bool need_connection(const std::string& what);
  /// The server as preferences.recent names it.
  std::string recent_server() const { return library_.is_private ? "" : library_.server; }
  void wake() const { options_.wake(); }

  PageRenderer& renderer_;
  WorkspaceOptions options_;
  std::shared_ptr<Connection> connection_;
  KnownServer connecting_;  // becomes the first of preferences.servers
  Library library_;
  std::vector<std::function<void()>> when_connected_;
  std::vector<std::shared_ptr<Activity>> activities_;
  bool opening_ = false;
  std::shared_ptr<Coming> coming_;  // what is opened, once it was chosen; null: nothing
  uint64_t exports_done_ = 0;
  std::string document_server_;  // empty: the private one
  uint64_t pictures_begun_ = 0;
  bool is_drawn_ = false;            // the renderer's picture is that of the document
  bool shows_trial_ = false;         // it may be of a strength that is tried
  uint64_t drawn_changes_ = 0;       // the document's, as it was drawn
  std::filesystem::path replacing_;  // opens in the place of the open session; empty: none
  std::filesystem::path raw_file_;   // the file that is read or shown raw; empty: none
  std::optional<RawScan> raw_;
  uint64_t raw_triangles_ = 0;  // of the raw scan that the document took over; 0: of none
  Opening raw_opening_ = Opening::kGoOn;
  int raw_depth_ = 0;                   // 0: the default, or that of the session that goes on
  std::shared_ptr<Activity> raw_work_;  // imports and opens the raw scan
  bool raw_begins_again_ = false;       // at another depth, once raw_work_ has ended
  std::unique_ptr<Document> document_;
  Tasks tasks_;  // last member: its threads end before the objects that they use
};

/// Connects to this user's server on this computer. Starts the server if it does not run, now and
/// after each end. Fails: as find_private_server() and Connection::open() do.
Result<Connection> open_private_connection(const PrivateServerOptions& options,
                                           std::chrono::milliseconds timeout,
                                           const Progress& progress);

/// Returns HOST:PORT for HOST or HOST:PORT; a unix:PATH as it is.
std::string with_port(const std::string& server);

}  // namespace burnish
