#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// A scan's info.json: everything of ScanInfo but the prepared meshes, which are what is there.
std::string scan_to_json(const ScanInfo& scan);

/// Fails: data_loss naming what is missing or of the wrong kind.
Result<ScanInfo> scan_from_json(const std::string& text);

/// "original.ply"
std::string original_file_name(MeshFormat format);

/// "depth7-radius0-format2.prepared": the key and the version of the file format.
std::string prepared_file_name(const PreparedKey& key);

/// The key in such a name; nothing for other names and other versions.
std::optional<PreparedKey> parse_prepared_file_name(const std::string& name);

/// The version in such a name; nothing for other names.
std::optional<uint32_t> prepared_file_version(const std::string& name);

/// Returns "pages-format1.pages", with the version of the page file.
std::string pages_file_name();

/// Returns the version in such a name; nothing for other names.
std::optional<uint32_t> pages_file_version(const std::string& name);

/// Reads a scan's folder: info.json, and the prepared files by name.
/// Fails: not_found, data_loss; as errno says, where they cannot be read.
Result<ScanInfo> read_scan_folder(const std::filesystem::path& folder);

}  // namespace burnish
