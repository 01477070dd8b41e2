#include <cstddef>
#include <cstdint>

#include "tests/fuzz/readers.h"

/// Compiled once per reader; BURNISH_FUZZ_READER names it.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const burnish::FuzzedReader& reader = burnish::fuzzed_reader(BURNISH_FUZZ_READER);
  reader.read({data, size});
  return 0;
}
