#include "common/page_frames/page_frame_encoder.h"

#include <algorithm>

#include "common/packing/zstd_frame.h"
#include "common/page_frames/page_frame_body.h"
#include "common/page_frames/page_steps.h"

namespace burnish {

namespace {

constexpr int kZstdLevel = 1;  // level 3 is slower but not smaller: residuals do not repeat

// A frame of at most one page of so many is never rounded more coarsely: that would send them all,
// and once more when the surface is still.
constexpr size_t kFewPages = 4;

/// Room for the values of one page.
struct Scratch {
  std::vector<int32_t> values;
  std::vector<uint32_t> residuals;
};

// Moves one page of the client's state to what is wanted.
void encode_page_values(const WantedPage& wanted, int step_shift, size_t place, Scratch& scratch,
                        PageTile& tile, PageFrameBodyWriter& body) {
  scratch.values.resize(wanted.steps.size());
  scratch.residuals.resize(wanted.steps.size());
  tile.read(scratch.values);
  const bool is_there = step_shift == 0 && std::ranges::equal(scratch.values, wanted.steps);
  if (!is_there &&
      code_page(*tile.shown.layout, wanted.steps, step_shift, scratch.values, scratch.residuals)) {
    tile.narrowed = std::make_shared<const NarrowValues>(scratch.values);
    body.add_values(place, scratch.residuals);
  }
  if (tile.gain != wanted.gain) {
    tile.gain = wanted.gain;
    body.add_gain(place, wanted.gain);
  }
  if (!is_same(tile.held, wanted.held)) {
    tile.held = wanted.held;
    body.add_held(place, wanted.held, tile.shown.layout->vertices);
  }
}

void check_moment(const PageMoment& moment) {
  const auto shown = moment.shown.pages();
  BURNISH_CHECK(moment.pages.size() == shown.size(), "one wanted page per shown page");
  for (size_t i = 0; i < shown.size(); ++i) {
    BURNISH_CHECK(moment.pages[i].steps.size() == size_t{3} * shown[i].value_count(),
                  "the values are of another page or kind");
    BURNISH_CHECK(moment.pages[i].gain <= kPageGainExponentMax, "the gain is too large");
    BURNISH_CHECK(!moment.pages[i].held ||
                      moment.pages[i].held->size() == held_bytes(shown[i].layout->vertices),
                  "the held vertices are of another page");
  }
}

}  // namespace

/// The content of a frame, and the client's state after it.
struct PageFrameEncoder::Draft {
  PageFrameState state;
  PageFrameBodyWriter body;
  int step_shift;
  bool is_complete = true;
};

PageFrameEncoder::Draft PageFrameEncoder::draft(const PageMoment& moment, int step_shift,
                                                size_t bytes_max) const {
  const SentPageFrame* reference = sent_.newest_acknowledged();
  Draft made{start_page_frame(moment.shown, reference ? reference->state : PageFrameState{}),
             PageFrameBodyWriter(moment.pages.size()), step_shift};
  Scratch scratch;
  for (size_t place = 0; place < moment.pages.size() && made.is_complete; ++place) {
    encode_page_values(moment.pages[place], step_shift, place, scratch, made.state.tiles[place],
                       made.body);
    made.is_complete = made.body.byte_count() <= bytes_max ||
                       kFewPages * made.body.sent_pages() <= moment.pages.size();
  }
  return made;
}

PageFrameHeader PageFrameEncoder::next_header(const PageMoment& moment, const Draft& made) {
  PageFrameHeader header{.kind = kind_,
                         .step_shift = static_cast<uint8_t>(made.step_shift),
                         .sequence = next_sequence_++,
                         .revision = moment.shown.revision(),
                         .largest_move = moment.largest_move,
                         .sent_pages = made.body.sent_pages(),
                         .body_bytes = static_cast<uint32_t>(made.body.byte_count())};
  if (const SentPageFrame* reference = sent_.newest_acknowledged()) {
    header.reference = reference->sequence;
    header.reference_checksum = reference->checksum;
  }
  return header;
}

EncodedPageFrame PageFrameEncoder::encode(const PageMoment& moment, const StepChoice& steps) {
  BURNISH_CHECK(
      0 <= steps.finest && steps.finest <= steps.coarsest && steps.coarsest <= kPageStepShiftMax,
      "no such steps");
  BURNISH_CHECK(moment.shown.revision() >= revision_, "the revision falls");
  check_moment(moment);
  const auto bytes_max = [&](int shift) {
    return shift == steps.coarsest ? SIZE_MAX : steps.bytes_max;
  };
  Draft made = draft(moment, steps.finest, bytes_max(steps.finest));
  while (!made.is_complete) {
    const int coarser = made.step_shift + 1;
    made = draft(moment, coarser, bytes_max(coarser));
  }
  revision_ = moment.shown.revision();
  const PageFrameHeader header = next_header(moment, made);
  EncodedPageFrame frame{.sequence = header.sequence,
                         .reference = header.reference,
                         .sent_pages = header.sent_pages,
                         .sent_gains = made.body.sent_gains(),
                         .sent_held = made.body.sent_held(),
                         .step_shift = made.step_shift,
                         .bytes = {}};
  frame.bytes.resize(kPageFrameHeaderBytes);
  append_compressed(made.body.bytes(), kZstdLevel, frame.bytes);
  const uint64_t checksum = seal_page_frame(header, frame.bytes);
  sent_.add({header.sequence, header.reference, checksum, std::move(made.state)});
  return frame;
}

const PageFrameState* PageFrameEncoder::sent_state(uint64_t sequence) const {
  const SentPageFrame* frame = sent_.find(sequence);
  return frame != nullptr ? &frame->state : nullptr;
}

uint64_t PageFrameEncoder::byte_count_max(std::span<const ShownPage> pages) {
  return SentPageFrames::kFramesMax * (sizeof(SentPageFrame) + page_state_bytes_max(pages));
}

}  // namespace burnish
