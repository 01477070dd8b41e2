#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/base/record.h"
#include "common/edit/edit.h"
#include "common/measure/deviation.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/statistics/thin_walls.h"
#include "common/service/scan_info.h"

namespace burnish {

/// Which session to open; an empty name lets the server choose one.
struct SessionWish {
  std::string scan;  ///< name, id, or the beginning of one id
  std::string name;
  PreparedKey key;
};
BURNISH_RECORD(SessionWish, scan, name, key)

struct SessionInfo {
  std::string id;
  std::string name;
  std::string scan_id;
  PreparedKey key;
  int64_t created_unix_seconds = 0;
  uint64_t edits = 0;
  bool in_memory = false;
};
BURNISH_RECORD(SessionInfo, id, name, scan_id, key, created_unix_seconds, edits, in_memory)

struct OpenedSession {
  SessionInfo session;
  bool attached = false;  ///< it was there already
};

/// The outcome of a batch of edits.
struct ApplyOutcome {
  uint32_t applied = 0;
  uint32_t known = 0;  ///< their ids had been applied before
  uint64_t edits = 0;  ///< of the session now
  /// For each edit of the batch the history entry that it made or switched; 0: none, or known.
  std::vector<uint64_t> entries;
};
BURNISH_RECORD(ApplyOutcome, applied, known, edits, entries)

struct SessionState {
  SessionInfo session;
  Settings settings;
  int cycles = 0;  ///< since the session came into memory; 0: the three figures mean nothing
  double energy = 0;
  double residual = 0;
  double distance = 0;  ///< estimated, over the bounding-box diagonal
  uint64_t memory_bytes = 0;
  std::string backend;
  uint64_t rims = 0;       ///< of the scan, while the controls pin them
  uint64_t rims_held = 0;  ///< of these
  ThinWalls walls;         ///< of the scan at this depth
};
BURNISH_RECORD(SessionState, cycles, energy, residual, distance, memory_bytes, backend, rims,
               rims_held)

/// A value of a cell of the finest depth. α and κ in user units.
enum class CellValue {
  kBeta,
  kKappa1,
  kKappa2,
  kAlpha1,
  kAlpha2,
  kProtected,  ///< 1 in the protected region, else 0
  kCurve,      ///< number of the palette's curve that rules most, from 1; 0: the session's own
};

inline constexpr int kExportCyclesMax = 10'000;

/// An export to make: converged to the bar of a live session unless told otherwise.
struct ExportWish {
  MeshFormat format = MeshFormat::kPly;
  bool exact = false;       ///< to the export bar
  int cycles = 0;           ///< > 0: exactly so many
  bool deviation = false;   ///< the summary says how far the surface moved
  bool with_files = false;  ///< an archive with the files beside the mesh, if it has this format
};

struct ExportSummary {
  uint64_t size_bytes = 0;
  std::string sha256;
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  int cycles = 0;
  bool converged = false;
  double energy = 0;
  double residual = 0;
  double distance = 0;  ///< estimated, over the bounding-box diagonal
  double assemble_seconds = 0;
  double solve_seconds = 0;
  std::vector<std::string> left_out;  ///< attributes of the scan's file that the format leaves out
  uint64_t edits = 0;                 ///< of the session, in the exported surface
  std::optional<Deviation> deviation;
  bool is_archive = false;  ///< as the wish for files asks
  double volume = 0;        ///< over the scan's, if the controls keep it; else 0
  std::string lost_volume;  ///< why it is not the scan's, in words for users; empty: it is
  std::string pictures;     ///< what became of those with edited colours, in words; empty: none
};
BURNISH_RECORD(ExportSummary, size_bytes, sha256, vertices, triangles, cycles, converged, energy,
               residual, distance, assemble_seconds, solve_seconds, left_out, pictures)

}  // namespace burnish
