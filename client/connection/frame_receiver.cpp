#include "client/connection/frame_receiver.h"

#include <numeric>

namespace burnish {

Status FrameReceiver::welcome(const v1::Welcome& welcome) {
  switch (welcome.content()) {
    case v1::FRAME_CONTENT_COEFFICIENTS:
      layout_ = layout_of(FrameContent::kCoefficients);
      break;
    case v1::FRAME_CONTENT_VERTICES:
      layout_ = layout_of(FrameContent::kVertices);
      break;
    default:
      return invalid_argument("frames of content " + std::to_string(welcome.content()) +
                              " are not known here");
  }
  if (layout_->fingerprint != welcome.layout_fingerprint())
    return failed_precondition(
        "the frames are not of the mesh that is open here: it has to be fetched again");
  decoder_.emplace(layout_);
  answers_.Clear();
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
    answers_.add_decoded(frame->sequence);
    return moved(*frame);
  }
  switch (frame.status().code()) {
    case StatusCode::kAlreadyExists:
      return std::optional<Displacement>();
    case StatusCode::kFailedPrecondition:
      answers_.add_refused(read_frame_header(bytes)->sequence);
      return std::optional<Displacement>();
    case StatusCode::kDataLoss:
      answers_.set_key_frame(true);
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
  return answers_.decoded_size() > 0 || answers_.refused_size() > 0 || answers_.key_frame();
}

v1::Credit FrameReceiver::take_answers() {
  v1::Credit answers;
  answers.Swap(&answers_);
  return answers;
}

}  // namespace burnish
