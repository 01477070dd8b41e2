#pragma once

#include <cstddef>
#include <cstdint>

namespace burnish {

/// Every limit of the product, with its unit in its name. Limits are checked where a value enters:
/// in file readers, on the command line, on the wire.
inline constexpr int kDepthMin = 4;
inline constexpr int kDepthMax = 12;

inline constexpr uint64_t kTrianglesMax = uint64_t{1} << 31;
inline constexpr uint64_t kVerticesMax = uint64_t{1} << 31;
inline constexpr uint64_t kReadingBytesPerFileByte = 12;  // memory while a mesh file is read
inline constexpr size_t kArchiveEntriesMax = 10'000;
inline constexpr size_t kArchiveNameBytesMax = 1024;                           // of one entry
inline constexpr uint64_t kArchiveUnpackedBytesMax = uint64_t{16} << 30;       // of all entries
inline constexpr uint64_t kArchiveUnpackedPerByteMax = 100;                    // of the archive
inline constexpr uint64_t kArchiveUnpackedBytesInAnyCase = uint64_t{1} << 20;  // the ratio's floor
inline constexpr uint64_t kPictureBytesMax = uint64_t{512} << 20;              // of its file
inline constexpr uint64_t kPicturePixelsMax = uint64_t{1} << 28;               // 16384 x 16384
inline constexpr uint64_t kPicturePixelsPerByteMax = 1024;                     // of its file
inline constexpr uint64_t kPicturePixelsInAnyCase = uint64_t{1} << 24;         // that ratio's floor
inline constexpr uint64_t kMaterialFileBytesMax = uint64_t{16} << 20;
inline constexpr double kCoordinateMagnitudeMax = 1e18;  // file units; squares stay finite in float

inline constexpr size_t kGltfValuesMax = size_t{1} << 20;  // of a file's JSON
inline constexpr size_t kGltfMembersMax = 1024;  // of an object; it is searched from its begin
inline constexpr size_t kGltfDepthMax = 64;      // of a file's JSON
inline constexpr uint64_t kGltfUnpackedBytesMin = uint64_t{16} << 20;
inline constexpr uint64_t kGltfUnpackedBytesPerPackedByte = 256;  // Draco, meshopt

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
inline constexpr uint64_t kHistoryReserveBytes = uint64_t{1} << 20;  // for undo where it is full
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
