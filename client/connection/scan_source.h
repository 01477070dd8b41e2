#pragma once

#include <cstdint>
#include <string_view>

#include "common/base/status.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// The bytes of a scan that is uploaded.
class ScanSource {
 public:
  ScanSource() = default;
  virtual ~ScanSource() = default;
  ScanSource(const ScanSource&) = delete;
  ScanSource& operator=(const ScanSource&) = delete;

  virtual MeshFormat format() const = 0;
  virtual uint64_t size_bytes() const = 0;
  /// Returns bytes that are valid until the next call. Needs: the range is within size_bytes().
  /// Fails: as reading does.
  virtual Result<std::string_view> read(uint64_t offset, size_t bytes) = 0;
};

}  // namespace burnish
