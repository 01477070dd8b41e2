#include "client/live/frame_receiver.h"

#include <algorithm>
#include <utility>

namespace burnish {

// A stream's first frame tells its kind. Until then one kind is as good as the other.
static PageFrameReader first_reader(const FrameSource& source) {
  return {{PageFrameKind::kVertices, source.head.grid.bits, source.depth},
          source.head.page_count()};
}

FrameReceiver::FrameReceiver(const FrameSource& source)
    : source_(source), reader_(first_reader(source)) {}

void FrameReceiver::restart() {
  reader_ = first_reader(source_);
  answers_ = {};
}

Status FrameReceiver::welcome(const Welcome& welcome) const {
  if (source_.pages_fingerprint != 0 && welcome.pages_fingerprint != source_.pages_fingerprint)
    return failed_precondition(
        "the scan's pages have changed on the server: the session must be opened again");
  if (welcome.session.key.depth != source_.depth)
    return failed_precondition("the session has depth " +
                               std::to_string(welcome.session.key.depth) + ", not " +
                               std::to_string(source_.depth) + ": it must be opened again");
  if (source_.depth > source_.head.grid.bits)
    return failed_precondition("depth " + std::to_string(source_.depth) +
                               " is finer than the lattice of the scan's pages, " +
                               std::to_string(source_.head.grid.bits) + " bits");
  return Status::ok();
}

Status FrameReceiver::show(const ShowPages& change,
                           const std::vector<std::shared_ptr<const Page>>& added) {
  return reader_.show(change, added);
}

Result<std::shared_ptr<const SurfaceFrame>> FrameReceiver::receive(const std::string& data) {
  const std::shared_ptr<const SurfaceFrame> nothing;
  if (data.empty()) return nothing;
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(data.data()), data.size());
  const auto frame = decode(bytes);
  if (frame.is_ok()) {
    answers_.decoded.push_back(frame->sequence);
    return surface_of(*frame);
  }
  switch (frame.status().code()) {
    case StatusCode::kAlreadyExists:
      return nothing;
    case StatusCode::kFailedPrecondition:
      answers_.refused.push_back(read_page_frame_header(bytes)->sequence);
      return nothing;
    case StatusCode::kDataLoss:
      answers_.key_frame = true;
      return nothing;
    default:
      return frame.status();
  }
}

// The server may begin another kind with any key frame.
Result<DecodedPageFrame> FrameReceiver::decode(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const PageFrameHeader header, read_page_frame_header(bytes));
  if (header.kind == reader_.kind()) return reader_.decode(bytes);
  PageFrameReader other = reader_.in_other_kind();
  ASSIGN_OR_RETURN(DecodedPageFrame frame, other.decode(bytes));
  reader_ = std::move(other);
  return frame;
}

std::shared_ptr<const SurfaceFrame> FrameReceiver::surface_of(const DecodedPageFrame& frame) {
  auto surface = std::make_shared<SurfaceFrame>();
  surface->number = surface_->number + 1;
  surface->is_exact = frame.step_shift == 0;
  surface->largest_move = frame.largest_move;
  for (const PageTile& tile : reader_.state().tiles) {
    const PageId page = tile.shown.page;
    surface->pages.push_back(page);
    const auto before = surface_->share(page);
    const bool is_as_before = before && before->gain == tile.gain &&
                              !std::ranges::binary_search(frame.changed_pages, page);
    surface->moves.push_back(is_as_before ? before : reader_.move_of(tile));
  }
  surface_ = std::move(surface);
  return surface_;
}

bool FrameReceiver::has_answers() const {
  return !answers_.decoded.empty() || !answers_.refused.empty() || answers_.key_frame;
}

FrameCredit FrameReceiver::take_answers() {
  return std::exchange(answers_, {});
}

}  // namespace burnish
