#include "common/mesh/rewrite/patch/byte_patch.h"

#include "common/base/check.h"

namespace burnish {

BytePatch::BytePatch(std::span<const uint8_t> original, OutputBuffer& output)
    : rest_(reinterpret_cast<const char*>(original.data()), original.size()), output_(output) {}

void BytePatch::replace(std::string_view piece, std::string_view text) {
  BURNISH_CHECK(
      piece.data() >= rest_.data() && piece.data() + piece.size() <= rest_.data() + rest_.size(),
      "a piece lies outside the bytes that are left");
  const auto before = static_cast<size_t>(piece.data() - rest_.data());
  output_.put_text(rest_.substr(0, before));
  output_.put_text(text);
  rest_.remove_prefix(before + piece.size());
}

void BytePatch::finish() {
  output_.put_text(rest_);
  rest_ = {};
}

}  // namespace burnish
