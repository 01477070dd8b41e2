#include "server/library/scan_record.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "common/base/file_content.h"
#include "common/pages/page_format.h"
#include "common/sheets/sheet_format.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/kept/hierarchy_file.h"

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
  json j = {{"box_min", point_to_json(s.box_min)}, {"box_max", point_to_json(s.box_max)}};
  add_fields(s, j);
  return j;
}

static MeshStatistics statistics_from_json(const json& j) {
  MeshStatistics s;
  take_fields(j, s);
  s.box_min = point_from_json(j.at("box_min"));
  s.box_max = point_from_json(j.at("box_max"));
  return s;
}

std::string scan_to_json(const ScanInfo& scan) {
  json j = {{"format", mesh_format_name(scan.format)},
            {"statistics", statistics_to_json(scan.statistics)}};
  add_fields(scan, j);
  return j.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<ScanInfo> scan_from_json(const std::string& text) try {
  json j = json::parse(text);
  j.emplace("unit", "");  // scans of earlier versions have none
  ScanInfo scan;
  take_fields(j, scan);
  ASSIGN_OR_RETURN(scan.format, mesh_format_of_name(j.at("format").get<std::string>()));
  scan.statistics = statistics_from_json(j.at("statistics"));
  return scan;
} catch (const json::exception& error) {
  return data_loss(std::string("info.json is damaged: ") + error.what());
}

std::string original_file_name(MeshFormat format) {
  return "original." + std::string(mesh_format_name(format));
}

static std::string file_name_of_version(const PreparedKey& key, uint32_t version,
                                        const std::string& kind) {
  char name[96];
  std::snprintf(name, sizeof name, "depth%d-radius%.17g-format%u.", key.depth, key.curvature_radius,
                version);
  return name + kind;
}

std::string prepared_file_name(const PreparedKey& key) {
  return file_name_of_version(key, kPreparedFormatVersion, "prepared");
}

std::string hierarchy_file_name(const PreparedKey& key) {
  return file_name_of_version(key, kHierarchyFormatVersion, "hierarchy");
}

std::optional<PreparedKey> parse_prepared_file_name(const std::string& name) {
  PreparedKey key;
  if (std::sscanf(name.c_str(), "depth%d-radius%lf", &key.depth, &key.curvature_radius) != 2)
    return std::nullopt;
  if (prepared_file_name(key) != name) return std::nullopt;
  return key;
}

static std::optional<uint32_t> version_with_key(const std::string& name, const std::string& kind) {
  PreparedKey key;
  unsigned version = 0;
  if (std::sscanf(name.c_str(), "depth%d-radius%lf-format%u", &key.depth, &key.curvature_radius,
                  &version) != 3)
    return std::nullopt;
  if (file_name_of_version(key, version, kind) != name) return std::nullopt;
  return version;
}

std::optional<uint32_t> prepared_file_version(const std::string& name) {
  return version_with_key(name, "prepared");
}

std::optional<uint32_t> hierarchy_file_version(const std::string& name) {
  return version_with_key(name, "hierarchy");
}

// E.g. "pages-format1.pages".
static std::string versioned_name(const std::string& kind, uint32_t version) {
  return kind + "-format" + std::to_string(version) + "." + kind;
}

static std::optional<uint32_t> version_in(const std::string& name, const std::string& kind) {
  const std::string begin = kind + "-format";
  unsigned version = 0;
  if (!name.starts_with(begin)) return std::nullopt;
  if (std::sscanf(name.c_str() + begin.size(), "%u", &version) != 1) return std::nullopt;
  if (versioned_name(kind, version) != name) return std::nullopt;
  return version;
}

static std::string textured_pages_name(uint32_t format, uint32_t cut) {
  return "pages-format" + std::to_string(format) + "-texels" + std::to_string(cut) + ".pages";
}

std::string pages_file_name(bool may_have_pictures) {
  return may_have_pictures ? textured_pages_name(kPageFormatVersion, kTexelCutVersion)
                           : versioned_name("pages", kPageFormatVersion);
}

std::optional<uint32_t> pages_file_version(const std::string& name) {
  unsigned format = 0, cut = 0;
  if (std::sscanf(name.c_str(), "pages-format%u-texels%u", &format, &cut) != 2)
    return version_in(name, "pages");
  if (textured_pages_name(format, cut) != name) return std::nullopt;
  return cut == kTexelCutVersion ? format : 0;
}

static std::string sheets_name(uint32_t format, uint64_t seams) {
  if (seams == 0) return versioned_name("sheets", format);
  char text[80];
  std::snprintf(text, sizeof text, "sheets-format%u-seams%016" PRIx64 ".sheets", format, seams);
  return text;
}

namespace {

struct SheetsName {
  uint32_t format = 0;
  uint64_t seams = 0;
};

std::optional<SheetsName> parse_sheets_name(const std::string& name) {
  SheetsName parsed;
  unsigned format = 0;
  if (std::sscanf(name.c_str(), "sheets-format%u-seams%16" SCNx64, &format, &parsed.seams) < 1)
    return std::nullopt;
  parsed.format = format;
  if (sheets_name(parsed.format, parsed.seams) != name) return std::nullopt;
  return parsed;
}

}  // namespace

std::string sheets_file_name(uint64_t seams) {
  return sheets_name(kSheetFormatVersion, seams);
}

std::optional<uint64_t> seams_in_sheets_file_name(const std::string& name) {
  const auto parsed = parse_sheets_name(name);
  if (!parsed || parsed->seams == 0 || parsed->format != kSheetFormatVersion) return std::nullopt;
  return parsed->seams;
}

std::optional<uint32_t> sheets_file_version(const std::string& name) {
  const auto parsed = parse_sheets_name(name);
  return parsed ? std::optional(parsed->format) : std::nullopt;
}

// Returns 0 for a missing file: a hierarchy is written some time after its prepared mesh, or never.
static uint64_t bytes_of_hierarchy(const fs::path& folder, const PreparedKey& key) {
  std::error_code missing;
  const uint64_t bytes = fs::file_size(folder / hierarchy_file_name(key), missing);
  return missing ? 0 : bytes;
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
    if (key && !gone) found.push_back({*key, bytes + bytes_of_hierarchy(folder, *key)});
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
