#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/document.h"

namespace burnish {

/// The bytes of a buffer view, unpacked if they are compressed.
struct GltfView {
  std::span<const uint8_t> bytes;
  uint64_t stride = 0;  ///< of its elements in bytes; 0: they follow each other
  uint64_t buffer = 0;
  uint64_t offset = 0;  ///< in the buffer
  bool is_packed = false;
};

/// Gives access to a document's buffer views, and unpacks each compressed one once. Counts what
/// reading makes of the file, so that a small file cannot fill the memory.
class UnpackedViews {
 public:
  /// Needs: the document outlives it, and the steps' budget.
  explicit UnpackedViews(const GltfDocument& document, const FileSteps& steps = {})
      : document_(document), steps_(steps) {}

  const GltfDocument& document() const { return document_; }

  /// Hear of each corner and position that a reader looks at.
  FileSteps& steps() { return steps_; }

  /// Fails: invalid_argument if the view does not exist, leaves its buffer or does not unpack.
  Result<GltfView> view(uint64_t index, const std::string& place);

  /// Counts bytes that are made of the file. Fails: invalid_argument beyond
  /// GltfDocument::reading_bytes_max.
  Status charge(uint64_t bytes);

 private:
  Result<GltfView> raw_view(const GltfJson& json, const std::string& place) const;
  Result<GltfView> unpack(uint64_t index, const GltfJson& packed, const std::string& place);

  const GltfDocument& document_;
  FileSteps steps_;
  std::map<uint64_t, std::vector<uint8_t>> unpacked_;
  uint64_t charged_bytes_ = 0;
};

}  // namespace burnish
