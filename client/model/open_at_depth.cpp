// A session goes on at another depth.

#include <algorithm>

#include "client/model/session_choice.h"
#include "client/model/workspace.h"
#include "common/edit/edit_id.h"

namespace burnish {

/// Returns edits that make the values of a state.
static std::vector<Edit> edits_of(const SessionState& state) {
  std::vector<Edit> edits;
  const auto add = [&](auto change) { edits.push_back({random_id(), std::move(change)}); };
  add(SetTransferCurve{state.transfer_curve});
  if (!(state.palette == Palette())) add(SetPalette{state.palette});
  add(SetGradientScale{state.gradient_scale});
  add(SetControls{state.controls});
  if (!(state.equaliser == Equaliser())) add(SetEqualiser{state.equaliser});
  return edits;
}

// Servers do not hand out what was painted, protected or set cell by cell.
static std::string left_behind_text(const std::vector<HistoryEntry>& history,
                                    const std::string& session) {
  const auto strokes = std::ranges::count_if(history, [](const HistoryEntry& entry) {
    return entry.enabled && entry.kind == EditKind::kStroke;
  });
  return "this session begins without " + std::to_string(strokes) +
         (strokes == 1 ? " stroke" : " strokes") + " of " + session +
         ", and without its protected regions and single cells";
}

Result<OpenedDocument> open_at_depth(std::shared_ptr<Connection> connection,
                                     const std::string& session, const ScanInfo& scan, int depth,
                                     const Progress& progress) {
  ASSIGN_OR_RETURN(const SessionState state, connection->state(session));
  ASSIGN_OR_RETURN(const auto history, connection->history(session));
  ASSIGN_OR_RETURN(const auto sessions, connection->list_sessions());
  const SessionWish wish = new_session(scan, sessions, depth);
  RETURN_IF_ERROR(connection->prepare_scan(scan.id, wish.key, progress).status());
  ASSIGN_OR_RETURN(const OpenedSession made, connection->open_session(wish));
  RETURN_IF_ERROR(connection->apply(made.session.id, edits_of(state)).status());
  ASSIGN_OR_RETURN(OpenedDocument opened,
                   open_document(connection, wish_to_join(made.session), progress));
  opened.lacks = left_behind_text(history, state.session.name);
  return opened;
}

}  // namespace burnish
