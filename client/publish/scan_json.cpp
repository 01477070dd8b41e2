#include "client/publish/scan_json.h"

#include <nlohmann/json.hpp>

#include "common/base/base64.h"

namespace burnish {

using Json = nlohmann::ordered_json;

static constexpr int kPublicationVersion = 1;

static Json place_of(const Vec3d& point) {
  return {point.x(), point.y(), point.z()};
}

static Json answers_of(const Opening& opening) {
  Json answers = Json::object();
  for (const RecordedAnswer& answer : opening_answers(opening))
    answers[answer.method] = base64(answer.message);
  return answers;
}

// No file was exported.
static Json record_of(const ProcessingRecord& record) {
  Json json = Json::parse(record_json(record));
  json.erase("output");
  return json;
}

std::string scan_json(const PublishedScan& scan) {
  const ScanInfo& info = scan.opening.scan.scan;
  const Json json = {
      {kPublicationKey, kPublicationVersion},
      {"title", scan.title},
      {"credit", scan.credit},
      {"scan", info.name},
      {"session", scan.opening.state.session.name},
      {"unit", info.unit},
      {"vertices", info.statistics.vertices},
      {"triangles", info.statistics.triangles},
      {"box",
       {{"min", place_of(info.statistics.box_min)}, {"max", place_of(info.statistics.box_max)}}},
      {"record", record_of(scan.record)},
      {"parts",
       {{"file", scan.files.parts},
        {"index", scan.files.index},
        {"blocks", scan.blocks},
        {"pages", scan.pages},
        {"sheets_per_page", scan.sheets_per_page}}},
      {"answers", answers_of(scan.opening)},
      {"welcome", base64(scan.welcome)},
      {"frame", base64(scan.frame)},
      {"largest_move", scan.largest_move}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace burnish
