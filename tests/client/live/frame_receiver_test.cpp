#include "client/live/frame_receiver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/live/small_surface.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

FrameSource small_source() {
  return {.head = small_head(), .depth = small_depth()};
}

/// A server that encodes frames for one client, and the receiver of that client. Changes of pages
/// reach the server at once, unless a test holds them back.
class FrameReceiving : public testing::TestWithParam<PageFrameKind> {
 protected:
  FrameReceiving() { move_to(0); }

  void move_to(double phase) {
    field_ = wavy_field(2, phase);
    sampler_.sample(field_);
  }

  PageChange say(const std::vector<PageId>& added, const std::vector<PageId>& removed = {}) {
    const ShowPages change{++revision_, added, removed};
    EXPECT_TRUE(receiver_.show(change, small_pages_of(added)).is_ok());
    PageChange heard = sampler_.adding(revision_, added);
    heard.removed = removed;
    return heard;
  }
  void show(const std::vector<PageId>& added, const std::vector<PageId>& removed = {}) {
    shown_ = shown_.changed(say(added, removed));
  }

  std::string encode(const StepChoice& steps = kStillSteps) {
    const std::vector<WantedPage> wanted = sampler_.wanted(shown_);
    const EncodedPageFrame frame = encoder_.encode({shown_, wanted, 2.5f}, steps);
    sequence_ = frame.sequence;
    return {frame.bytes.begin(), frame.bytes.end()};
  }
  std::shared_ptr<const SurfaceFrame> receive(const std::string& data) {
    auto frame = receiver_.receive(data);
    EXPECT_TRUE(frame.is_ok()) << frame.status().message();
    const FrameCredit answers = receiver_.take_answers();
    for (const uint64_t sequence : answers.decoded) encoder_.acknowledge(sequence);
    for (const uint64_t sequence : answers.refused) encoder_.refuse(sequence);
    refused_ += answers.refused.size();
    if (answers.key_frame) encoder_.request_key_frame();
    key_frames_ += answers.key_frame ? 1 : 0;
    return frame.is_ok() ? *frame : nullptr;
  }
  std::shared_ptr<const SurfaceFrame> next() { return receive(encode()); }
  std::vector<PageId> shown_ids() const {
    std::vector<PageId> ids;
    for (const ShownPage& page : shown_.pages()) ids.push_back(page.page);
    return ids;
  }

  /// The server begins frames of another kind.
  void change_kind(PageFrameKind kind) {
    sampler_ = PageSampler(kind);
    sampler_.sample(field_);
    encoder_ = PageFrameEncoder(kind);
    std::vector<ShownPage> relaid;
    for (const ShownPage& page : shown_.pages()) relaid.push_back(sampler_.shown(page.page));
    shown_ = shown_.with_layouts(std::move(relaid));
  }
  PageFrameKind other_kind() const {
    return sampler_.kind() == PageFrameKind::kVertices ? PageFrameKind::kCorners
                                                       : PageFrameKind::kVertices;
  }

  PageSampler sampler_{GetParam()};
  std::vector<Vec3f> field_;
  ShownPages shown_;
  PageFrameEncoder encoder_{GetParam()};
  FrameReceiver receiver_{small_source()};
  uint32_t revision_ = 0;
  uint64_t sequence_ = 0;  // of the last frame
  size_t refused_ = 0;
  int key_frames_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Kinds, FrameReceiving,
                         testing::Values(PageFrameKind::kVertices, PageFrameKind::kCorners));

TEST_P(FrameReceiving, GivesTheDisplacementOfEachVertexOfTheShownPages) {
  show({3, 0, 5});
  const auto frame = next();
  ASSERT_TRUE(frame);
  EXPECT_THAT(frame->pages, ElementsAre(0, 3, 5));
  EXPECT_TRUE(shows(*frame, sampler_, {0, 3, 5}));
  EXPECT_EQ(frame->find(4), nullptr);
  EXPECT_EQ(frame->number, 1u);
  EXPECT_EQ(frame->largest_move, 2.5f);
  EXPECT_TRUE(frame->is_exact);
}

TEST_P(FrameReceiving, CarriesNothingBeforePagesAreShown) {
  const auto frame = next();
  ASSERT_TRUE(frame);
  EXPECT_THAT(frame->pages, IsEmpty());
  EXPECT_EQ(receive({}), nullptr);
}

