#pragma once

#include <cstddef>
#include <cstdint>

namespace burnish {

/// Every limit of the product, with its unit in its name. Limits are checked where a value enters:
/// in file readers, on the command line, on the wire.
inline constexpr int kDepthMin = 4;
inline constexpr int kDepthMax = 12;
inline constexpr int kDefaultDepthMax = 9;

inline constexpr uint64_t kTrianglesMax = uint64_t{1} << 31;
inline constexpr uint64_t kVerticesMax = uint64_t{1} << 31;
inline constexpr uint64_t kReadingBytesPerFileByte = 12;  // memory while a mesh file is read
inline constexpr double kCoordinateMagnitudeMax = 1e18;  // file units; squares stay finite in float

inline constexpr double kCurvatureRadiusMin = 1e-4;  // of L; smaller averages nothing: use 0
inline constexpr double kCurvatureRadiusMax = 0.2;
inline constexpr size_t kPreparedPerScanMax = 16;
inline constexpr uint64_t kDiskReserveBytes = uint64_t{256} << 20;  // for the journal

inline constexpr double kAlphaMin = 0.01;  // user units (alpha * L)
inline constexpr double kAlphaMax = 1e5;
inline constexpr double kAlphaDefault = 50;

inline constexpr double kBetaMin = 0;
inline constexpr double kBetaMax = 10;
inline constexpr double kBetaDefault = 1;

inline constexpr size_t kCurvePointsMax = 64;
inline constexpr double kCurveContrastMax = 1000;
inline constexpr double kCurveContrastWarn = 100;
inline constexpr double kCurveKappaMagnitudeMax = 1e9;  // user units (kappa * L)

inline constexpr size_t kBandsMax = 6;        // of an equaliser
inline constexpr double kBandRatioMin = 1.2;  // of the sizes of neighbouring bands
inline constexpr double kGainMin = 0;
inline constexpr double kGainMax = 10;
inline constexpr size_t kPaletteCurvesMax = 8;

inline constexpr size_t kStrokeDabsMax = 4096;
inline constexpr size_t kEditsPerFrameMax = 64;
inline constexpr size_t kNameBytesMax = 200;     // of scans, sessions, users, checkpoints
inline constexpr size_t kSessionRolesMax = 256;  // users with their own role
inline constexpr size_t kCellFieldsPerEditMax = size_t{1} << 22;

inline constexpr size_t kPageVerticesMax = 2048;
inline constexpr size_t kPageTrianglesMax = 4096;
inline constexpr int kPageGridBitsMax = 24;  // floats hold such integers exactly
inline constexpr int kPageLevelsMax = 64;
inline constexpr size_t kShownPagesMax = 4096;   // of one client
inline constexpr uint32_t kPagesMax = 1u << 24;  // of a scan
inline constexpr uint32_t kPagesPerBlock = 256;  // of the directory
inline constexpr uint32_t kCoarserPerBlockMax = 1u << 14;
inline constexpr uint32_t kPageBytesMax = 1u << 18;  // encoded
inline constexpr uint32_t kPageSlotsMax = 1u << 18;  // on the graphics card

inline constexpr int kImageSidePixelsMin = 16;
inline constexpr int kImageSidePixelsMax = 8192;

}  // namespace burnish
