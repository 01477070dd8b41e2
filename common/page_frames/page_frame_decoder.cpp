#include "common/page_frames/page_frame_decoder.h"

#include <algorithm>
#include <string>

#include "common/packing/zstd_frame.h"
#include "common/page_frames/page_frame_body.h"
#include "common/page_frames/page_steps.h"
#include "common/page_frames/sent_page_frames.h"

namespace burnish {

namespace {

std::string name_of(const PageFrameHeader& header) {
  return "frame " + std::to_string(header.sequence);
}

void decode_tile(int step_shift, PageFrameBodyReader& body, PageTile& tile) {
  std::vector<uint32_t> residuals(tile.value_count());
  std::vector<int32_t> values(tile.value_count());
  body.read_values(residuals);
  tile.read(values);
  undo_page(*tile.shown.layout, residuals, step_shift, values);
  tile.narrowed = std::make_shared<const NarrowValues>(values);
}

Status decode_body(const PageFrameHeader& header, std::span<const ShownPage> pages,
                   std::span<const uint8_t> compressed, PageFrameState& state) {
  if (header.body_bytes > page_body_bytes_max(pages))
    return data_loss("the body has " + std::to_string(header.body_bytes) + " bytes, the limit is " +
                     std::to_string(page_body_bytes_max(pages)));
  const auto bytes = decompress(compressed, header.body_bytes);
  if (!bytes.is_ok()) return bytes.status().with_context("the body");
  ASSIGN_OR_RETURN(auto body, PageFrameBodyReader::open(pages, header.sent_pages, *bytes));
  for (size_t place = 0; place < pages.size(); ++place) {
    PageTile& tile = state.tiles[place];
    if (body.has_gain(place)) tile.gain = body.read_gain();
    if (body.has_held(place)) tile.held = body.read_held(tile.shown.layout->vertices);
    if (body.has_values(place)) decode_tile(header.step_shift, body, tile);
  }
  return Status::ok();
}

std::vector<PageId> changed_pages(const PageFrameState& before, const PageFrameState& after) {
  std::vector<PageId> changed;
  for (const PageTile& tile : after.tiles) {
    const PageTile* old = before.find(tile.shown.page);
    if (old == nullptr || old->narrowed != tile.narrowed || old->held != tile.held)
      changed.push_back(tile.shown.page);
  }
  return changed;
}

}  // namespace

PageFrameDecoder::PageFrameDecoder(PageFrameKind kind, ShownPages shown)
    : kind_(kind), revisions_{std::move(shown)} {}

Status PageFrameDecoder::show(const PageChange& change, uint32_t page_count) {
  if (revisions_.size() > kPageChangesInFlightMax)
    return resource_exhausted(std::to_string(revisions_.size()) +
                              " changes of the shown pages wait for a frame, the limit is " +
                              std::to_string(kPageChangesInFlightMax));
  RETURN_IF_ERROR(newest_shown().check(change, page_count));
  revisions_.push_back(newest_shown().changed(change));
  return Status::ok();
}

Result<DecodedPageFrame> PageFrameDecoder::decode(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const PageFrameHeader header, read_page_frame_header(bytes));
  RETURN_IF_ERROR(check_belongs(header));
  ASSIGN_OR_RETURN(PageFrameState state, start_of(header));
  RETURN_IF_ERROR(decode_body(header, pages_of(header.revision).pages(),
                              bytes.subspan(kPageFrameHeaderBytes), state)
                      .with_context(name_of(header)));
  DecodedPageFrame frame{.sequence = header.sequence,
                         .revision = header.revision,
                         .is_key = header.is_key(),
                         .step_shift = header.step_shift,
                         .largest_move = header.largest_move,
                         .changed_pages = changed_pages(state_, state)};
  remember(header, std::move(state));
  return frame;
}

Status PageFrameDecoder::check_belongs(const PageFrameHeader& header) const {
  if (header.kind != kind_)
    return invalid_argument(name_of(header) + ": kind " +
                            std::to_string(static_cast<int>(header.kind)) +
                            " is not the kind of this stream");
  if (!held_.empty() && header.sequence <= held_.back().sequence)
    return already_exists(name_of(header) + ": frame " + std::to_string(held_.back().sequence) +
                          " is already shown");
  const uint32_t oldest = revisions_.front().revision(), newest = newest_shown().revision();
  if (header.revision < oldest || header.revision > newest)
    return invalid_argument(name_of(header) + ": revision " + std::to_string(header.revision) +
                            " is outside " + std::to_string(oldest) + ".." +
                            std::to_string(newest));
  return Status::ok();
}

Result<PageFrameState> PageFrameDecoder::start_of(const PageFrameHeader& header) const {
  const ShownPages& pages = pages_of(header.revision);
  if (header.is_key()) return start_page_frame(pages, {});
  const auto it = std::ranges::find(held_, header.reference, &HeldFrame::sequence);
  if (it == held_.end() || it->checksum != header.reference_checksum)
    return failed_precondition(name_of(header) + ": its reference, frame " +
                               std::to_string(header.reference) + ", is not held here");
  return start_page_frame(pages, it->state);
}

const ShownPages& PageFrameDecoder::pages_of(uint32_t revision) const {
  return revisions_[revision - revisions_.front().revision()];
}

// Drops frames older than the last reference: without a refusal the encoder never goes back
// further.
void PageFrameDecoder::remember(const PageFrameHeader& header, PageFrameState state) {
  while (revisions_.front().revision() < header.revision) revisions_.pop_front();
  state_ = state;
  if (!header.is_key()) reference_ = header.reference;
  std::erase_if(held_, [&](const HeldFrame& frame) { return frame.sequence < reference_; });
  held_.push_back({header.sequence, header.checksum, std::move(state)});
  const auto is_spare = [&](const HeldFrame& frame) { return frame.sequence != reference_; };
  if (std::ranges::count_if(held_, is_spare) > static_cast<std::ptrdiff_t>(kPageFramesInFlightMax))
    held_.erase(std::ranges::find_if(held_, is_spare));
}

}  // namespace burnish
