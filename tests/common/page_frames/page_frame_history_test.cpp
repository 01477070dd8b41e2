#include <map>

#include <gtest/gtest.h>

#include "common/page_frames/page_corners.h"
#include "common/page_frames/page_frame_decoder.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

/// A link that loses, delays and reorders frames and acknowledgements, while the client shows and
/// hides pages and the surface moves.
class LossyPageLink {
 public:
  LossyPageLink(PageFrameKind kind, unsigned seed)
      : random_(seed),
        sampler_(kind),
        encoder_(kind),
        decoder_(kind),
        field_(wavy_field(2, seed)) {}

  void run(int events) {
    for (int event = 0; event < events; ++event) {
      const unsigned what = random_() % 12;
      if (what < 1)
        change_pages();
      else if (what < 5)
        send();
      else if (what < 10)
        deliver_frame();
      else
        deliver_acknowledgement();
      if (random_() % 50 == 0) reconnect();
    }
  }

  int decoded() const { return decoded_; }
  int refused() const { return refused_; }
  int shared_vertices() const { return shared_vertices_; }

 private:
  struct OnTheWay {
    EncodedPageFrame frame;
    std::vector<int32_t> held;    // the client's state in the view of the encoder
    std::vector<int32_t> wanted;  // rounded to the frame's step
  };

  void change_pages() {
    const ShownPages& newest = decoder_.newest_shown();
    PageChange change{.revision = newest.revision() + 1};
    for (PageId page = 0; page < sampler_.page_count(); ++page) {
      if (random_() % 5 != 0) continue;
      if (newest.shows(page))
        change.removed.push_back(page);
      else
        change.added.push_back(sampler_.shown(page));
    }
    if (decoder_.show(change, sampler_.page_count()).is_ok()) changes_.push_back(change);
  }

  void move_surface() {
    if (random_() % 4 == 0) field_ = wavy_field(2 + 0.1 * (random_() % 10), 0.1 * (random_() % 9));
    if (random_() % 2 == 0) dab_field(random_, random_() % 20 == 0 ? 1000 : 1, field_);
    sampler_.sample(field_);
  }

  StepChoice any_steps() {
    if (random_() % 4 == 0) return kStillSteps;
    const int finest = static_cast<int>(random_() % 4);
    return {finest, 7, random_() % 3 == 0 ? 3000 : SIZE_MAX};
  }

  void send() {
    // The server hears of changes in order and late.
    while (!changes_.empty() && random_() % 2 == 0) {
      shown_ = shown_.changed(changes_.front());
      changes_.pop_front();
    }
    move_surface();
    EncodedPageFrame frame = encoder_.encode({shown_, sampler_.wanted(shown_)}, any_steps());
    std::vector<int32_t> wanted;
    for (const ShownPage& page : shown_.pages()) {
      const auto values = rounded(sampler_.steps(page.page), frame.step_shift);
      wanted.insert(wanted.end(), values.begin(), values.end());
    }
    auto held = values_of(*encoder_.sent_state(frame.sequence));
    frames_.push_back({std::move(frame), std::move(held), std::move(wanted)});
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
    const PageFrameState before = decoder_.state();
    const auto decoded = decoder_.decode(arrived.frame.bytes);
    if (!decoded.is_ok()) return expect_refused(arrived, decoded.status(), before);
    ++decoded_;
    acknowledgements_.push_back(decoded->sequence);
    EXPECT_EQ(values_of(decoder_.state()), arrived.held);
    EXPECT_EQ(arrived.held, arrived.wanted);
    expect_changed(*decoded, before);
    expect_no_cracks();
  }

  void expect_refused(const OnTheWay& arrived, const Status& status, const PageFrameState& before) {
    EXPECT_EQ(values_of(decoder_.state()), values_of(before));
    if (status.code() == StatusCode::kFailedPrecondition) {
      ++refused_;
      encoder_.refuse(arrived.frame.sequence);
    } else {
      EXPECT_EQ(status.code(), StatusCode::kAlreadyExists) << status.message();
    }
  }

