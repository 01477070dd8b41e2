#include <vector>

#include "server/prepare/prepare.h"
#include "server/solver/kept/hierarchy_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/readers.h"
#include "tests/server/solver/kept/sealed_hierarchy.h"

namespace burnish {

namespace {

constexpr int kFuzzedDepth = 4;
constexpr uint64_t kFuzzedFingerprint = 1;

/// A narrow triangle. Its grid has one depth.
const std::shared_ptr<const PreparedMesh>& sliver() {
  static const std::shared_ptr<const PreparedMesh> prepared = [] {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0.1}, {0.9, 0.05, 0.1}};
    mesh.triangles = {{0, 1, 2}};
    return prepare(mesh, {.depth = kFuzzedDepth}).value();
  }();
  return prepared;
}

}  // namespace

bool read_fuzzed_hierarchy(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> sealed(bytes.begin(), bytes.end());
  seal_hierarchy(sealed);
  return read_hierarchy(MemoryFile(sealed).path(), sliver(), kFuzzedFingerprint).is_ok();
}

}  // namespace burnish
