#include "client/cli/json_output.h"

#include "client/report/deviation_json.h"

namespace burnish {

using Json = nlohmann::ordered_json;

static Json point(const Vec3d& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

static Json to_json(const ThinWalls& walls) {
  if (walls.share <= 0) return nullptr;
  return {{"share", walls.share}, {"depth", walls.depth > 0 ? Json(walls.depth) : Json()}};
}

Json to_json(const ScanInfo& scan) {
  Json json = json_of<Json>(scan);
  json["format"] = mesh_format_name(scan.format);
  add_fields(scan.statistics, json);
  json["box_min"] = point(scan.statistics.box_min);
  json["box_max"] = point(scan.statistics.box_max);
  json["prepared"] = Json::array();
  for (const PreparedInfo& prepared : scan.prepared)
    json["prepared"].push_back(json_of<Json>(prepared));
  return json;
}

Json to_json(const ScanDescription& description) {
  Json json = to_json(description.scan);
  if (!description.prepared) return json;
  const PreparedDescription& prepared = *description.prepared;
  Json entry = json_of<Json>(prepared);
  entry["histogram"] = {{"range", prepared.histogram_range}, {"area", prepared.histogram}};
  entry["walls"] = to_json(prepared.walls);
  json["described"] = entry;
  return json;
}

Json to_json(const SessionInfo& session) {
  return json_of<Json>(session);
}

static Json to_json(const Equaliser& equaliser) {
  Json bands = Json::array();
  for (const Band& band : equaliser.bands) bands.push_back(json_of<Json>(band));
  return bands;
}

static Json to_json(const Palette& palette) {
  Json curves = Json::array();
  for (const PaletteCurve& curve : palette.curves)
    curves.push_back(
        {{"name", curve.name}, {"colour", curve.colour}, {"curve", curve.curve.to_string()}});
  return curves;
}

static Json to_json(const EdgeFilter& edges) {
  return {{"strength", edges.strength},
          {"filter", name_of(edges.kind)},
          {"angle", edges.edge_angle},
          {"passes", edges.passes},
          {"crispness", edges.crispness}};
}

Json to_json(const SessionState& state) {
  Json json = to_json(state.session);
  json["beta"] = state.settings.beta;
  json["curve"] = state.settings.curve.to_string();
  json["controls"] = json_of<Json>(state.settings.controls);
  json["rims"] = {{"number", state.rims}, {"held", state.rims_held}};
  json["walls"] = to_json(state.walls);
  json["bands"] = to_json(state.settings.equaliser);
  json["palette"] = to_json(state.settings.palette);
  json["colours"] = json_of<Json>(state.settings.colour);
  json["texture"] = json_of<Json>(state.settings.texture);
  json["edges"] = to_json(state.settings.edges);
  json["memory_bytes"] = state.memory_bytes;
  json["backend"] = state.backend;
  if (state.cycles > 0) {
    json["cycles"] = state.cycles;
    json["energy"] = state.energy;
    json["residual"] = state.residual;
    json["distance"] = state.distance;
  }
  return json;
}

Json to_json(const ExportSummary& summary) {
  Json json = json_of<Json>(summary);
  json["volume"] = summary.volume != 0 ? Json(summary.volume) : Json();
  return json;
}

Json to_json(const SessionDeviation& measured) {
  Json json = deviation_json(measured.deviation);
  json["settled"] = measured.settled;
  return json;
}

Json to_json(const HistoryEntry& entry) {
  return {{"number", entry.number},
          {"id", entry.edit_id},
          {"author", entry.author},
          {"unix_ms", entry.unix_ms},
          {"kind", edit_kind_name(entry.kind)},
          {"summary", entry.summary},
          {"enabled", entry.enabled},
          {"name", entry.name},
          {"details", entry.details},
          {"radius", entry.radius > 0 ? Json(entry.radius) : Json()}};
}

Json to_json(const SessionPeople& people) {
  Json json = {{"roles", Json::object()}, {"present", Json::array()}};
  for (const auto& [user, role] : people.roles.by_user())
    json["roles"][user] = session_role_name(role);
  for (const PresentUser& user : people.present) json["present"].push_back(user.user);
  return json;
}

}  // namespace burnish
