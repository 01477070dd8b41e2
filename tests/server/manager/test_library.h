#pragma once

#include <memory>
#include <string>

#include "server/library/mesh_store.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

/// A store in the test's own folder.
class TestLibrary {
 public:
  explicit TestLibrary(const MeshStoreOptions& options = {});

  /// Imports the bytes of a file through an upload.
  Result<ImportOutcome> import(const std::string& bytes, const std::string& name,
                               const Progress& progress = {}, int depth = 5,
                               MeshFormat format = MeshFormat::kPly);

  /// Closes and opens everything again, like a new server.
  void restart();
  void restart(const MeshStoreOptions& other) {
    options = other;
    restart();
  }

  /// Returns the number of names in the staging folder.
  size_t staged_files() const;

  TemporaryFolder root;
  MeshStoreOptions options;
  std::unique_ptr<DataFolder> folder;
  std::unique_ptr<MeshStore> store;
};

/// Returns the bytes of a PLY file.
std::string mesh_file(const TriangleMesh& mesh);

/// Returns a sphere as the bytes of a PLY file: 642 vertices at level 3.
std::string sphere_file(double radius = 1, int level = 3);

}  // namespace burnish
