#include <gtest/gtest.h>

#include "common/frame_codec/frame_decoder.h"
#include "common/frame_codec/frame_encoder.h"
#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

/// A link that loses, delays and reorders frames and acknowledgements. Encoder and decoder must
/// hold the same after each frame that arrives.
class LossyLink {
 public:
  LossyLink(FrameContent content, unsigned seed)
      : layout_(small_layout(content)), random_(seed), encoder_(layout_), decoder_(layout_) {
    sample_.steps.resize(size_t{3} * layout_->value_count());
  }

  void run(int events) {
    for (int event = 0; event < events; ++event) {
      const unsigned what = random_() % 10;
      if (what < 4)
        send();
      else if (what < 8)
        deliver_frame();
      else
        deliver_acknowledgement();
      if (random_() % 200 == 0) reconnect();
    }
  }

  int decoded() const { return decoded_; }
  int refused() const { return refused_; }

 private:
  struct OnTheWay {
    EncodedFrame frame;
    FrameStep step;
    std::vector<int32_t> wanted;
    std::vector<int32_t> held;  // the client's state in the view of the encoder
  };

  void send() {
    change_some_tiles(*layout_, random_, sample_);
    const FrameStep step = random_() % 4 == 0 ? FrameStep::kStill : FrameStep::kMoving;
    EncodedFrame frame = encoder_.encode(sample_, step);
    auto held = steps_of(*layout_, *encoder_.sent_state(frame.sequence));
    frames_.push_back({std::move(frame), step, sample_.steps, std::move(held)});
  }

  template <typename T>
  T take_any(std::vector<T>& things) {
    // Mostly in order.
    const size_t at = random_() % 4 == 0 ? random_() % things.size() : 0;
    T thing = std::move(things[at]);
    things.erase(things.begin() + static_cast<std::ptrdiff_t>(at));
    return thing;
  }

  void deliver_frame() {
    if (frames_.empty()) return;
    const OnTheWay arrived = take_any(frames_);
    if (random_() % 8 == 0) return;  // lost
    const auto before = steps_of(*layout_, decoder_.state());
    const auto decoded = decoder_.decode(arrived.frame.bytes);
    if (!decoded.is_ok()) {
      EXPECT_EQ(steps_of(*layout_, decoder_.state()), before);
      if (decoded.status().code() == StatusCode::kFailedPrecondition) {
        ++refused_;
        encoder_.refuse(arrived.frame.sequence);
      } else {
        EXPECT_EQ(decoded.status().code(), StatusCode::kAlreadyExists);
      }
      return;
    }
    ++decoded_;
    acknowledgements_.push_back(decoded->sequence);
    expect_shown(arrived, *decoded, before);
  }

  void expect_shown(const OnTheWay& arrived, const DecodedFrame& decoded,
                    const std::vector<int32_t>& before) {
    const auto shown = steps_of(*layout_, decoder_.state());
    EXPECT_EQ(shown, arrived.held);
    if (arrived.step == FrameStep::kStill) {
      EXPECT_EQ(shown, arrived.wanted);
    }
    for (int tile = 0; tile < layout_->tile_count(); ++tile) {
      if (std::ranges::count(decoded.changed_tiles, tile) > 0) continue;
      const auto begin = size_t{3} * layout_->tile_begin(tile);
      const auto end = begin + size_t{3} * layout_->tile_size(tile);
      EXPECT_TRUE(std::equal(&shown[begin], &shown[begin] + (end - begin), &before[begin]));
    }
  }

  void deliver_acknowledgement() {
    if (acknowledgements_.empty()) return;
    const uint64_t sequence = take_any(acknowledgements_);
    if (random_() % 8 != 0) encoder_.acknowledge(sequence);
  }

  void reconnect() {
    frames_.clear();
    acknowledgements_.clear();
    if (random_() % 2 == 0) decoder_ = FrameDecoder(layout_);
    if (random_() % 2 == 0) encoder_.request_key_frame();
  }

  std::shared_ptr<const FrameLayout> layout_;
  std::mt19937 random_;
  FrameEncoder encoder_;
  FrameDecoder decoder_;
  FrameSample sample_;
  std::vector<OnTheWay> frames_;
  std::vector<uint64_t> acknowledgements_;
  int decoded_ = 0;
  int refused_ = 0;
};

class FrameHistory : public testing::TestWithParam<FrameContent> {};

TEST_P(FrameHistory, DecoderAndEncoderHoldTheSameWhateverTheLinkLoses) {
  int decoded = 0, refused = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    LossyLink link(GetParam(), seed);
    link.run(400);
    decoded += link.decoded();
    refused += link.refused();
  }
  EXPECT_GT(decoded, 500);
  EXPECT_GT(refused, 10);
}

INSTANTIATE_TEST_SUITE_P(Contents, FrameHistory,
                         testing::Values(FrameContent::kCoefficients, FrameContent::kVertices));

}  // namespace
}  // namespace burnish
