#include "common/page_frames/page_frame_header.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "common/packing/checksum.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "frames are written as they lie");

struct RawHeader {
  std::array<char, 4> magic;
  uint8_t version;
  uint8_t kind;
  uint8_t step_shift;
  uint8_t zero8;
  uint64_t sequence;
  uint64_t reference;
  uint64_t reference_checksum;
  uint32_t revision;
  float largest_move;
  uint32_t sent_pages;
  uint32_t body_bytes;
  uint64_t checksum;
};
static_assert(sizeof(RawHeader) == kPageFrameHeaderBytes);

constexpr std::array<char, 4> kMagic = {'B', 'n', 'F', 'r'};

uint64_t checksum_of(std::span<const uint8_t> frame) {
  return sealed_checksum(frame, offsetof(RawHeader, checksum), kPageFrameHeaderBytes);
}

Status check_fields(const RawHeader& raw) {
  if (raw.kind > static_cast<uint8_t>(PageFrameKind::kCorners))
    return data_loss("kind " + std::to_string(raw.kind) + " is outside 0..1");
  if (raw.step_shift > kPageStepShiftMax)
    return data_loss("step shift " + std::to_string(raw.step_shift) + " is outside 0..7");
  if (raw.reference >= raw.sequence)
    return data_loss("its reference " + std::to_string(raw.reference) + " is not an earlier frame");
  if (!std::isfinite(raw.largest_move) || raw.largest_move < 0)
    return data_loss("its largest move of " + std::to_string(raw.largest_move) +
                     " cells is not a length");
  return Status::ok();
}

}  // namespace

uint64_t seal_page_frame(const PageFrameHeader& header, std::span<uint8_t> frame) {
  BURNISH_CHECK(frame.size() >= kPageFrameHeaderBytes, "no room for the header");
  RawHeader raw = {.magic = kMagic,
                   .version = kPageFrameFormatVersion,
                   .kind = static_cast<uint8_t>(header.kind),
                   .step_shift = header.step_shift,
                   .sequence = header.sequence,
                   .reference = header.reference,
                   .reference_checksum = header.reference_checksum,
                   .revision = header.revision,
                   .largest_move = header.largest_move,
                   .sent_pages = header.sent_pages,
                   .body_bytes = header.body_bytes};
  std::memcpy(frame.data(), &raw, sizeof(raw));
  raw.checksum = checksum_of(frame);
  std::memcpy(frame.data(), &raw, sizeof(raw));
  return raw.checksum;
}

Result<PageFrameHeader> read_page_frame_header(std::span<const uint8_t> frame) {
  RawHeader raw;
  if (frame.size() < sizeof(raw))
    return data_loss("the frame has " + std::to_string(frame.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(raw)));
  std::memcpy(&raw, frame.data(), sizeof(raw));
  if (raw.magic != kMagic) return data_loss("the frame does not begin with BnFr");
  if (raw.version != kPageFrameFormatVersion)
    return unimplemented("the frame has format version " + std::to_string(raw.version) +
                         ", this program reads " + std::to_string(kPageFrameFormatVersion));
  const std::string name = "frame " + std::to_string(raw.sequence);
  if (raw.checksum != checksum_of(frame)) return data_loss(name + ": its checksum is wrong");
  RETURN_IF_ERROR(check_fields(raw).with_context(name));
  return PageFrameHeader{.kind = static_cast<PageFrameKind>(raw.kind),
                         .step_shift = raw.step_shift,
                         .sequence = raw.sequence,
                         .reference = raw.reference,
                         .reference_checksum = raw.reference_checksum,
                         .revision = raw.revision,
                         .largest_move = raw.largest_move,
                         .sent_pages = raw.sent_pages,
                         .body_bytes = raw.body_bytes,
                         .checksum = raw.checksum};
}

}  // namespace burnish