  void expect_changed(const DecodedPageFrame& frame, const PageFrameState& before) {
    for (const PageTile& tile : decoder_.state().tiles) {
      if (std::ranges::count(frame.changed_pages, tile.shown.page) > 0) continue;
      const PageTile* old = before.find(tile.shown.page);
      ASSERT_NE(old, nullptr);
      std::vector<int32_t> values(tile.value_count()), old_values(tile.value_count());
      tile.read(values);
      old->read(old_values);
      EXPECT_EQ(values, old_values);
    }
  }

  // Each vertex of several shown pages has the same bits in all of them.
  void expect_no_cracks() {
    std::map<std::array<int, 3>, Vec3f> seen;
    for (const PageTile& tile : decoder_.state().tiles) {
      const auto& positions = small_pages().pages[tile.shown.page].positions;
      const std::vector<Vec3f> displacements = drawn(tile, positions);
      for (size_t v = 0; v < positions.size(); ++v) {
        const auto& q = positions[v];
        const auto [at, is_new] = seen.emplace(std::array{q.x(), q.y(), q.z()}, displacements[v]);
        if (is_new) continue;
        ++shared_vertices_;
        ASSERT_EQ(at->second, displacements[v]) << "page " << tile.shown.page << " vertex " << v;
      }
    }
  }

  std::vector<Vec3f> drawn(const PageTile& tile, const std::vector<Vec3i>& positions) const {
    std::vector<Vec3f> values(tile.shown.value_count());
    tile.read_displacements(values);
    if (sampler_.kind() == PageFrameKind::kVertices) return values;
    const int bits = small_pages().lattice.bits, depth = small_pages().grid.depth;
    std::vector<Vec3f> displacements(positions.size());
    evaluate_page(make_page_corners(positions, bits, depth), positions, bits, depth, values,
                  displacements);
    return displacements;
  }

  void deliver_acknowledgement() {
    if (acknowledgements_.empty()) return;
    const uint64_t sequence = take_any(acknowledgements_);
    if (random_() % 8 != 0) encoder_.acknowledge(sequence);
  }

  // The link breaks; the client may lose what it holds, but knows what it shows.
  void reconnect() {
    frames_.clear();
    acknowledgements_.clear();
    for (; !changes_.empty(); changes_.pop_front()) shown_ = shown_.changed(changes_.front());
    if (random_() % 2 == 0) decoder_ = PageFrameDecoder(sampler_.kind(), shown_);
    if (random_() % 3 == 0) encoder_.request_key_frame();
  }

  std::mt19937 random_;
  PageSampler sampler_;
  PageFrameEncoder encoder_;
  PageFrameDecoder decoder_;
  std::vector<Vec3f> field_;
  ShownPages shown_;                // at the server
  std::deque<PageChange> changes_;  // on the way to the server
  std::vector<OnTheWay> frames_;
  std::vector<uint64_t> acknowledgements_;
  int decoded_ = 0;
  int refused_ = 0;
  int shared_vertices_ = 0;
};

class PageFrameHistory : public testing::TestWithParam<PageFrameKind> {};

TEST_P(PageFrameHistory, SharedVerticesAreEqualAndRoundedWhateverTheLinkLoses) {
  int decoded = 0, refused = 0, shared_vertices = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    LossyPageLink link(GetParam(), seed);
    link.run(250);
    decoded += link.decoded();
    refused += link.refused();
    shared_vertices += link.shared_vertices();
  }
  EXPECT_GT(decoded, 150);
  EXPECT_GT(refused, 3);
  EXPECT_GT(shared_vertices, 10000);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PageFrameHistory,
                         testing::Values(PageFrameKind::kVertices, PageFrameKind::kCorners));

}  // namespace
}  // namespace burnish
