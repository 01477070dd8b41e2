#include "common/page_frames/sent_page_frames.h"

#include <algorithm>

namespace burnish {

void SentPageFrames::add(SentPageFrame frame) {
  frames_.push_back(std::move(frame));
  const auto in_flight = std::ranges::count(frames_, false, &SentPageFrame::acknowledged);
  if (static_cast<size_t>(in_flight) > kPageFramesInFlightMax)
    frames_.erase(std::ranges::find(frames_, false, &SentPageFrame::acknowledged));
}

void SentPageFrames::acknowledge(uint64_t sequence) {
  const auto it = std::ranges::find(frames_, sequence, &SentPageFrame::sequence);
  if (it == frames_.end() || it->acknowledged) return;
  const SentPageFrame* spare = newest_acknowledged();
  if (spare != nullptr && spare->sequence > sequence) return;  // late: a newer one is known
  const uint64_t spare_sequence = spare != nullptr ? spare->sequence : 0;
  it->acknowledged = true;
  std::erase_if(frames_, [&](const SentPageFrame& frame) {
    return frame.sequence < sequence && frame.sequence != spare_sequence;
  });
}

void SentPageFrames::refuse(uint64_t sequence) {
  const SentPageFrame* refused = find(sequence);
  if (refused == nullptr || refused->reference == 0) return;
  const uint64_t missing = refused->reference;
  std::erase_if(frames_, [&](const SentPageFrame& frame) {
    return frame.sequence == missing || (frame.reference == missing && !frame.acknowledged);
  });
}

const SentPageFrame* SentPageFrames::newest_acknowledged() const {
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame)
    if (frame->acknowledged) return &*frame;
  return nullptr;
}

const SentPageFrame* SentPageFrames::find(uint64_t sequence) const {
  const auto it = std::ranges::find(frames_, sequence, &SentPageFrame::sequence);
  return it == frames_.end() ? nullptr : &*it;
}

uint64_t SentPageFrames::byte_count() const {
  uint64_t bytes = 0;
  for (const SentPageFrame& frame : frames_) bytes += sizeof(frame) + frame.state.byte_count();
  return bytes;
}

}  // namespace burnish
