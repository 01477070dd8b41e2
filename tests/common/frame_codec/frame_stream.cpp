#include "tests/common/frame_codec/frame_stream.h"

#include <cstring>

#include "common/base/check.h"
#include "common/packing/zstd_frame.h"
#include "common/frame_codec/frame_decoder.h"

namespace burnish {

namespace {

FrameLayout make_stream_layout() {
  constexpr int kSide = 36;
  std::vector<MortonKey> cells;
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y) cells.push_back(morton_key({x, y, 3}));
  std::ranges::sort(cells);
  const SparseGrid grid = make_finest_grid(6, cells);
  std::vector<EvaluationPoint> points;
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell)
    points.push_back({.cell = cell, .local = {0.5F, 0.25F, 0.125F}});
  return make_coefficient_layout({grid, points});
}

enum class Kind : uint8_t { kAsIs, kSealed, kUncompressed, kCount };

struct Piece {
  Kind kind;
  std::vector<uint8_t> frame;
};

Piece take_piece(std::span<const uint8_t>& stream) {
  constexpr size_t kPrefixBytes = 3;
  Piece piece{Kind::kAsIs, {stream.begin(), stream.end()}};
  if (stream.size() < kPrefixBytes) {
    stream = {};
    return piece;
  }
  piece.kind = static_cast<Kind>(stream[0] % static_cast<uint8_t>(Kind::kCount));
  const size_t wanted = stream[1] + (size_t{stream[2]} << 8);
  stream = stream.subspan(kPrefixBytes);
  const auto frame = stream.first(std::min(wanted, stream.size()));
  piece.frame.assign(frame.begin(), frame.end());
  stream = stream.subspan(frame.size());
  return piece;
}

// Corrects checksum, layout and reference, so that the decoder reaches the rest.
void seal(std::vector<uint8_t>& frame, const FrameLayout& layout, uint64_t reference_checksum) {
  FrameHeader header{.content = layout.content,
                     .step_shift = static_cast<uint8_t>(frame[6] & kStepShiftMax),
                     .sequence = frame[8],
                     .reference = frame[16],
                     .layout_fingerprint = layout.fingerprint};
  if (header.reference != 0) header.reference_checksum = reference_checksum;
  std::memcpy(&header.sent_tiles, &frame[40], sizeof(header.sent_tiles));
  std::memcpy(&header.body_bytes, &frame[44], sizeof(header.body_bytes));
  seal_frame(header, frame);
}

void repair(Piece& piece, const FrameLayout& layout, uint64_t reference_checksum) {
  auto& frame = piece.frame;
  if (piece.kind == Kind::kAsIs || frame.size() < kFrameHeaderBytes) return;
  if (piece.kind == Kind::kUncompressed) {
    const std::vector<uint8_t> body(frame.begin() + kFrameHeaderBytes, frame.end());
    const auto size = static_cast<uint32_t>(body.size());
    std::memcpy(&frame[44], &size, sizeof(size));
    frame.resize(kFrameHeaderBytes);
    append_compressed(body, 1, frame);
  }
  seal(frame, layout, reference_checksum);
}

std::vector<int32_t> held(const FrameLayout& layout, const FrameState& state) {
  std::vector<int32_t> steps(size_t{3} * layout.value_count());
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    state.read_tile(tile, std::span(steps).subspan(size_t{3} * layout.tile_begin(tile),
                                                   size_t{3} * layout.tile_size(tile)));
  return steps;
}

}  // namespace

std::shared_ptr<const FrameLayout> frame_stream_layout() {
  static const auto layout = std::make_shared<const FrameLayout>(make_stream_layout());
  return layout;
}

int decode_frame_stream(std::span<const uint8_t> stream) {
  const auto layout = frame_stream_layout();
  FrameDecoder decoder(layout);
  uint64_t reference_checksum = 0;
  int decoded = 0;
  while (!stream.empty()) {
    Piece piece = take_piece(stream);
    repair(piece, *layout, reference_checksum);
    const auto before = held(*layout, decoder.state());
    if (decoder.decode(piece.frame).is_ok()) {
      ++decoded;
      reference_checksum = read_frame_header(piece.frame)->checksum;
    } else {
      BURNISH_CHECK(held(*layout, decoder.state()) == before, "a refused frame changed the state");
    }
  }
  return decoded;
}

}  // namespace burnish
