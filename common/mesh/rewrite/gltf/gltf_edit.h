#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/document.h"
#include "common/mesh/output_buffer.h"

namespace burnish {

/// A file beside a .gltf file, with new bytes.
struct GltfFileBeside {
  std::string path;  ///< as the callback of open_gltf() got it
  std::vector<uint8_t> bytes;
};

/// Private to this folder. A glTF document that is changed: its JSON, bytes in its buffers, and
/// views behind them.
class GltfEdit {
 public:
  /// Needs: `document` and the bytes `original` that it was opened from outlive the edit.
  GltfEdit(const GltfDocument& document, std::span<const uint8_t> original);

  const GltfDocument& document() const { return document_; }
  GltfJson& json() { return json_; }

  /// Returns a buffer's bytes, to be changed.
  std::span<uint8_t> buffer(uint64_t index) { return edited(index); }

  /// Appends bytes to the first buffer and returns the number of their new view. `stride` is 0 for
  /// bytes that are not vertices'.
  uint64_t append_view(std::span<const uint8_t> bytes, uint64_t stride);

  /// Puts bytes into a view in the place of its own. Views behind them move if they need more room.
  /// Call last: accessors' bytes may lie elsewhere afterwards. Needs: a view that shares no bytes.
  void replace_view(uint64_t index, std::span<const uint8_t> bytes);

  /// Writes the file. Adds the files beside it that changed to `beside`. Fails: invalid_argument if
  /// a binary file would exceed 4 GiB.
  Status write(OutputBuffer& output, std::vector<GltfFileBeside>& beside);

 private:
  std::vector<uint8_t>& edited(uint64_t index);
  uint64_t buffer_to_extend() const;
  std::string json_text() const;
  void put_data_uris();
  Status write_binary(OutputBuffer& output);

  const GltfDocument& document_;
  std::span<const uint8_t> original_;
  GltfJson json_;
  std::map<uint64_t, std::vector<uint8_t>> edited_;
};

}  // namespace burnish
