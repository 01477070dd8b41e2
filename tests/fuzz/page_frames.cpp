#include <algorithm>
#include <cstring>

#include "common/base/check.h"
#include "common/packing/zstd_frame.h"
#include "common/page_frames/page_frame_decoder.h"
#include "tests/fuzz/readers.h"

namespace burnish {

namespace {

constexpr size_t kPrefixBytes = 3;
constexpr uint32_t kPages = 8;
constexpr size_t kRevisionAt = 32, kSentPagesAt = 40, kBodyBytesAt = 44;

enum class Kind : uint8_t { kAsIs, kSealed, kUncompressed, kChange, kCount };

struct Piece {
  Kind kind;
  std::vector<uint8_t> bytes;
};

// Pages of 1, 2, 4 and more vertices in a strip.
ShownPage fuzzed_page(PageId id) {
  Page page;
  page.positions.resize(size_t{1} << id);
  for (uint16_t v = 2; v < page.positions.size(); ++v)
    page.triangles.push_back({static_cast<uint16_t>(v - 2), static_cast<uint16_t>(v - 1), v});
  return {id, std::make_shared<const PageLayout>(make_vertex_page_layout(page))};
}

Piece take_piece(std::span<const uint8_t>& stream) {
  Piece piece{Kind::kAsIs, {stream.begin(), stream.end()}};
  if (stream.size() < kPrefixBytes) {
    stream = {};
    return piece;
  }
  piece.kind = static_cast<Kind>(stream[0] % static_cast<uint8_t>(Kind::kCount));
  const size_t wanted = stream[1] + (size_t{stream[2]} << 8);
  stream = stream.subspan(kPrefixBytes);
  const auto bytes = stream.first(std::min(wanted, stream.size()));
  piece.bytes.assign(bytes.begin(), bytes.end());
  stream = stream.subspan(bytes.size());
  return piece;
}

// Corrects checksum and reference, so that the decoder reaches the rest.
void seal_frame_bytes(std::vector<uint8_t>& frame, uint64_t reference_checksum) {
  PageFrameHeader header{.step_shift = static_cast<uint8_t>(frame[6] & kPageStepShiftMax),
                         .sequence = frame[8],
                         .reference = frame[16],
                         .revision = frame[kRevisionAt],
                         .largest_move = 1};
  if (header.reference != 0) header.reference_checksum = reference_checksum;
  std::memcpy(&header.sent_pages, &frame[kSentPagesAt], sizeof(header.sent_pages));
  std::memcpy(&header.body_bytes, &frame[kBodyBytesAt], sizeof(header.body_bytes));
  seal_page_frame(header, frame);
}

void repair(Piece& piece, uint64_t reference_checksum) {
  auto& frame = piece.bytes;
  if (piece.kind == Kind::kAsIs || frame.size() < kPageFrameHeaderBytes) return;
  if (piece.kind == Kind::kUncompressed) {
    const std::vector<uint8_t> body(frame.begin() + kPageFrameHeaderBytes, frame.end());
    const auto size = static_cast<uint32_t>(body.size());
    std::memcpy(&frame[kBodyBytesAt], &size, sizeof(size));
    frame.resize(kPageFrameHeaderBytes);
    append_compressed(body, 1, frame);
  }
  seal_frame_bytes(frame, reference_checksum);
}

// Each byte adds a page, or removes it if its highest bit is set.
PageChange change_of(std::span<const uint8_t> bytes, uint32_t revision) {
  PageChange change{.revision = revision};
  for (const uint8_t byte : bytes) {
    const PageId page = byte & 127;
    if (byte & 128)
      change.removed.push_back(page);
    else
      change.added.push_back(page < kPages ? fuzzed_page(page) : ShownPage{page, nullptr});
  }
  return change;
}

std::vector<int32_t> held(const PageFrameState& state) {
  std::vector<int32_t> values;
  for (const PageTile& tile : state.tiles) {
    const size_t begin = values.size();
    values.resize(begin + tile.value_count());
    tile.read(std::span(values).subspan(begin));
  }
  return values;
}

}  // namespace

bool read_page_frames(std::span<const uint8_t> bytes) {
  PageFrameDecoder decoder(PageFrameKind::kVertices);
  uint64_t reference_checksum = 0;
  bool decoded = false;
  while (!bytes.empty()) {
    Piece piece = take_piece(bytes);
    if (piece.kind == Kind::kChange) {
      const uint32_t revision = decoder.newest_shown().revision() + 1;
      (void)decoder.show(change_of(piece.bytes, revision), kPages);
      continue;
    }
    repair(piece, reference_checksum);
    const auto before = held(decoder.state());
    if (decoder.decode(piece.bytes).is_ok()) {
      decoded = true;
      reference_checksum = read_page_frame_header(piece.bytes)->checksum;
    } else {
      BURNISH_CHECK(held(decoder.state()) == before, "a refused frame changed the state");
    }
  }
  return decoded;
}

}  // namespace burnish
