#include "common/frame_codec/frame_encoder.h"

#include <algorithm>
#include <array>

#include "common/frame_codec/frame_body.h"
#include "common/frame_codec/tile_prediction.h"
#include "common/packing/zstd_frame.h"

namespace burnish {

namespace {

constexpr int kZstdLevel = 1;  // level 3 is slower but not smaller: residuals do not repeat

// Moves one tile of the client's state towards the sample, unless it is near enough.
void encode_tile(const FrameLayout& layout, int tile, std::span<const int32_t> wanted,
                 int step_shift, FrameState& state, FrameBodyWriter& body) {
  std::array<int32_t, 3 * kTileValues> held_values, change_values, k_values;
  std::array<uint32_t, 3 * kTileValues> residual_values;
  const size_t count = wanted.size();
  const auto held = std::span(held_values).first(count);
  const auto change = std::span(change_values).first(count);
  const TileRules rules = rules_of(layout, tile);

  state.read_tile(tile, held);
  for (size_t i = 0; i < count; ++i) change[i] = wanted[i] - held[i];
  if (is_within_slack(rules, change, step_shift)) return;

  const auto k = std::span(k_values).first(count);
  const auto residuals = std::span(residual_values).first(count);
  round_and_predict(rules, change, step_shift, k, residuals);
  body.add_tile(tile, residuals);
  apply_change(k, step_shift, held);
  state.write_tile(tile, held);
}

}  // namespace

FrameEncoder::FrameEncoder(std::shared_ptr<const FrameLayout> layout)
    : layout_(std::move(layout)) {}

/// The content of a frame, and the client's state after it.
struct FrameEncoder::Draft {
  FrameState state;
  FrameBodyWriter body;
  int step_shift;
  bool is_complete;
};

FrameEncoder::Draft FrameEncoder::draft(const FrameSample& sample, int step_shift,
                                        size_t bytes_max) const {
  const SentFrame* reference = newest_acknowledged();
  Draft made{reference != nullptr ? reference->state : FrameState(*layout_),
             FrameBodyWriter(*layout_), step_shift, false};
  const auto is_full = [&] {
    return made.body.sent_tiles() > 0 && made.body.byte_count() >= bytes_max;
  };
  int tile = 0;
  for (; tile < layout_->tile_count() && !is_full(); ++tile)
    encode_tile(*layout_, tile, sample.tile(*layout_, tile), step_shift, made.state, made.body);
  made.is_complete = tile == layout_->tile_count();
  return made;
}

EncodedFrame FrameEncoder::encode(const FrameSample& sample, FrameStep step, size_t bytes_max) {
  static constexpr int kCoarsestShift = static_cast<int>(FrameStep::kCoarsest);
  BURNISH_CHECK(sample.steps.size() == size_t{3} * layout_->value_count(),
                "the sample is of another layout");
  Draft made = draft(sample, static_cast<int>(step), bytes_max);
  while (step != FrameStep::kStill && !made.is_complete) {
    const int coarser = made.step_shift + 1;
    made = draft(sample, coarser, coarser == kCoarsestShift ? SIZE_MAX : bytes_max);
  }
  const SentFrame* reference = newest_acknowledged();
  const std::vector<uint8_t> body_bytes = made.body.bytes();
  FrameHeader header{.content = layout_->content,
                     .step_shift = static_cast<uint8_t>(made.step_shift),
                     .sequence = next_sequence_++,
                     .layout_fingerprint = layout_->fingerprint,
                     .sent_tiles = made.body.sent_tiles(),
                     .body_bytes = static_cast<uint32_t>(body_bytes.size())};
  if (reference != nullptr) {
    header.reference = reference->sequence;
    header.reference_checksum = reference->checksum;
  }
  EncodedFrame frame{header.sequence, header.reference, header.sent_tiles, made.is_complete, {}};
  frame.bytes.resize(kFrameHeaderBytes);
  append_compressed(body_bytes, kZstdLevel, frame.bytes);
  const uint64_t checksum = seal_frame(header, frame.bytes);
  remember({header.sequence, header.reference, checksum, std::move(made.state)});
  return frame;
}

void FrameEncoder::acknowledge(uint64_t sequence) {
  const auto it = std::ranges::find(sent_, sequence, &SentFrame::sequence);
  if (it == sent_.end() || it->acknowledged) return;
  const SentFrame* spare = newest_acknowledged();
  if (spare != nullptr && spare->sequence > sequence) return;  // a late acknowledgement, of no use
  it->acknowledged = true;
  const uint64_t spare_sequence = spare != nullptr ? spare->sequence : 0;
  std::erase_if(sent_, [&](const SentFrame& frame) {
    return frame.sequence < sequence && frame.sequence != spare_sequence;
  });
}

void FrameEncoder::refuse(uint64_t sequence) {
  const auto it = std::ranges::find(sent_, sequence, &SentFrame::sequence);
  if (it == sent_.end() || it->reference == 0) return;
  const uint64_t missing = it->reference;
  std::erase_if(sent_, [&](const SentFrame& frame) {
    return frame.sequence == missing || (frame.reference == missing && !frame.acknowledged);
  });
}

void FrameEncoder::request_key_frame() {
  sent_.clear();
}

const FrameState* FrameEncoder::sent_state(uint64_t sequence) const {
  const auto it = std::ranges::find(sent_, sequence, &SentFrame::sequence);
  return it == sent_.end() ? nullptr : &it->state;
}

uint64_t FrameEncoder::byte_count() const {
  uint64_t bytes = 0;
  for (const SentFrame& frame : sent_) bytes += sizeof(frame) + frame.state.byte_count();
  return bytes;
}

uint64_t FrameEncoder::byte_count_max(const FrameLayout& layout) {
  return (kFramesInFlightMax + kAcknowledgedMax) *
         (sizeof(SentFrame) + FrameState::byte_count_max(layout));
}

const FrameEncoder::SentFrame* FrameEncoder::newest_acknowledged() const {
  for (auto frame = sent_.rbegin(); frame != sent_.rend(); ++frame)
    if (frame->acknowledged) return &*frame;
  return nullptr;
}

void FrameEncoder::remember(SentFrame frame) {
  sent_.push_back(std::move(frame));
  const auto in_flight = std::ranges::count(sent_, false, &SentFrame::acknowledged);
  if (static_cast<size_t>(in_flight) > kFramesInFlightMax)
    sent_.erase(std::ranges::find(sent_, false, &SentFrame::acknowledged));
}

}  // namespace burnish
