#include "client/connection/recorded_answers.h"

#include <utility>

#include "burnish/v1/editing.pb.h"
#include "burnish/v1/library.pb.h"
#include "common/wire/library_wire.h"
#include "common/wire/live_wire.h"
#include "common/wire/measures_wire.h"
#include "common/wire/pages_wire.h"
#include "common/wire/session_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

static std::vector<RecordedAnswer> library_answers(const Opening& opening) {
  v1::ListScansResponse scans;
  *scans.add_scans() = to_wire(opening.scan.scan);
  v1::PrepareEvent prepared;
  *prepared.mutable_done() = to_wire(opening.scan.scan);
  v1::DescribePagesEvent pages;
  *pages.mutable_done() = to_wire(opening.pages);
  v1::DescribeSheetsEvent sheets;
  *sheets.mutable_done() = to_wire(opening.sheets);
  return {{"burnish.v1.Library/ListScans", scans.SerializeAsString()},
          {"burnish.v1.Library/PrepareScan", prepared.SerializeAsString()},
          {"burnish.v1.Library/DescribeScan", to_wire(opening.scan).SerializeAsString()},
          {"burnish.v1.Library/DescribePages", pages.SerializeAsString()},
          {"burnish.v1.Library/DescribeSheets", sheets.SerializeAsString()}};
}

std::vector<RecordedAnswer> opening_answers(const Opening& opening) {
  v1::ListSessionsResponse sessions;
  *sessions.add_sessions() = to_wire(opening.state.session);
  v1::OpenSessionResponse opened;
  *opened.mutable_session() = to_wire(opening.state.session);
  opened.set_attached(true);
  v1::GetHistoryResponse history;
  history.set_complete(true);
  std::vector<RecordedAnswer> answers = library_answers(opening);
  answers.push_back({"burnish.v1.Editing/ListSessions", sessions.SerializeAsString()});
  answers.push_back({"burnish.v1.Editing/OpenSession", opened.SerializeAsString()});
  answers.push_back({"burnish.v1.Editing/GetState", to_wire(opening.state).SerializeAsString()});
  answers.push_back({"burnish.v1.Editing/GetHistory", history.SerializeAsString()});
  answers.push_back(
      {"burnish.v1.Editing/GetDeviation", to_wire(opening.deviation).SerializeAsString()});
  return answers;
}

std::string welcome_message(Welcome welcome) {
  welcome.connection = 1;
  welcome.role = SessionRole::kViewer;
  welcome.fleet.clear();
  return to_wire(ServerMessage(std::move(welcome))).SerializeAsString();
}

std::string frame_figures(const FrameStats& stats) {
  return to_wire(ServerMessage(LiveFrame{{}, stats})).frame().SerializeAsString();
}

std::string block_event(const PagePart& part) {
  v1::FetchPagesEvent event;
  *event.mutable_block() = to_wire(part);
  return event.SerializeAsString();
}

std::string page_event(const PagePart& part) {
  v1::FetchPagesEvent event;
  *event.mutable_page() = to_wire(part);
  return event.SerializeAsString();
}

std::string sheet_block_event(const PagePart& part) {
  v1::FetchSheetsEvent event;
  *event.mutable_block() = to_wire(part);
  return event.SerializeAsString();
}

std::string charts_event(const PagePart& part) {
  v1::FetchSheetsEvent event;
  *event.mutable_charts() = to_wire(part);
  return event.SerializeAsString();
}

std::string sheet_event(const SheetPart& part) {
  v1::FetchSheetsEvent event;
  *event.mutable_sheet() = to_wire(part);
  return event.SerializeAsString();
}

}  // namespace burnish
