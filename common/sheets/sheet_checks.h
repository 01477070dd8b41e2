#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "common/base/line_text.h"
#include "common/base/status.h"
#include "common/packing/checksum.h"
#include "common/sheets/sheet_format.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

// Private to this folder: what the records of sheets have in common. A record's Header begins with
// `magic` and `version`, and ends with `checksum`.

/// Fails: data_loss that names the value, unless `least` <= value <= `most`.
inline Status check_sheet_value(const char* name, uint64_t value, uint64_t least, uint64_t most) {
  if (value >= least && value <= most) return Status::ok();
  return data_loss(std::to_string(value) + " " + name + " are outside " + std::to_string(least) +
                   ".." + std::to_string(most));
}

/// Fails: data_loss that names the value, unless 0 < density < kSheetDensityEnd.
inline Status check_sheet_density(float density) {
  if (density > 0 && density < kSheetDensityEnd) return Status::ok();  // false for NaN
  LineText message;
  message << "a density of " << density << " texels per file unit is outside 0.."
          << kSheetDensityEnd;
  return data_loss(message.text());
}

template <typename Header>
uint64_t record_checksum(std::span<const uint8_t> bytes) {
  return sealed_checksum(bytes, offsetof(Header, checksum), sizeof(Header));
}

/// Reads a header and checks what all have: size, magic, version, checksum.
/// Fails: data_loss; unimplemented (another version).
template <typename Header>
Result<Header> read_sealed(std::span<const uint8_t> bytes, size_t bytes_max) {
  RETURN_IF_ERROR(check_sheet_value("bytes", bytes.size(), 0, bytes_max));
  Header header;
  if (bytes.size() < sizeof(header))
    return data_loss("it has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(header)));
  const std::array<char, 4> magic = header.magic;
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.magic != magic)
    return data_loss("it does not begin with " + std::string(magic.data(), magic.size()));
  if (header.version != kSheetFormatVersion)
    return unimplemented("it has format version " + std::to_string(header.version) +
                         ", this program reads " + std::to_string(kSheetFormatVersion));
  if (header.checksum != record_checksum<Header>(bytes)) return data_loss("its checksum is wrong");
  return header;
}

/// Writes the header with its checksum before the body that lies behind it already.
template <typename Header>
void seal_record(Header header, std::span<uint8_t> bytes) {
  std::memcpy(bytes.data(), &header, sizeof(header));
  header.checksum = record_checksum<Header>(bytes);
  std::memcpy(bytes.data(), &header, sizeof(header));
}

}  // namespace burnish
