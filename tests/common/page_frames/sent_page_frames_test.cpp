#include "common/page_frames/sent_page_frames.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

class SentPageFramesTest : public testing::Test {
 protected:
  void send(uint64_t sequence) {
    const SentPageFrame* reference = sent_.newest_acknowledged();
    sent_.add({.sequence = sequence, .reference = reference ? reference->sequence : 0});
  }
  uint64_t reference() const {
    const SentPageFrame* frame = sent_.newest_acknowledged();
    return frame ? frame->sequence : 0;
  }

  SentPageFrames sent_;
};

TEST_F(SentPageFramesTest, ASilentClientCostsBoundedMemory) {
  for (uint64_t sequence = 1; sequence <= 100; ++sequence) send(sequence);
  EXPECT_EQ(sent_.find(100 - kPageFramesInFlightMax), nullptr);
  EXPECT_NE(sent_.find(101 - kPageFramesInFlightMax), nullptr);
  EXPECT_EQ(sent_.byte_count(), kPageFramesInFlightMax * sizeof(SentPageFrame));
}

TEST_F(SentPageFramesTest, TheReferenceOutlivesAnyNumberOfFrames) {
  send(1);
  sent_.acknowledge(1);
  for (uint64_t sequence = 2; sequence <= 100; ++sequence) send(sequence);
  EXPECT_EQ(reference(), 1u);
}

TEST_F(SentPageFramesTest, ALateAcknowledgementChangesNothing) {
  for (uint64_t sequence = 1; sequence <= 3; ++sequence) send(sequence);
  sent_.acknowledge(3);
  sent_.acknowledge(2);
  EXPECT_EQ(reference(), 3u);
}

TEST_F(SentPageFramesTest, ARefusedFrameFallsBackToTheSpare) {
  send(1);
  sent_.acknowledge(1);
  send(2);
  sent_.acknowledge(2);
  send(3);
  sent_.refuse(3);
  EXPECT_EQ(reference(), 1u);
  send(4);
  sent_.refuse(4);
  EXPECT_EQ(reference(), 0u);
}

TEST_F(SentPageFramesTest, RefusingAKeyFrameChangesNothing) {
  send(1);
  sent_.refuse(1);
  EXPECT_NE(sent_.find(1), nullptr);
}

}  // namespace
}  // namespace burnish
