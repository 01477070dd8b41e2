#include "client/connection/frame_receiver.h"

#include <numeric>
#include <utility>

namespace burnish {

Status FrameReceiver::welcome(const Welcome& welcome) {
  layout_ = layout_of(welcome.content);
  if (layout_->fingerprint != welcome.layout_fingerprint)
    return failed_precondition(
        "the frames are not of the mesh that is open here: it has to be fetched again");
  decoder_.emplace(layout_);
  answers_ = {};
  all_changed_ = true;
  return Status::ok();
}

std::shared_ptr<const FrameLayout> FrameReceiver::layout_of(FrameContent content) {
  auto& layout = layouts_[static_cast<size_t>(content)];
  if (layout) return layout;
  const FrameMesh mesh{view_->grid, view_->points};
  layout = std::make_shared<FrameLayout>(content == FrameContent::kCoefficients
                                             ? make_coefficient_layout(mesh)
                                             : make_vertex_layout(mesh));
  return layout;
}

Result<std::optional<Displacement>> FrameReceiver::receive(const std::string& data) {
  if (!decoder_) return data_loss("a frame came before the welcome");
  if (data.empty()) return std::optional<Displacement>();
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(data.data()), data.size());
  const auto frame = decoder_->decode(bytes);
  if (frame.is_ok()) {
    answers_.decoded.push_back(frame->sequence);
    return moved(*frame);
  }
  switch (frame.status().code()) {
    case StatusCode::kAlreadyExists:
      return std::optional<Displacement>();
    case StatusCode::kFailedPrecondition:
      answers_.refused.push_back(read_frame_header(bytes)->sequence);
      return std::optional<Displacement>();
    case StatusCode::kDataLoss:
      answers_.key_frame = true;
      return std::optional<Displacement>();
    default:
      return frame.status();
  }
}

std::optional<Displacement> FrameReceiver::moved(const DecodedFrame& frame) {
  Displacement displacement{layout_, decoder_->state(), frame.changed_tiles};
  if (all_changed_) {
    displacement.changed_tiles.resize(static_cast<size_t>(layout_->tile_count()));
    std::iota(displacement.changed_tiles.begin(), displacement.changed_tiles.end(), 0);
    all_changed_ = false;
  }
  return displacement;
}

bool FrameReceiver::has_answers() const {
  return !answers_.decoded.empty() || !answers_.refused.empty() || answers_.key_frame;
}

FrameCredit FrameReceiver::take_answers() {
  return std::exchange(answers_, {});
}

}  // namespace burnish