TEST_P(FrameReceiving, SaysWhetherValuesAreRounded) {
  show({1});
  const auto frame = receive(encode({2, 2}));
  ASSERT_TRUE(frame);
  EXPECT_FALSE(frame->is_exact);
  EXPECT_FALSE(shows(*frame, sampler_, {1}));
}

TEST_P(FrameReceiving, SharesTheMovesOfPagesThatHaveNotChanged) {
  std::vector<PageId> all;
  for (PageId page = 0; page < sampler_.page_count(); ++page) all.push_back(page);
  show(all);
  const auto before = next();
  std::vector<std::vector<int32_t>> steps;
  for (const PageId page : all)
    steps.emplace_back(sampler_.steps(page).begin(), sampler_.steps(page).end());
  std::mt19937 random(5);
  dab_field(random, 1, field_);
  sampler_.sample(field_);
  const auto after = next();
  ASSERT_TRUE(before && after);
  EXPECT_TRUE(shows(*after, sampler_, all));
  size_t changed = 0;
  for (const PageId page : all) {
    const bool is_same = std::ranges::equal(steps[page], sampler_.steps(page));
    EXPECT_EQ(before->find(page) == after->find(page), is_same) << page;
    changed += is_same ? 0 : 1;
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, all.size());
}

TEST_P(FrameReceiving, TellsAChangedGainOfAPageThatDoesNotMove) {
  show({1, 2});
  const auto before = next();
  std::vector<WantedPage> wanted = sampler_.wanted(shown_);
  wanted[1].gain = 3;
  const EncodedPageFrame frame = encoder_.encode({shown_, wanted, 2.5f}, kStillSteps);
  const auto after = receive({frame.bytes.begin(), frame.bytes.end()});
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->find(1), before->find(1));
  EXPECT_EQ(after->find(2)->gain, 3);
  EXPECT_EQ(before->find(2)->gain, 0);
}

TEST_P(FrameReceiving, LeavesHeldVerticesWhereTheyAre) {
  show({1, 2});
  const auto before = next();
  std::vector<WantedPage> wanted = sampler_.wanted(shown_);
  const size_t bytes = held_bytes(shown_.pages()[1].layout->vertices);
  auto held = std::make_shared<std::vector<uint8_t>>(bytes);
  (*held)[0] = 1 << 5;
  wanted[1].held = held;
  const EncodedPageFrame frame = encoder_.encode({shown_, wanted, 2.5f}, kStillSteps);
  const auto after = receive({frame.bytes.begin(), frame.bytes.end()});
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->find(1), before->find(1));
  std::vector<Vec3f> expected = before->find(2)->displacements;
  EXPECT_FALSE(expected[5].isZero());
  expected[5].setZero();
  EXPECT_EQ(after->find(2)->displacements, expected);
}

TEST_P(FrameReceiving, ReadsFramesFromBeforeAndAfterAChangeOfPages) {
  show({0, 1});
  const std::string first = encode();
  const PageChange change = say({2}, {0});  // the server hears it after the frame
  const auto before = receive(first);
  ASSERT_TRUE(before);
  EXPECT_TRUE(shows(*before, sampler_, {0, 1}));
  shown_ = shown_.changed(change);
  const auto after = next();
  ASSERT_TRUE(after);
  EXPECT_TRUE(shows(*after, sampler_, {1, 2}));
  EXPECT_EQ(receiver_.shown_revision(), 2u);
}

TEST_P(FrameReceiving, GoesOnWithFramesOfTheOtherKind) {
  show({0, 1, 4});
  ASSERT_TRUE(next());
  const PageChange change = say({2}, {1});
  for (const double phase : {1.0, 2.0, 3.0}) {
    move_to(phase);
    change_kind(other_kind());
    const auto key = next();
    ASSERT_TRUE(key);
    EXPECT_TRUE(shows(*key, sampler_, shown_ids()));
    if (phase == 1) {  // the change was on its way while the kind changed
      PageChange heard = sampler_.adding(change.revision, {2});
      heard.removed = {1};
      shown_ = shown_.changed(heard);
    }
    move_to(phase + 0.1);
    const auto delta = next();
    ASSERT_TRUE(delta);
    EXPECT_TRUE(shows(*delta, sampler_, {0, 2, 4}));
  }
  EXPECT_EQ(refused_, 0u);
  EXPECT_EQ(key_frames_, 0);
}

TEST_P(FrameReceiving, RefusesAFrameWhoseReferenceIsLost) {
  show({0, 1});
  const auto first = next();
  move_to(1);
  (void)encode();  // is lost, though the server takes it as received
  encoder_.acknowledge(sequence_);
  move_to(2);
  EXPECT_EQ(next(), nullptr);
  EXPECT_EQ(refused_, 1u);
  const auto frame = next();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(shows(*frame, sampler_, {0, 1}));
  EXPECT_EQ(frame->number, first->number + 1);
}

