#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/unpacked_views.h"

namespace burnish {

/// The types of numbers, as glTF numbers them.
enum class GltfComponent : uint32_t {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

size_t component_bytes(GltfComponent component);

/// The shape of an accessor's elements.
struct GltfElement {
  GltfComponent component = GltfComponent::kFloat;
  uint32_t components = 1;  ///< 1 to 4
  bool is_normalized = false;

  size_t bytes() const { return components * component_bytes(component); }
  bool operator==(const GltfElement&) const = default;
};

/// The place of an accessor's unpacked elements in a buffer, so that they can be replaced there.
struct GltfRange {
  uint64_t buffer = 0;
  uint64_t offset = 0;
};

/// Stands for an accessor that the document does not have.
inline constexpr uint64_t kNoAccessor = UINT64_MAX;

/// Numbers by element. Its bytes belong to the document, to its views or to `made`.
struct GltfAccessor {
  uint64_t index = kNoAccessor;  ///< in the document
  uint64_t count = 0;
  GltfElement element;
  uint64_t stride = 0;  ///< bytes
  std::span<const uint8_t> bytes;
  std::optional<GltfRange> range;                    ///< empty: packed, sparse, or without a view
  std::shared_ptr<const std::vector<uint8_t>> made;  ///< elements that are nowhere in the file

  /// Returns a component as a float; normalized integers are within -1..1. Needs: in range.
  float number(uint64_t i, uint32_t component) const;

  /// Returns an unsigned integer. Needs: in range; one of the unsigned types.
  uint32_t whole(uint64_t i) const;
};

/// Reads the shape and the count of an accessor, without its bytes. Fails: invalid_argument for
/// matrices and unknown types.
Result<GltfAccessor> read_accessor_shape(const GltfDocument& document, uint64_t index,
                                         const std::string& place);

/// Reads an accessor and checks that all its bytes exist. Fails: invalid_argument.
Result<GltfAccessor> read_accessor(UnpackedViews& views, uint64_t index, const std::string& place);

/// Takes tightly packed elements for an accessor's.
void set_made_bytes(GltfAccessor& accessor, std::vector<uint8_t> bytes);

}  // namespace burnish
