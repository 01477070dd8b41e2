#include <cstddef>
#include <cstdint>

#include "common/base/check.h"
#include "common/mesh/mesh_io.h"

/// Compiled once per format; BURNISH_FUZZ_FORMAT names it. Any bytes must give a valid mesh or a
/// refusal that names the file.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace burnish;
  const auto mesh = read_mesh({data, size}, MeshFormat::BURNISH_FUZZ_FORMAT, "fuzzed");
  if (mesh.is_ok()) {
    const Status valid = validate(*mesh);
    BURNISH_CHECK(valid.is_ok(), valid.message());
  } else {
    BURNISH_CHECK(mesh.status().message().starts_with("fuzzed: "), mesh.status().message());
  }
  return 0;
}
