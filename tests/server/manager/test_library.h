#pragma once

#include <memory>
#include <string>

#include "server/library/mesh_store.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

/// A store in a folder of the test's own.
class TestLibrary {
 public:
  explicit TestLibrary(const MeshStoreOptions& options = {});

  /// Imports the bytes of a file by way of an upload in one chunk.
  Result<ImportOutcome> import(const std::string& bytes, const std::string& name,
                               const Progress& progress = {}, int depth = 5);

  /// Closes and opens everything again, as a new server would.
  void restart();
  void restart(const MeshStoreOptions& other) {
    options = other;
    restart();
  }

  /// Names in the staging folder.
  size_t staged_files() const;

  TemporaryFolder root;
  MeshStoreOptions options;
  std::unique_ptr<DataFolder> folder;
  std::unique_ptr<MeshStore> store;
};

/// The bytes of a PLY file.
std::string mesh_file(const TriangleMesh& mesh);

/// A sphere as the bytes of a PLY file: at level 3, 642 vertices.
std::string sphere_file(double radius = 1, int level = 3);

}  // namespace burnish
