// The processing record as JSON. docs/formats.md describes the fields.

#include <nlohmann/json.hpp>

#include "client/report/deviation_json.h"
#include "client/report/processing_record.h"
#include "client/report/time_text.h"

namespace burnish {

using Json = nlohmann::ordered_json;

static constexpr int kRecordVersion = 1;

static Json input_of(const ScanInfo& scan) {
  return {{"name", scan.name},
          {"format", mesh_format_name(scan.format)},
          {"size_bytes", scan.size_bytes},
          {"sha256", scan.id},
          {"unit", scan.unit},
          {"vertices", scan.statistics.vertices},
          {"triangles", scan.statistics.triangles},
          {"diagonal", scan.statistics.diagonal()},
          {"closed", scan.statistics.is_closed()}};
}

static Json output_of(const ProcessingRecord& record) {
  return {{"file", record.file},
          {"size_bytes", record.result.size_bytes},
          {"sha256", record.result.sha256},
          {"vertices", record.result.vertices},
          {"triangles", record.result.triangles},
          {"left_out", record.result.left_out},
          {"pictures", record.result.pictures},
          {"lost_volume", record.result.lost_volume}};
}

static Json method_of(const ProcessingRecord& record) {
  Json method = {{"name", "screened Poisson equation, Chuang and Kazhdan 2011"},
                 {"depth", record.state.session.key.depth},
                 {"cell_size", record.prepared.cell_size},
                 {"length_unit", record.prepared.length_unit},
                 {"curvature_radius", record.state.session.key.curvature_radius}};
  for (const SettingText& setting : texts_of(record.state.settings))
    method[setting.key] = setting.text;
  method["gradient_scale"] = record.state.settings.beta;
  method["palette"] = to_line(record.state.settings.palette);
  method["backend"] = record.state.backend;
  method["cycles"] = record.result.cycles;
  method["converged"] = record.result.converged;
  method["distance"] = record.result.distance;
  return method;
}

static Json edits_of(const ProcessingRecord& record) {
  Json edits = Json::array();
  for (const HistoryEntry& entry : record.edits)
    edits.push_back({{"number", entry.number},
                     {"time", utc_text(entry.unix_ms)},
                     {"author", entry.author},
                     {"kind", edit_kind_name(entry.kind)},
                     {"what", entry.summary},
                     {"on", entry.enabled}});
  return edits;
}

std::string record_json(const ProcessingRecord& record) {
  const Json json = {{"burnish_record", kRecordVersion},
                     {"program", record.program},
                     {"time", utc_text(record.unix_ms)},
                     {"author", record.author},
                     {"session", record.state.session.name},
                     {"session_id", record.state.session.id},
                     {"input", input_of(record.scan)},
                     {"output", output_of(record)},
                     {"method", method_of(record)},
                     {"deviation", deviation_json(record.result.deviation.value_or(Deviation()))},
                     {"edits", edits_of(record)},
                     {"edited_since", record.is_edited_since}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace burnish
