#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// Returns a scan's info.json: all of ScanInfo except the prepared meshes, which are the files in
/// its folder.
std::string scan_to_json(const ScanInfo& scan);

/// Fails: data_loss that names a field that is missing or has a wrong type.
Result<ScanInfo> scan_from_json(const std::string& text);

/// Returns e.g. "original.ply".
std::string original_file_name(MeshFormat format);

/// Returns e.g. "depth7-radius0-format2.prepared": the key and the version of the file format.
std::string prepared_file_name(const PreparedKey& key);

/// Returns the key in such a name; nothing for other names and other versions.
std::optional<PreparedKey> parse_prepared_file_name(const std::string& name);

/// Returns the version in such a name; nothing for other names.
std::optional<uint32_t> prepared_file_version(const std::string& name);

/// Returns e.g. "depth7-radius0-format1.hierarchy", with the version of the hierarchy file.
std::string hierarchy_file_name(const PreparedKey& key);

/// Returns the version in such a name; nothing for other names.
std::optional<uint32_t> hierarchy_file_version(const std::string& name);

/// Counts up whenever pages of scans with pictures end elsewhere: older ones are made again.
inline constexpr uint32_t kTexelCutVersion = 2;

/// Returns "pages-format1.pages", with the version of the page file, or of a scan that may have
/// pictures "pages-format1-texels2.pages", with kTexelCutVersion too.
std::string pages_file_name(bool may_have_pictures = false);

/// Returns the version in such a name, 0 for another kTexelCutVersion; nothing for other names.
std::optional<uint32_t> pages_file_version(const std::string& name);

/// Returns "sheets-format1.sheets", with the version of the sheet file, or of levelled sheets
/// "sheets-format1-seams00000000000000ff.sheets". `seams`: seams_version(); 0: the scan's own.
std::string sheets_file_name(uint64_t seams = 0);

/// Returns the version of levelled sheets in such a name of this format; nothing for other names.
std::optional<uint64_t> seams_in_sheets_file_name(const std::string& name);

/// Returns the version of the sheet file in such a name; nothing for other names.
std::optional<uint32_t> sheets_file_version(const std::string& name);

/// Reads a scan's folder: info.json, and the prepared files by name. Fails: not_found, data_loss;
/// as errno says.
Result<ScanInfo> read_scan_folder(const std::filesystem::path& folder);

}  // namespace burnish
