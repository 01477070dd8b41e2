#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

#include "common/pages/page_file.h"
#include "common/sheets/sheet_file.h"
#include "server/prepare/sheets/build_sheets.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {

/// Makes the pages of a textured scan, as a library does. Returns the open page file.
PageFile pages_of_archive(std::span<const uint8_t> zip, const std::filesystem::path& path);

/// Makes pages that do not end for the texels of pictures.
PageFile full_pages_of_archive(std::span<const uint8_t> zip, const std::filesystem::path& path);

/// Makes its sheets beside them.
Result<bool> build_sheets_of_archive(std::span<const uint8_t> zip, const PageFile& pages,
                                     const std::filesystem::path& path,
                                     const SheetsOptions& options = {},
                                     const Progress& progress = {}, SheetsReport* report = nullptr);

/// Returns the colour of a pattern at a place; nothing where it does not count.
using ColourAt = std::function<std::optional<Rgba8>(const Vec3d& position)>;

/// Returns the peak signal-to-noise ratio of the finest sheets of a level, sampled bilinearly at
/// random places of its pages and weighted by area, to a pattern there; dB.
double psnr_of_level(const ColourAt& pattern, const PageFile& pages, const SheetFile& sheets,
                     int level);
/// The same to the pattern of a ball.
double psnr_of_level(const PaintedBall& ball, const PageFile& pages, const SheetFile& sheets,
                     int level);

/// Returns the colour that the finest sheets of level 0 show at (x, y), seen along z; 0 to 255.
/// Needs: a triangle there.
Vec3d colour_above(const PageFile& pages, const SheetFile& sheets, double x, double y);

/// Opens a sheet file beside its pages. Ends the program if it is not good.
SheetFile open_sheets(const std::filesystem::path& path, const PageFile& pages);

}  // namespace burnish