TEST_P(FrameReceiving, AsksForAKeyFrameAfterADamagedOne) {
  show({0});
  ASSERT_TRUE(next());
  move_to(1);
  std::string damaged = encode();
  damaged[damaged.size() / 2] ^= 0x40;
  EXPECT_EQ(receive(damaged), nullptr);
  EXPECT_EQ(key_frames_, 1);
  const auto frame = next();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(shows(*frame, sampler_, {0}));
}

TEST_P(FrameReceiving, IgnoresAFrameThatComesTwice) {
  show({0});
  const std::string data = encode();
  ASSERT_TRUE(receive(data));
  EXPECT_EQ(receive(data), nullptr);
  EXPECT_EQ(refused_, 0u);
  EXPECT_EQ(key_frames_, 0);
}

TEST_P(FrameReceiving, BeginsWithoutPagesAfterARestart) {
  show({0, 1});
  const auto before = next();
  receiver_.restart();
  encoder_ = PageFrameEncoder(sampler_.kind());
  shown_ = {};
  revision_ = 0;
  const auto empty = next();
  ASSERT_TRUE(empty);
  EXPECT_THAT(empty->pages, IsEmpty());
  show({0, 1});
  const auto after = next();
  ASSERT_TRUE(after);
  EXPECT_TRUE(shows(*after, sampler_, {0, 1}));
  EXPECT_NE(after->find(0), before->find(0));
  EXPECT_EQ(after->number, 3u);
}

TEST_P(FrameReceiving, NeverHasTwoMomentsInOneSurface) {
  std::mt19937 random(7);
  const auto chance = [&](uint32_t percent) { return random() % 100 < percent; };
  show({0});
  uint64_t surfaces = 0;
  for (int i = 0; i < 120; ++i) {
    move_to(0.1 * i);
    const PageId page = random() % sampler_.page_count();
    if (chance(50) && shown_.shows(page)) show({}, {page});
    if (chance(50) && !shown_.shows(page)) show({page});
    if (chance(5)) change_kind(other_kind());
    std::string data = encode();
    if (chance(20)) {
      encoder_.acknowledge(sequence_);
      continue;
    }
    if (chance(10)) data.back() ^= 1;
    const auto frame = receive(data);
    if (!frame) continue;
    ASSERT_TRUE(shows(*frame, sampler_, shown_ids())) << i;
    EXPECT_EQ(frame->number, ++surfaces);
  }
  EXPECT_GT(surfaces, 30u);
}

TEST_P(FrameReceiving, FailsForARevisionThatNobodyAskedFor) {
  shown_ = shown_.changed(sampler_.adding(1, {0}));
  const auto frame = receiver_.receive(encode());
  EXPECT_EQ(frame.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(frame.status().message(), HasSubstr("revision 1"));
}

Welcome welcome_of(int depth, uint64_t fingerprint) {
  Welcome welcome;
  welcome.session.key.depth = depth;
  welcome.pages_fingerprint = fingerprint;
  return welcome;
}

TEST(FrameReceiver, WelcomesOnlyItsOwnPagesAndDepth) {
  FrameSource source = small_source();
  const int depth = source.depth;
  EXPECT_TRUE(FrameReceiver(source).welcome(welcome_of(depth, 7)).is_ok());
  source.pages_fingerprint = 7;
  EXPECT_TRUE(FrameReceiver(source).welcome(welcome_of(depth, 7)).is_ok());
  const Status changed = FrameReceiver(source).welcome(welcome_of(depth, 8));
  EXPECT_EQ(changed.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(changed.message(), HasSubstr("pages have changed"));
  const Status other = FrameReceiver(source).welcome(welcome_of(depth + 1, 7));
  EXPECT_EQ(other.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(other.message(), HasSubstr("depth " + std::to_string(depth + 1)));
}

TEST(FrameReceiver, DoesNotTakeADepthThatIsFinerThanTheLattice) {
  FrameSource source = small_source();
  source.head.grid.bits = source.depth - 1;
  const Status finer = FrameReceiver(source).welcome(welcome_of(source.depth, 0));
  EXPECT_EQ(finer.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(finer.message(), HasSubstr(std::to_string(source.depth - 1) + " bits"));
}

}  // namespace
}  // namespace burnish
