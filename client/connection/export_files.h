#pragma once

#include <filesystem>
#include <string>

#include "client/connection/connection.h"

namespace burnish {

/// The target of an export: a file, whose extension says the format, or a folder. A scan that came
/// as an archive goes into a folder as it came; its mesh in its own format takes the files beside
/// it along. Any other scan goes into a folder as one file of its name.
struct ExportTarget {
  std::filesystem::path path;
  bool is_folder = false;
  MeshFormat format = MeshFormat::kPly;  ///< of a file
  bool replaces = false;                 ///< files beside the mesh that are there with other bytes
};

/// Reads a target: a path that ends in '/' or is a folder, or the path of a mesh file. Fails:
/// invalid_argument (extension); as the place cannot be written.
Result<ExportTarget> export_target(const std::filesystem::path& path, bool replaces);

/// The outcome of an export.
struct ExportedFiles {
  std::filesystem::path mesh;  ///< the file that was written, or the folder's mesh or archive
  ExportSummary summary;       ///< size and hash are those of `mesh`
};

/// Solves on the server and writes the edited scan to the target. `wish.format` is set here.
/// Fails: already_exists naming a file beside the mesh; as Connection::export_mesh().
Result<ExportedFiles> export_files(Connection& connection, const std::string& session,
                                   ExportWish wish, const ExportTarget& target,
                                   const Progress& progress);

}  // namespace burnish
