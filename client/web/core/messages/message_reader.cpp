#include <algorithm>
#include <optional>
#include <string_view>

#include "client/web/core/messages/message.h"
#include "client/web/core/messages/wire_type.h"
#include "common/base/text.h"

namespace burnish::messages {
namespace {

/// Takes values off the front of bytes. Nothing: the bytes end before the value does.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool at_end() const { return bytes_.empty(); }

  /// Bits above 64 are dropped. Nothing also: the value has more than `bytes_max` bytes.
  std::optional<uint64_t> varint(size_t bytes_max = 10) {
    uint64_t value = 0;
    for (size_t n = 0; n < std::min(bytes_max, bytes_.size()); ++n) {
      const auto byte = static_cast<uint8_t>(bytes_[n]);
      value |= uint64_t{byte & 0x7fu} << 7 * n;
      if (byte >= 0x80) continue;
      bytes_.remove_prefix(n + 1);
      return value;
    }
    return std::nullopt;
  }

  std::optional<uint64_t> little_endian(size_t count) {
    const auto part = piece(count);
    if (!part) return std::nullopt;
    uint64_t value = 0;
    for (size_t n = 0; n < count; ++n) value |= uint64_t{static_cast<uint8_t>((*part)[n])} << 8 * n;
    return value;
  }

  std::optional<std::string_view> piece(uint64_t count) {
    if (count > bytes_.size()) return std::nullopt;
    const std::string_view part = bytes_.substr(0, static_cast<size_t>(count));
    bytes_.remove_prefix(part.size());
    return part;
  }

  /// A piece with its size before it.
  std::optional<std::string_view> sized_piece() {
    const auto size = varint(5);
    return size ? piece(*size) : std::nullopt;
  }

 private:
  std::string_view bytes_;
};

std::optional<uint64_t> read_bits(Kind kind, ByteReader& reader) {
  if (wire_type(kind) == WireType::kEightBytes) return reader.little_endian(8);
  if (wire_type(kind) == WireType::kFourBytes) return reader.little_endian(4);
  const auto value = reader.varint();
  if (!value) return value;
  const auto low = static_cast<uint32_t>(*value);
  switch (kind) {
    case Kind::kBool:
      return *value != 0;
    case Kind::kInt32:
      return bits_of(static_cast<int32_t>(low));
    case Kind::kUint32:
      return low;
    case Kind::kSint32:
      return bits_of(static_cast<int32_t>(low >> 1 ^ (0 - (low & 1))));
    default:
      return value;
  }
}

bool pass_over(uint64_t wire_type, ByteReader& reader) {
  switch (wire_type) {
    case static_cast<uint64_t>(WireType::kVarint):
      return reader.varint().has_value();
    case static_cast<uint64_t>(WireType::kEightBytes):
      return reader.piece(8).has_value();
    case static_cast<uint64_t>(WireType::kBytes):
      return reader.sized_piece().has_value();
    case static_cast<uint64_t>(WireType::kFourBytes):
      return reader.piece(4).has_value();
    default:
      return false;
  }
}

}  // namespace

class MessageReader {
 public:
  explicit MessageReader(Message& message) : message_(message) {}

  bool read(std::string_view bytes) {
    ByteReader reader(bytes);
    while (!reader.at_end()) {
      const auto tag = reader.varint(5);
      if (!tag || !read_field(static_cast<uint32_t>(*tag) >> 3, *tag & 7, reader)) return false;
    }
    return true;
  }

 private:
  bool read_field(uint32_t number, uint64_t type, ByteReader& reader) {
    if (number == 0) return false;
    const auto fields = message_.type_->fields;
    const auto found = std::find_if(fields.begin(), fields.end(), [number](const Field& field) {
      return field.number == number;
    });
    if (found == fields.end()) return pass_over(type, reader);
    const Field& field = *found;
    const auto n = static_cast<size_t>(found - fields.begin());
    const auto own_type = wire_type(field.kind);
    if (type == static_cast<uint64_t>(own_type))
      return own_type == WireType::kBytes ? read_piece(field, n, reader)
                                          : read_number(field, n, reader);
    if (field.is_repeated && type == static_cast<uint64_t>(WireType::kBytes))
      return read_packed(field, n, reader);
    return pass_over(type, reader);
  }

  bool read_number(const Field& field, size_t n, ByteReader& reader) {
    const auto bits = read_bits(field.kind, reader);
    if (!bits) return false;
    if (field.is_repeated)
      message_.append_bits(n, *bits);
    else
      message_.put_bits(n, *bits);
    return true;
  }

  bool read_packed(const Field& field, size_t n, ByteReader& reader) {
    const auto piece = reader.sized_piece();
    if (!piece) return false;
    ByteReader packed(*piece);
    while (!packed.at_end())
      if (!read_number(field, n, packed)) return false;
    return true;
  }

  bool read_piece(const Field& field, size_t n, ByteReader& reader) {
    const auto piece = reader.sized_piece();
    if (!piece) return false;
    if (field.kind == Kind::kMessage)
      return MessageReader(field.is_repeated ? message_.append_message(n)
                                             : message_.edit_message(n))
          .read(*piece);
    if (field.kind == Kind::kString && !is_valid_utf8(*piece)) return false;
    (field.is_repeated ? message_.append_text(n) : message_.edit_text(n)) = *piece;
    return true;
  }

  Message& message_;
};

bool Message::ParseFromArray(const void* bytes, int size) {
  release();
  return MessageReader(*this).read({static_cast<const char*>(bytes), static_cast<size_t>(size)});
}

}  // namespace burnish::messages
