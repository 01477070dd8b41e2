#include "client/publish/publication.h"

#include <algorithm>
#include <array>
#include <utility>

#include "client/publish/new_folder.h"
#include "client/publish/page_parts.h"
#include "client/publish/scan_json.h"
#include "client/publish/viewer_files.h"
#include "common/base/atomic_file.h"
#include "common/base/file_reader.h"
#include "common/base/text.h"
#include "common/pages/directory_codec.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

constexpr const char* kScanFile = "scan.json";
constexpr size_t kNamedSessionsMax = 10;

std::string names_of(const std::vector<SessionInfo>& sessions) {
  if (sessions.empty()) return "the server has no session";
  std::string text = "the server has ";
  for (size_t i = 0; i < std::min(sessions.size(), kNamedSessionsMax); ++i)
    text += (i == 0 ? "" : ", ") + sessions[i].name;
  const size_t others = sessions.size() - std::min(sessions.size(), kNamedSessionsMax);
  return others == 0 ? text : text + " and " + std::to_string(others) + " more";
}

/// Asks for a session, and names those that there are if there is no such.
Result<SessionState> find_session(Connection& connection, const std::string& session) {
  auto state = connection.state(session);
  if (state.is_ok() || state.status().code() != StatusCode::kNotFound) return state;
  const auto sessions = connection.list_sessions();
  if (!sessions.is_ok()) return state;
  return not_found(state.status().message() + "; " + names_of(*sessions));
}

// Older servers have no sheets.
Result<SheetsDescription> sheets_of(Connection& connection, const SessionState& state,
                                    const Progress& progress) {
  const bool is_levelled = state.settings.texture.level_seams > 0;
  auto sheets = connection.describe_sheets(state.session.scan_id, progress,
                                           is_levelled ? state.session.id : std::string());
  const bool has_none = sheets.status().code() == StatusCode::kUnimplemented;
  return has_none ? Result<SheetsDescription>(SheetsDescription()) : std::move(sheets);
}

Result<Opening> ask_opening(Connection& connection, const std::string& session,
                            const Progress& progress) {
  Opening opening;
  ASSIGN_OR_RETURN(opening.state, find_session(connection, session));
  const SessionInfo& info = opening.state.session;
  ASSIGN_OR_RETURN(opening.scan, connection.describe_scan(info.scan_id, info.key.depth));
  ASSIGN_OR_RETURN(opening.pages, connection.describe_pages(info.scan_id, progress));
  ASSIGN_OR_RETURN(opening.sheets, sheets_of(connection, opening.state, progress));
  return opening;
}

/// The record of a surface that nobody exported.
Result<ProcessingRecord> record_of(Connection& connection, const Opening& opening,
                                   const FrameStats& shown) {
  RecordedExport made{connection.user(), {}, {}};
  made.result.cycles = shown.cycles;
  made.result.converged = shown.settled;
  made.result.distance = shown.distance;
  made.result.edits = shown.edits;
  made.result.deviation = opening.deviation.deviation;
  return make_processing_record(connection, opening.state.session.id, made);
}

bool is_of_publication(const fs::path& entry) {
  const std::string name = entry.filename().string();
  return name == kScanFile || is_of_viewer(name) ||
         (name.starts_with("scan-") && (name.ends_with(".parts") || name.ends_with(".index")));
}

/// Returns an entry of a folder that no publication has; empty: there is none.
std::string foreign_entry(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (!is_of_publication(entry.path())) return entry.path().filename().string();
  return {};
}

bool says_publication(const fs::path& path) {
  std::array<uint8_t, 64> begin = {};
  const auto file = FileReader::open(path);
  if (!file.is_ok() || file->file_bytes() < begin.size() || !file->read(0, begin).is_ok())
    return false;
  return std::string(begin.begin(), begin.end()).find(kPublicationKey) != std::string::npos;
}

/// Returns why a folder that is not empty is not replaced: nobody's files are lost by --replace.
std::string objection(const fs::path& folder, bool replace) {
  const std::string name = folder.string();
  if (!replace) return name + " is not empty; --replace takes the place of a publication";
  if (!says_publication(folder / kScanFile))
    return name + " has no " + kScanFile + " of a publication, so it is not replaced";
  const std::string foreign = foreign_entry(folder);
  if (foreign.empty()) return {};
  return name + " has " + foreign + ", which no publication has, so it is not replaced";
}

Result<Publication> counted(const fs::path& folder) {
  Publication made;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    ++made.files;
    made.bytes += entry.file_size(error);
  }
  if (error) return errno_status("cannot read the folder " + folder.string(), error.value());
  return made;
}

Result<PublishedScan> write_parts(Connection& connection, Opening opening, const fs::path& folder,
                                  const Progress& progress) {
  PublishedScan scan;
  ASSIGN_OR_RETURN(const PageHead head, decode_head(opening.pages.head));
  ASSIGN_OR_RETURN(RestingSurface surface, RestingSurface::join(connection, opening.state.session,
                                                                opening.pages.head, progress));
  ASSIGN_OR_RETURN(PartsWriter parts, PartsWriter::create(folder));
  RETURN_IF_ERROR(write_page_parts(connection, opening, surface, parts, progress));
  ASSIGN_OR_RETURN(scan.sheets_per_page, write_sheet_parts(connection, opening, parts, progress));
  ASSIGN_OR_RETURN(scan.files, parts.finish());
  ASSIGN_OR_RETURN(opening.deviation, connection.deviation(opening.state.session.id));
  ASSIGN_OR_RETURN(scan.record, record_of(connection, opening, surface.stats()));
  scan.blocks = head.block_count();
  scan.pages = head.page_count();
  scan.welcome = welcome_message(surface.welcome());
  scan.frame = frame_figures(surface.stats());
  scan.largest_move = surface.largest_move();
  scan.opening = std::move(opening);
  return scan;
}

}  // namespace

Status check_published_text(const std::string& what, const std::string& text) {
  if (text.size() > kPublishedTextBytesMax)
    return invalid_argument(what + " has " + std::to_string(text.size()) + " bytes, the limit is " +
                            std::to_string(kPublishedTextBytesMax));
  if (one_line(text, kPublishedTextBytesMax) == text) return Status::ok();
  return invalid_argument(what + " has control characters, or is not UTF-8");
}

Result<Publication> publish(Connection& connection, const PublishWish& wish,
                            const Progress& progress) {
  RETURN_IF_ERROR(check_has_viewer());
  ASSIGN_OR_RETURN(NewFolder folder, NewFolder::create(wish.folder, [&](const fs::path& old) {
                     return objection(old, wish.replace);
                   }));
  ASSIGN_OR_RETURN(Opening opening, ask_opening(connection, wish.session, progress));
  ASSIGN_OR_RETURN(PublishedScan scan,
                   write_parts(connection, std::move(opening), folder.path(), progress));
  const SessionInfo& session = scan.opening.state.session;
  scan.title = wish.title.empty() ? session.name : wish.title;
  scan.credit = wish.credit;
  RETURN_IF_ERROR(write_viewer(folder.path()));
  RETURN_IF_ERROR(write_file(folder.path() / kScanFile, scan_json(scan)));
  ASSIGN_OR_RETURN(Publication made, counted(folder.path()));
  made.pages = scan.pages;
  made.triangles = scan.opening.scan.scan.statistics.triangles;
  made.has_textures = scan.sheets_per_page > 0;
  RETURN_IF_ERROR(folder.commit());
  return made;
}

}  // namespace burnish
