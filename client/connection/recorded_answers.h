#pragma once

#include <string>
#include <vector>

#include "common/service/live.h"
#include "common/service/scan_info.h"
#include "common/service/scan_pages.h"
#include "common/service/scan_sheets.h"
#include "common/service/session_info.h"
#include "common/service/surface_measures.h"

namespace burnish {

// The messages of the protocol by which a server answers a client that looks, for readers that have
// no server: a publication (client/publish).

/// The answers to a client that opens a session.
struct Opening {
  ScanDescription scan;
  SessionState state;
  PagesDescription pages;
  SheetsDescription sheets;
  SessionDeviation deviation;
};

/// The one message of the answer to a call.
struct RecordedAnswer {
  std::string method;  ///< "burnish.v1.Library/ListScans"
  std::string message;
};

/// Returns the answers to the calls by which a session is found and opened. The library has this
/// scan and this session alone, and the history is empty: it names people.
std::vector<RecordedAnswer> opening_answers(const Opening& opening);

/// Returns the first message of the live session, to a viewer without a fleet.
std::string welcome_message(Welcome welcome);

/// Returns a live session's message with the figures of a frame, as a Frame without its data.
std::string frame_figures(const FrameStats& stats);

// An event of FetchPages or FetchSheets.
std::string block_event(const PagePart& part);
std::string page_event(const PagePart& part);
std::string sheet_block_event(const PagePart& part);
std::string charts_event(const PagePart& part);
std::string sheet_event(const SheetPart& part);

}  // namespace burnish
