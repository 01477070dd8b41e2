#include "common/frame_codec/frame_header.h"

#include <bit>
#include <cstring>

#include "common/packing/checksum.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "frames are written as they lie");

struct RawHeader {
  std::array<char, 4> magic;
  uint8_t version;
  uint8_t content;
  uint8_t step_shift;
  uint8_t zero8;
  uint64_t sequence;
  uint64_t reference;
  uint64_t reference_checksum;
  uint64_t layout_fingerprint;
  uint32_t sent_tiles;
  uint32_t body_bytes;
  uint64_t zero64;
  uint64_t checksum;
};
static_assert(sizeof(RawHeader) == kFrameHeaderBytes);

constexpr std::array<char, 4> kMagic = {'B', 'n', 'F', 'r'};

uint64_t checksum_of(std::span<const uint8_t> frame) {
  return sealed_checksum(frame, offsetof(RawHeader, checksum), kFrameHeaderBytes);
}

}  // namespace

uint64_t seal_frame(const FrameHeader& header, std::span<uint8_t> frame) {
  BURNISH_CHECK(frame.size() >= kFrameHeaderBytes, "no room for the header");
  RawHeader raw = {.magic = kMagic,
                   .version = kFrameFormatVersion,
                   .content = static_cast<uint8_t>(header.content),
                   .step_shift = header.step_shift,
                   .sequence = header.sequence,
                   .reference = header.reference,
                   .reference_checksum = header.reference_checksum,
                   .layout_fingerprint = header.layout_fingerprint,
                   .sent_tiles = header.sent_tiles,
                   .body_bytes = header.body_bytes};
  std::memcpy(frame.data(), &raw, sizeof(raw));
  raw.checksum = checksum_of(frame);
  std::memcpy(frame.data(), &raw, sizeof(raw));
  return raw.checksum;
}

Result<FrameHeader> read_frame_header(std::span<const uint8_t> frame) {
  RawHeader raw;
  if (frame.size() < sizeof(raw))
    return data_loss("the frame has " + std::to_string(frame.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(raw)));
  std::memcpy(&raw, frame.data(), sizeof(raw));
  if (raw.magic != kMagic) return data_loss("the frame does not begin with BnFr");
  if (raw.version != kFrameFormatVersion)
    return unimplemented("the frame has format version " + std::to_string(raw.version) +
                         ", this program reads " + std::to_string(kFrameFormatVersion));
  const std::string name = "frame " + std::to_string(raw.sequence) + ": ";
  if (raw.checksum != checksum_of(frame)) return data_loss(name + "its checksum is wrong");
  if (raw.content > static_cast<uint8_t>(FrameContent::kVertices))
    return data_loss(name + "content " + std::to_string(raw.content) + " is outside 0..1");
  if (raw.step_shift > kStepShiftMax)
    return data_loss(name + "step shift " + std::to_string(raw.step_shift) + " is outside 0..7");
  if (raw.reference >= raw.sequence)
    return data_loss(name + "its reference " + std::to_string(raw.reference) +
                     " is not an earlier frame");
  return FrameHeader{.content = static_cast<FrameContent>(raw.content),
                     .step_shift = raw.step_shift,
                     .sequence = raw.sequence,
                     .reference = raw.reference,
                     .reference_checksum = raw.reference_checksum,
                     .layout_fingerprint = raw.layout_fingerprint,
                     .sent_tiles = raw.sent_tiles,
                     .body_bytes = raw.body_bytes,
                     .checksum = raw.checksum};
}

}  // namespace burnish
