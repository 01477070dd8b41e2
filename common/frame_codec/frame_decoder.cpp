#include "common/frame_codec/frame_decoder.h"

#include <algorithm>
#include <array>

#include "common/frame_codec/frame_body.h"
#include "common/frame_codec/frame_encoder.h"
#include "common/frame_codec/tile_prediction.h"
#include "common/packing/zstd_frame.h"

namespace burnish {

namespace {

std::string name_of(const FrameHeader& header) {
  return "frame " + std::to_string(header.sequence);
}

void decode_tile(const FrameLayout& layout, int tile, int step_shift, FrameBodyReader& body,
                 FrameState& state) {
  std::array<uint32_t, 3 * kTileValues> residual_values;
  std::array<int32_t, 3 * kTileValues> k_values, tile_values;
  const size_t count = size_t{3} * layout.tile_size(tile);
  const auto residuals = std::span(residual_values).first(count);
  const auto k = std::span(k_values).first(count);
  const auto values = std::span(tile_values).first(count);
  body.read_tile(residuals);
  undo_prediction(rules_of(layout, tile), residuals, k);
  state.read_tile(tile, values);
  apply_change(k, step_shift, values);
  state.write_tile(tile, values);
}

Status decode_body(const FrameLayout& layout, const FrameHeader& header,
                   std::span<const uint8_t> compressed, FrameState& state) {
  if (header.body_bytes > body_bytes_max(layout))
    return data_loss("the body has " + std::to_string(header.body_bytes) + " bytes, the limit is " +
                     std::to_string(body_bytes_max(layout)));
  const auto bytes = decompress(compressed, header.body_bytes);
  if (!bytes.is_ok()) return bytes.status().with_context("the body");
  ASSIGN_OR_RETURN(auto body, FrameBodyReader::open(layout, header.sent_tiles, *bytes));
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    if (body.is_sent(tile)) decode_tile(layout, tile, header.step_shift, body, state);
  return Status::ok();
}

}  // namespace

FrameDecoder::FrameDecoder(std::shared_ptr<const FrameLayout> layout)
    : layout_(std::move(layout)), shown_(*layout_) {}

Result<DecodedFrame> FrameDecoder::decode(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const FrameHeader header, read_frame_header(bytes));
  RETURN_IF_ERROR(check_belongs(header));
  ASSIGN_OR_RETURN(FrameState state, reference_of(header));
  RETURN_IF_ERROR(decode_body(*layout_, header, bytes.subspan(kFrameHeaderBytes), state)
                      .with_context(name_of(header)));
  DecodedFrame frame{.sequence = header.sequence,
                     .is_key = header.is_key(),
                     .is_still = header.step_shift == static_cast<uint8_t>(FrameStep::kStill)};
  for (int tile = 0; tile < layout_->tile_count(); ++tile)
    if (!state.shares_tile(shown_, tile)) frame.changed_tiles.push_back(tile);
  remember(header, std::move(state));
  return frame;
}

Status FrameDecoder::check_belongs(const FrameHeader& header) const {
  if (header.content != layout_->content || header.layout_fingerprint != layout_->fingerprint)
    return invalid_argument(name_of(header) + ": belongs to a mesh or proxy that is not open here");
  if (!held_.empty() && header.sequence <= held_.back().sequence)
    return already_exists(name_of(header) + ": frame " + std::to_string(held_.back().sequence) +
                          " is already shown");
  return Status::ok();
}

Result<FrameState> FrameDecoder::reference_of(const FrameHeader& header) const {
  if (header.is_key()) return FrameState(*layout_);
  const auto it = std::ranges::find(held_, header.reference, &HeldFrame::sequence);
  if (it == held_.end() || it->checksum != header.reference_checksum)
    return failed_precondition(name_of(header) + ": its reference, frame " +
                               std::to_string(header.reference) + ", is not held here");
  return it->state;
}

// Drops frames older than the last reference: without a refusal the encoder never goes back
// further.
void FrameDecoder::remember(const FrameHeader& header, FrameState state) {
  shown_ = state;
  if (!header.is_key()) reference_ = header.reference;
  std::erase_if(held_, [&](const HeldFrame& frame) { return frame.sequence < reference_; });
  held_.push_back({header.sequence, header.checksum, std::move(state)});
  const auto is_spare = [&](const HeldFrame& frame) { return frame.sequence != reference_; };
  if (std::ranges::count_if(held_, is_spare) > static_cast<std::ptrdiff_t>(kFramesInFlightMax))
    held_.erase(std::ranges::find_if(held_, is_spare));
}

}  // namespace burnish
