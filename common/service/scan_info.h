#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/record.h"
#include "common/base/status.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/statistics/statistics.h"
#include "common/mesh/statistics/thin_walls.h"

namespace burnish {

/// Identifies a prepared mesh of a scan.
struct PreparedKey {
  int depth = 0;                ///< 0: the scan's default depth
  double curvature_radius = 0;  ///< averaging radius for κ as a fraction of L
  auto operator<=>(const PreparedKey&) const = default;
};
BURNISH_RECORD(PreparedKey, depth, curvature_radius)

/// One prepared mesh that the server keeps.
struct PreparedInfo {
  PreparedKey key;
  uint64_t size_bytes = 0;  ///< of its file
};
BURNISH_RECORD(PreparedInfo, key, size_bytes)

/// A scan of the library.
struct ScanInfo {
  std::string id;  ///< SHA-256 of the imported file
  std::string name;
  MeshFormat format = MeshFormat::kPly;
  uint64_t size_bytes = 0;  ///< of the imported file
  int64_t imported_unix_seconds = 0;
  int default_depth = 0;
  bool has_colours = false;
  MeshStatistics statistics;
  std::vector<PreparedInfo> prepared;  ///< by depth
  std::string unit;                    ///< of the coordinates: "mm"; empty: nobody named it
};
BURNISH_RECORD(ScanInfo, id, name, size_bytes, imported_unix_seconds, default_depth, has_colours,
               unit)

/// Describes a prepared mesh to clients.
struct PreparedDescription {
  PreparedKey key;
  double length_unit = 0;        ///< L, file units
  double cell_size = 0;          ///< file units
  uint64_t cells = 0;            ///< of the finest depth
  uint64_t memory_bytes = 0;     ///< shared by its sessions
  float histogram_range = 0;     ///< bins are even in asinh(κ) from -range to range, user units
  std::vector<float> histogram;  ///< fraction of the area
  ThinWalls walls;
};
BURNISH_RECORD(PreparedDescription, key, length_unit, cell_size, cells, memory_bytes)

struct ScanDescription {
  ScanInfo scan;
  std::optional<PreparedDescription> prepared;
};

/// A client's announcement of a file before it sends it.
struct ImportHeader {
  std::string name;
  MeshFormat format = MeshFormat::kPly;
  uint64_t size_bytes = 0;
  std::string sha256;  ///< empty, or the hash of the bytes that follow
  PreparedKey key;
  bool exact_name = false;  ///< refuses a name that is not free; else it is changed
};
BURNISH_RECORD(ImportHeader, name, size_bytes, sha256, key, exact_name)

/// The result of an import.
struct ImportOutcome {
  ScanInfo scan;
  bool already_present = false;
};

inline constexpr size_t kEditIdBytesMax = 64;

inline constexpr size_t kUnitBytesMax = 16;

/// Checks the name of a scan's unit: "" or up to kUnitBytesMax bytes as check_name() wants them.
/// Fails: invalid_argument.
Status check_unit(std::string_view unit);

/// The fewest digits of an id that are a reference. A name is not so many hexadecimal digits.
inline constexpr size_t kIdBeginDigits = 4;

/// The number of digits of an id that are shown to users.
inline constexpr size_t kShortIdDigits = 12;
inline std::string short_id(std::string_view id) {
  return std::string(id.substr(0, kShortIdDigits));
}

}  // namespace burnish
