#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/check.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

static std::string rewrite_fuzzed(std::span<const uint8_t> bytes, const MovedMesh& moved) {
  std::string text;
  OutputBuffer output([&](std::string_view piece) {
    text += piece;
    return Status::ok();
  });
  const Status status =
      rewrite_mesh(bytes, MeshFormat::BURNISH_FUZZ_FORMAT, "fuzzed", moved, output);
  BURNISH_CHECK(status.is_ok(), status.message());
  return text;
}

/// An unmoved mesh must give the same bytes; a moved one must be written.
static void expect_rewritable(std::span<const uint8_t> bytes, TriangleMesh mesh) {
  const std::vector<Vec3d> before = mesh.vertices;
  const std::string same = rewrite_fuzzed(bytes, {before, mesh});
  BURNISH_CHECK(same.size() == bytes.size() &&
                    std::equal(same.begin(), same.end(), bytes.begin(),
                               [](char a, uint8_t b) { return static_cast<uint8_t>(a) == b; }),
                "an unmoved mesh is written differently");
  for (Vec3d& vertex : mesh.vertices) vertex = 0.5 * vertex.reverse() + Vec3d(1, 2, 3);
  rewrite_fuzzed(bytes, {before, mesh});
}

}  // namespace burnish

/// Compiled once per format; BURNISH_FUZZ_FORMAT names it. Any bytes must give a valid mesh or a
/// refusal that names the file. A valid mesh must be written again.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace burnish;
  const auto mesh = read_mesh({data, size}, MeshFormat::BURNISH_FUZZ_FORMAT, "fuzzed");
  if (mesh.is_ok()) {
    const Status valid = validate(*mesh);
    BURNISH_CHECK(valid.is_ok(), valid.message());
    expect_rewritable({data, size}, *mesh);
  } else {
    BURNISH_CHECK(mesh.status().message().starts_with("fuzzed: "), mesh.status().message());
  }
  return 0;
}
