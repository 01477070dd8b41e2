#include "server/library/scan_record.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "common/base/file_content.h"
#include "common/pages/page_format.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

namespace fs = std::filesystem;
using nlohmann::json;

static json point_to_json(const Vec3d& p) {
  return json::array({p.x(), p.y(), p.z()});
}

static Vec3d point_from_json(const json& p) {
  return {p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>()};
}

static json statistics_to_json(const MeshStatistics& s) {
  return {{"vertices", s.vertices},
          {"triangles", s.triangles},
          {"boundary_edges", s.boundary_edges},
          {"non_manifold_edges", s.non_manifold_edges},
          {"components", s.components},
          {"zero_area_triangles", s.zero_area_triangles},
          {"unreferenced_vertices", s.unreferenced_vertices},
          {"area", s.area},
          {"signed_volume", s.signed_volume},
          {"mean_edge_length", s.mean_edge_length},
          {"box_min", point_to_json(s.box_min)},
          {"box_max", point_to_json(s.box_max)}};
}

static MeshStatistics statistics_from_json(const json& j) {
  MeshStatistics s;
  j.at("vertices").get_to(s.vertices);
  j.at("triangles").get_to(s.triangles);
  j.at("boundary_edges").get_to(s.boundary_edges);
  j.at("non_manifold_edges").get_to(s.non_manifold_edges);
  j.at("components").get_to(s.components);
  j.at("zero_area_triangles").get_to(s.zero_area_triangles);
  j.at("unreferenced_vertices").get_to(s.unreferenced_vertices);
  j.at("area").get_to(s.area);
  j.at("signed_volume").get_to(s.signed_volume);
  j.at("mean_edge_length").get_to(s.mean_edge_length);
  s.box_min = point_from_json(j.at("box_min"));
  s.box_max = point_from_json(j.at("box_max"));
  return s;
}

std::string scan_to_json(const ScanInfo& scan) {
  const json j = {{"id", scan.id},
                  {"name", scan.name},
                  {"format", mesh_format_name(scan.format)},
                  {"size_bytes", scan.size_bytes},
                  {"imported_unix_seconds", scan.imported_unix_seconds},
                  {"default_depth", scan.default_depth},
                  {"has_colours", scan.has_colours},
                  {"unit", scan.unit},
                  {"statistics", statistics_to_json(scan.statistics)}};
  return j.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<ScanInfo> scan_from_json(const std::string& text) try {
  const json j = json::parse(text);
  ScanInfo scan;
  j.at("id").get_to(scan.id);
  j.at("name").get_to(scan.name);
  ASSIGN_OR_RETURN(scan.format, mesh_format_of_name(j.at("format").get<std::string>()));
  j.at("size_bytes").get_to(scan.size_bytes);
  j.at("imported_unix_seconds").get_to(scan.imported_unix_seconds);
  j.at("default_depth").get_to(scan.default_depth);
  j.at("has_colours").get_to(scan.has_colours);
  scan.unit = j.value("unit", "");  // scans of earlier versions have none
  scan.statistics = statistics_from_json(j.at("statistics"));
  return scan;
} catch (const json::exception& error) {
  return data_loss(std::string("info.json is damaged: ") + error.what());
}

std::string original_file_name(MeshFormat format) {
  return "original." + std::string(mesh_format_name(format));
}

static std::string file_name_of_version(const PreparedKey& key, uint32_t version) {
  char name[96];
  std::snprintf(name, sizeof name, "depth%d-radius%.17g-format%u.prepared", key.depth,
                key.curvature_radius, version);
  return name;
}

std::string prepared_file_name(const PreparedKey& key) {
  return file_name_of_version(key, kPreparedFormatVersion);
}

std::optional<PreparedKey> parse_prepared_file_name(const std::string& name) {
  PreparedKey key;
  if (std::sscanf(name.c_str(), "depth%d-radius%lf", &key.depth, &key.curvature_radius) != 2)
    return std::nullopt;
  if (prepared_file_name(key) != name) return std::nullopt;
  return key;
}

std::optional<uint32_t> prepared_file_version(const std::string& name) {
  PreparedKey key;
  unsigned version = 0;
  if (std::sscanf(name.c_str(), "depth%d-radius%lf-format%u", &key.depth, &key.curvature_radius,
                  &version) != 3)
    return std::nullopt;
  if (file_name_of_version(key, version) != name) return std::nullopt;
  return version;
}

static std::string pages_file_name_of_version(uint32_t version) {
  return "pages-format" + std::to_string(version) + ".pages";
}

std::string pages_file_name() {
  return pages_file_name_of_version(kPageFormatVersion);
}

std::optional<uint32_t> pages_file_version(const std::string& name) {
  unsigned version = 0;
  if (std::sscanf(name.c_str(), "pages-format%u", &version) != 1) return std::nullopt;
  if (pages_file_name_of_version(version) != name) return std::nullopt;
  return version;
}

static Result<std::vector<PreparedInfo>> list_prepared(const fs::path& folder) {
  std::vector<PreparedInfo> found;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  if (error == std::errc::no_such_file_or_directory) return found;
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const auto key = parse_prepared_file_name(entry->path().filename().string());
    std::error_code gone;
    const uint64_t bytes = key ? entry->file_size(gone) : 0;
    if (key && !gone) found.push_back({*key, bytes});
  }
  if (error) return errno_status("cannot list " + folder.string(), error.value());
  std::sort(found.begin(), found.end(),
            [](const PreparedInfo& a, const PreparedInfo& b) { return a.key < b.key; });
  return found;
}

Result<ScanInfo> read_scan_folder(const fs::path& folder) {
  const auto text = FileContent::read(folder / "info.json");
  if (text.status().code() == StatusCode::kNotFound)
    return not_found("folder " + folder.string() + " does not hold a scan");
  RETURN_IF_ERROR(text.status());
  const auto bytes = text.value().bytes();
  ASSIGN_OR_RETURN(ScanInfo scan, scan_from_json({bytes.begin(), bytes.end()}));
  if (scan.id != folder.filename().string())
    return data_loss("info.json in " + folder.string() + " describes another scan");
  ASSIGN_OR_RETURN(scan.prepared, list_prepared(folder / "prepared"));
  return scan;
}

}  // namespace burnish
