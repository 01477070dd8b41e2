#pragma once

#include <filesystem>
#include <string>

#include "common/base/status.h"
#include "common/service/scan_info.h"

namespace burnish {

/// Reads a scan's stored original through and compares its SHA-256 with the scan's id.
/// Fails: data_loss naming the file and what to do, also when it is gone.
Status check_original(const std::filesystem::path& folder, const ScanInfo& scan);

/// Puts a good file in the place of a damaged original. What was prepared goes with the damage: it
/// may have been made from it.
Status replace_original(const std::filesystem::path& folder, const ScanInfo& scan,
                        const std::filesystem::path& good);

/// Moves a complete scan's folder into its place. Where a damaged one is, its files are replaced,
/// and those of its prepared files stay that this one does not bring.
Status put_scan_in_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace burnish
