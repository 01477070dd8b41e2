#include "client/web/core/snapshot.h"

#include <algorithm>

#include "client/report/about_text.h"
#include "client/tools/own_presets.h"

namespace burnish {

namespace {

constexpr size_t kMessagesMax = 30;

const char* word_of(Library::State state) {
  static constexpr const char* kWords[] = {"unconnected", "connecting", "connected", "failed"};
  return kWords[static_cast<int>(state)];
}

const char* word_of(Severity severity) {
  static constexpr const char* kWords[] = {"info", "warning", "error"};
  return kWords[static_cast<int>(severity)];
}

void write_scan(const ScanInfo& scan, JsonWriter& json) {
  json.open().text("id", scan.id).text("name", scan.name);
  json.whole("triangles", static_cast<int64_t>(scan.statistics.triangles));
  json.flag("closed", scan.statistics.is_closed());
  json.whole("bytes", static_cast<int64_t>(bytes_on_disk(scan)));
  json.whole("imported", scan.imported_unix_seconds);
  json.text("unit", scan.unit).whole("defaultDepth", scan.default_depth).close();
}

/// Returns when this browser showed a session last; 0: never.
int64_t shown_at(const Preferences& preferences, const std::string& session) {
  for (const RecentSession& recent : preferences.recent)
    if (recent.id == session) return recent.shown_unix_seconds;
  return 0;
}

void write_session(const SessionInfo& session, const Preferences& preferences, JsonWriter& json) {
  json.open().text("id", session.id).text("name", session.name).text("scan", session.scan_id);
  json.whole("edits", static_cast<int64_t>(session.edits)).whole("depth", session.key.depth);
  json.whole("begun", session.created_unix_seconds);
  json.whole("shown", shown_at(preferences, session.id)).close();
}

void write_library(const Workspace& workspace, JsonWriter& json) {
  const Library& library = workspace.library();
  json.key("library").open();
  json.text("state", word_of(library.state)).text("server", library.server);
  const bool has_failed = library.state == Library::State::kFailed;
  json.text("problem", has_failed ? library.problem : "");
  json.flag("wantsToken", has_failed && library.refuses_user);
  json.key("scans").open_list();
  for (const ScanInfo& scan : library.scans) write_scan(scan, json);
  json.close_list().key("sessions").open_list();
  for (const SessionInfo& session : library.sessions)
    write_session(session, workspace.preferences, json);
  json.close_list();
  json.whole("serverMemory", static_cast<int64_t>(workspace.server_memory_bytes())).close();
}

void write_activities(const Workspace& workspace, FrontState& front, JsonWriter& json) {
  json.key("activities").open_list();
  for (const auto& activity : workspace.activities()) {
    const Activity::State state = activity->state();
    json.open().whole("number", static_cast<int64_t>(front.number_of(activity)));
    json.text("title", activity->title()).text("phase", state.phase);
    json.number("fraction", std::clamp(state.fraction, 0.0, 1.0));
    json.number("secondsLeft", state.seconds_left.value_or(-1));
    json.flag("makesFile", activity->makes_file()).close();
  }
  json.close_list();
}

void write_messages(const MessageLog& log, const FrontState& front, JsonWriter& json) {
  json.key("messages").open_list();
  const auto& messages = log.messages();
  for (size_t i = messages.size() - std::min(messages.size(), kMessagesMax); i < messages.size();
       ++i) {
    const uint64_t number = log.first_number() + i;
    if (front.dismissed.contains(number)) continue;
    const auto since = messages[i].time.time_since_epoch();
    json.open().whole("number", static_cast<int64_t>(number));
    json.text("severity", word_of(messages[i].severity)).text("text", messages[i].text);
    json.whole("time", std::chrono::duration_cast<std::chrono::seconds>(since).count()).close();
  }
  json.close_list();
}

void write_preset(const Preset& preset, bool is_own, const Document* document, JsonWriter& json) {
  std::string description = preset.description;
  if (document) description += ". " + effect_of(preset, document->lengths()) + ".";
  json.open().text("name", preset.name).text("description", description);
  json.flag("changes", preset.beta != 1 || !preset.bands.empty()).flag("own", is_own).close();
}

void write_preset_in_force(const PresetInForce& shown, JsonWriter& json) {
  json.open().text("name", shown.preset.name).number("strength", shown.strength);
  json.text("word", std::string(strength_word(shown.strength)));
  json.flag("hasTrial", Document::has_trial(shown.preset)).close();
}

void write_presets(const Document* document, JsonWriter& json) {
  const auto read = read_own_presets(own_presets_path());
  const std::vector<Preset> own = read.is_ok() ? *read : std::vector<Preset>();
  json.key("presets").open_list();
  for (const Preset& preset : own) write_preset(preset, true, document, json);
  for (const Preset& preset : presets()) write_preset(preset, false, document, json);
  json.close_list();
  json.key("preset");
  const auto shown = document ? document->preset_in_force(own) : std::nullopt;
  shown ? write_preset_in_force(*shown, json) : void(json.null());
}

void write_strengths(const StrengthStrip& strip, JsonWriter& json) {
  json.key("strengths");
  if (!strip.is_open()) return void(json.null());
  json.open().text("preset", strip.preset()).text("trial", strip.trial_text());
  json.key("pictures").open_list();
  for (const StrengthStrip::Picture& picture : strip.pictures())
    json.open()
        .number("strength", picture.strength)
        .text("word", std::string(strength_word(picture.strength)))
        .whole("number", static_cast<int64_t>(picture.number))
        .close();
  json.close_list().close();
}

void write_about(JsonWriter& json) {
  json.key("about").open_list();
  for (const AboutText& about : about_texts())
    json.open().text("title", about.title).text("text", about.text).close();
  json.close_list();
}

}  // namespace

std::string snapshot_of(Workspace& workspace, FrontState& state) {
  JsonWriter json;
  json.open();
  write_library(workspace, json);
  write_activities(workspace, state, json);
  write_messages(workspace.log, state, json);
  write_presets(workspace.document(), json);
  write_strengths(workspace.strip, json);
  write_about(json);
  json.flag("recording", state.script.has_value());
  json.text("opening", workspace.raw() ? workspace.raw()->name : "");
  json.key("document");
  workspace.document() ? write_document(workspace, state, json) : void(json.null());
  json.close();
  return json.written();
}

}  // namespace burnish
