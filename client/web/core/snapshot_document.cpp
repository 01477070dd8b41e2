#include <algorithm>
#include <set>

#include "client/model/documents/depth_choice.h"
#include "client/model/documents/figures.h"
#include "client/model/documents/undo_words.h"
#include "client/report/entry_text.h"
#include "client/web/core/snapshot.h"
#include "common/mesh/export_formats.h"

namespace burnish {

namespace {

// A count without a limit is a very large number.
constexpr int64_t kWholeMax = int64_t{1} << 53;

int64_t whole_of(uint64_t value) {
  return static_cast<int64_t>(std::min<uint64_t>(value, kWholeMax));
}

void write_point(const char* name, const Vec3d& point, JsonWriter& json) {
  json.key(name).open_list().number(point.x()).number(point.y()).number(point.z()).close_list();
}

void write_scan_facts(const Workspace& workspace, JsonWriter& json) {
  const Document& document = *workspace.document();
  const ScanInfo& scan = document.scan().scan;
  json.text("scan", scan.name).text("unit", document.unit()).whole("depth", document.depth());
  json.key("depths").open_list();
  for (const DepthChoice& choice : depth_choices(
           scan.statistics, document.unit(), workspace.server_memory_bytes(), scan.default_depth))
    json.open()
        .whole("depth", choice.depth)
        .text("text", choice.refusal.empty() ? choice.text : choice.refusal)
        .flag("possible", choice.refusal.empty())
        .close();
  json.close_list();
  json.number("cellSize", document.cell_size()).number("diagonal", document.diagonal());
  json.number("lengthUnit", document.length_unit());
  json.key("box").open();
  write_point("low", document.box().min(), json);
  write_point("high", document.box().max(), json);
  json.close();
  json.key("formats").open_list();
  for (const MeshFormat format : export_formats(scan.format)) json.text(mesh_format_name(format));
  json.close_list();
  json.flag("closed", document.is_closed()).flag("hasColours", document.has_colours());
}

void write_link(const Document& document, JsonWriter& json) {
  json.text("link", link_state_name(document.link())).text("linkReason", document.link_reason());
  json.flag("moving", document.is_moving());
  json.text("state", state_word(document)).flag("settled", document.is_settled());
  json.whole("unsavedEdits", whole_of(document.unacknowledged()));
  json.text("role", session_role_name(document.welcome().role));
}

const char* kind_word(EditKind kind) {
  if (kind == EditKind::kSetCheckpoint) return "checkpoint";
  return kind == EditKind::kDamaged ? "damaged" : "edit";
}

// The name of a checkpoint means its last use.
void write_history(const Document& document, JsonWriter& json) {
  json.key("history").open_list();
  std::set<std::string> later;  // names of checkpoints
  const auto& history = document.history();
  for (auto entry = history.rbegin(); entry != history.rend(); ++entry) {
    const bool is_checkpoint = entry->kind == EditKind::kSetCheckpoint;
    json.open().whole("number", whole_of(entry->number)).text("kind", kind_word(entry->kind));
    json.flag("enabled", entry->enabled).text("name", entry_name(*entry));
    json.text("details", entry_details(*entry, document.unit()));
    json.text("author", entry->author).whole("time", entry->unix_ms / 1000);
    json.flag("superseded", is_checkpoint && !later.insert(entry->summary).second).close();
  }
  json.close_list();
  json.text("undoHint", undo_hint(document)).text("redoHint", redo_hint(document));
  json.text("undoName", undo_name(document)).text("redoName", document.undo_steps().redo_name());
}

void write_people(const Document& document, JsonWriter& json) {
  json.key("people").open_list();
  for (const PresentUser& user : document.people().present)
    json.open()
        .whole("connection", whole_of(user.connection))
        .text("user", user.user)
        .whole("colour", user.colour)
        .text("role", session_role_name(document.people().roles.of(user.user)))
        .flag("me", user.connection == document.welcome().connection)
        .close();
  json.close_list();
}

}  // namespace

void write_document(Workspace& workspace, const FrontState& state, JsonWriter& json) {
  const Document& document = *workspace.document();
  json.open();
  json.text("session", document.session().name).text("sessionId", document.session().id);
  write_scan_facts(workspace, json);
  write_link(document, json);
  write_tools(workspace, json);
  write_panels(workspace, json);
  write_history(document, json);
  write_people(document, json);
  write_view(workspace, json);
  write_over(workspace, json);
  write_section(document, state, json);
  json.key("figures").open_list();
  if (state.shows_figures && document.stats().frames > 0)
    for (const Figure& figure : link_figures(document))
      json.open().text("name", figure.name).text("value", figure.value).close();
  json.close_list();
  json.close();
}

}  // namespace burnish
