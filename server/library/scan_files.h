#pragma once

#include <filesystem>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// Moves a file or a folder within a file system. Fails with a message that names both paths.
Status move_path(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes the folder of a scan's prepared files if it is missing, and the scan's folder, which is
/// for this user alone.
Status make_prepared_folder(const std::filesystem::path& scan);

/// Reads a scan's stored original and compares its SHA-256 with the scan's id. Fails: data_loss if
/// it differs or is missing; the message names the file and the remedy; cancelled.
Status check_original(const std::filesystem::path& folder, const ScanInfo& scan,
                      const Progress& progress);

/// Puts a good file in the place of a damaged original. Deletes the prepared files: they may have
/// been made from the damage.
Status replace_original(const std::filesystem::path& folder, const ScanInfo& scan,
                        const std::filesystem::path& good);

/// Moves a complete scan's folder into its place. If a damaged folder is there, replaces its files;
/// prepared files that are not in `from` stay.
Status put_scan_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace burnish
