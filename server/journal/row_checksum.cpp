#include "server/journal/row_checksum.h"

#include <bit>
#include <xxhash.h>

#include "common/base/check.h"

namespace burnish {

static_assert(std::endian::native == std::endian::little, "journals move between machines");

// The types' numbers are SQLite's.
enum class ValueType : uint8_t { kInteger = 1, kReal = 2, kText = 3, kBytes = 4, kNull = 5 };

void RowChecksum::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

RowChecksum::RowChecksum() : state_(XXH3_createState()) {
  BURNISH_CHECK(state_ != nullptr, "no memory for a checksum");
  XXH3_128bits_reset(state_.get());
}

template <typename T>
void RowChecksum::add_raw(const T& value) {
  XXH3_128bits_update(state_.get(), &value, sizeof value);
}

void RowChecksum::add(int64_t value) {
  add_raw(ValueType::kInteger);
  add_raw(value);
}

void RowChecksum::add(double value) {
  add_raw(ValueType::kReal);
  add_raw(value + 0.0);
}

void RowChecksum::add(std::string_view bytes) {
  add_raw(ValueType::kBytes);
  add_sized(bytes);
}

void RowChecksum::add_text(std::string_view text) {
  add_raw(ValueType::kText);
  add_sized(text);
}

void RowChecksum::add_sized(std::string_view bytes) {
  add_raw(uint64_t{bytes.size()});
  if (!bytes.empty()) XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
}

void RowChecksum::add_null() {
  add_raw(ValueType::kNull);
}

std::string RowChecksum::take() {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state_.get()));
  XXH3_128bits_reset(state_.get());
  return {reinterpret_cast<const char*>(bytes.digest), sizeof bytes.digest};
}

}  // namespace burnish
