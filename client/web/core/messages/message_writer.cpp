#include "client/web/core/messages/message.h"
#include "client/web/core/messages/wire_type.h"

namespace burnish::messages {
namespace {

void append_varint(uint64_t value, std::string& bytes) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<char>(value | 0x80));
  bytes.push_back(static_cast<char>(value));
}

void append_little_endian(uint64_t value, int count, std::string& bytes) {
  for (int n = 0; n < count; ++n) bytes.push_back(static_cast<char>(value >> 8 * n));
}

void append_number(Kind kind, uint64_t bits, std::string& bytes) {
  if (wire_type(kind) == WireType::kEightBytes) return append_little_endian(bits, 8, bytes);
  if (wire_type(kind) == WireType::kFourBytes) return append_little_endian(bits, 4, bytes);
  if (kind == Kind::kSint32)
    bits =
        static_cast<uint32_t>(bits << 1) ^ static_cast<uint32_t>(static_cast<int64_t>(bits) >> 63);
  append_varint(bits, bytes);
}

void append_tag(const Field& field, WireType type, std::string& bytes) {
  append_varint(uint64_t{field.number} << 3 | static_cast<uint64_t>(type), bytes);
}

void append_bytes(const Field& field, const std::string& value, std::string& bytes) {
  append_tag(field, WireType::kBytes, bytes);
  append_varint(value.size(), bytes);
  bytes += value;
}

}  // namespace

class MessageWriter {
 public:
  MessageWriter(const Message& message, std::string& bytes) : message_(message), bytes_(bytes) {}

  void write() {
    const auto fields = message_.type_->fields;
    for (size_t n = 0; n < fields.size(); ++n) {
      const Field& field = fields[n];
      if (field.oneof == kNoOneof ? message_.slots_[n] != 0
                                  : message_.get_member(field.oneof) == field.number)
        write_field(field, n);
    }
  }

 private:
  void write_field(const Field& field, size_t n) {
    switch (field.kind) {
      case Kind::kString:
      case Kind::kBytes:
        return write_texts(field, n);
      case Kind::kMessage:
        return write_messages(field, n);
      default:
        return write_numbers(field, n);
    }
  }

  void write_texts(const Field& field, size_t n) {
    if (field.is_repeated) {
      for (const std::string& text : message_.get_texts(n)) append_bytes(field, text, bytes_);
    } else if (field.oneof != kNoOneof || !message_.get_text(n).empty()) {
      append_bytes(field, message_.get_text(n), bytes_);
    }
  }

  void write_messages(const Field& field, size_t n) {
    if (!field.is_repeated)
      return append_bytes(field, Message::pointer<Message>(message_.slots_[n])->SerializeAsString(),
                          bytes_);
    for (const auto& child : message_.get_messages(n))
      append_bytes(field, child->SerializeAsString(), bytes_);
  }

  void write_numbers(const Field& field, size_t n) {
    if (!field.is_repeated) {
      append_tag(field, wire_type(field.kind), bytes_);
      return append_number(field.kind, message_.slots_[n], bytes_);
    }
    std::string packed;
    for (const uint64_t bits : message_.get_numbers(n)) append_number(field.kind, bits, packed);
    append_bytes(field, packed, bytes_);
  }

  const Message& message_;
  std::string& bytes_;
};

std::string Message::SerializeAsString() const {
  std::string bytes;
  MessageWriter(*this, bytes).write();
  return bytes;
}

}  // namespace burnish::messages
