#include "server/session/previews.h"

#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"

namespace burnish {
namespace {

std::shared_ptr<const PreparedMesh> prepared_sphere() {
  PrepareOptions options;
  options.depth = 4;
  return *prepare(make_icosphere(2, 1), options);
}

/// Everything that a solver would see.
struct Cells {
  explicit Cells(const Fields& fields) : alphas(fields.alphas()) {
    const std::span<const float> of_cells = fields.view().beta;
    beta.assign(of_cells.begin(), of_cells.end());
  }
  bool operator==(const Cells&) const = default;
  CellAlphas alphas;
  std::vector<float> beta;
};

class PreviewsTest : public testing::Test {
 protected:
  Cells shown() {
    EditEffects changes = edited_.take_changes();
    return Cells(previews_.over(edited_.fields(), changes));
  }
  void apply(const std::string& author, Edit edit) {
    const AuthoredEdit authored{author, 0, std::move(edit)};
    ASSERT_TRUE(edited_.apply({&authored, 1}).is_ok());
  }

  std::shared_ptr<const PreparedMesh> prepared_ = prepared_sphere();
  EditedFields edited_{*prepared_};
  Previews previews_;
  const Brush brush_{0.4, 0.7, 0.2, FallOff::kSmooth};
};

TEST_F(PreviewsTest, ShowWhatTheEditWouldDoAndDroppedTheyAreGone) {
  const Cells before = shown();
  previews_.show(1, {"ann", "a", SetGradientScale{0.25}});
  EXPECT_TRUE(previews_.is_changed());
  const Cells during = shown();
  EXPECT_EQ(Cells(previews_.shown(edited_.fields())), during);
  previews_.drop(1);
  EXPECT_EQ(shown(), before);
  EXPECT_FALSE(previews_.is_changed());
  apply("ann", {"a", SetGradientScale{0.25}});
  EXPECT_EQ(shown(), during);
}

TEST_F(PreviewsTest, AStrokeThatGrowsEndsAsTheWholeStroke) {
  Stroke stroke{brush_, {}};
  for (int i = 0; i < 20; ++i) {
    stroke.path.push_back({std::cos(0.07 * i), std::sin(0.07 * i), 0.01 * i});
    previews_.show(1, {"ann", "a", stroke});
    (void)shown();
  }
  const Cells grown = shown();
  previews_.drop(1);
  apply("ann", {"a", stroke});
  const Cells whole = shown();
  for (size_t c = 0; c < whole.beta.size(); ++c) EXPECT_NEAR(grown.beta[c], whole.beta[c], 1e-5);
}

TEST_F(PreviewsTest, OfSlidersTheLastOneMovedCounts) {
  previews_.show(1, {"ann", "a", SetGradientScale{0.25}});
  previews_.show(2, {"bob", "b", SetGradientScale{0.5}});
  EXPECT_EQ(shown().beta[0], 0.5f);
  previews_.show(1, {"ann", "a", SetGradientScale{0.75}});
  EXPECT_EQ(shown().beta[0], 0.75f);
  previews_.drop(1);
  EXPECT_EQ(shown().beta[0], 0.5f);
}

TEST_F(PreviewsTest, SlidersLeaveTheMetricAlone) {
  (void)shown();
  previews_.show(1, {"ann", "a", SetGradientScale{0.25}});
  EditEffects changes;
  (void)previews_.over(edited_.fields(), changes);
  EXPECT_TRUE(changes.beta);
  EXPECT_FALSE(changes.metric);
}

TEST_F(PreviewsTest, SetAsideTheyComeBack) {
  (void)shown();
  previews_.show(1, {"ann", "a", SetTransferCurve{TransferCurve(20)}});
  const Cells during = shown();
  EXPECT_TRUE(previews_.set_aside().metric);
  EXPECT_TRUE(previews_.is_changed());
  EXPECT_EQ(shown(), during);
}

/// Several users who drag, drop, apply and undo at random, next to a plain replay of their edits.
class Crowd {
 public:
  Crowd(const PreparedMesh& prepared, uint64_t seed)
      : edited(prepared), plain(prepared), random_(seed) {}

  void step() {
    const uint64_t user = 1 + pick(3);
    const auto mine = gestures.find(user);
    const int what = pick(10);
    if (what < 6) return drag(user);
    if (what < 8 && mine != gestures.end()) return apply(user, mine->second);
    if (what < 9) return undo(user);
    gestures.erase(user);
    previews.drop(user);
  }

  EditedFields edited, plain;
  Previews previews;
  std::map<uint64_t, Gesture> gestures;

 private:
  int pick(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
  Vec3d point() {
    const double angle = 0.1 * pick(60);
    return {std::cos(angle), std::sin(angle), 0};
  }
  std::string new_id() { return "edit" + std::to_string(++last_id_); }

  void drag(uint64_t user) {
    const auto [mine, is_new] = gestures.try_emplace(user);
    Gesture& gesture = mine->second;
    if (is_new || pick(4) == 0) {
      gesture = {"user" + std::to_string(user), new_id(), {}};
      if (pick(3) == 0) gesture.change = SetTransferCurve{TransferCurve(10.0 + pick(90))};
      if (pick(2) == 0) gesture.change = Stroke{{0.4, 0.7, 0.2, FallOff::kSmooth}, {point()}};
    }
    if (auto* stroke = std::get_if<Stroke>(&gesture.change)) stroke->path.push_back(point());
    if (auto* slider = std::get_if<SetGradientScale>(&gesture.change))
      slider->beta = 0.1 * pick(20);
    previews.show(user, gesture);
  }

  void apply(uint64_t user, const Gesture& gesture) {
    const auto as_edit = [](const auto& change) { return decltype(Edit::change)(change); };
    const AuthoredEdit edit{
        gesture.author, 0, {gesture.edit_id, std::visit(as_edit, gesture.change)}};
    for (EditedFields* fields : {&edited, &plain}) EXPECT_TRUE(fields->apply({&edit, 1}).is_ok());
    gestures.erase(user);
    previews.drop_applied(edited.history());
  }

  void undo(uint64_t user) {
    const AuthoredEdit edit{"user" + std::to_string(user), 0, {new_id(), Undo{}}};
    EXPECT_EQ(edited.apply({&edit, 1}).is_ok(), plain.apply({&edit, 1}).is_ok());
  }

  std::mt19937_64 random_;
  int last_id_ = 0;
};

TEST_F(PreviewsTest, LeaveTheFieldsOfAPlainReplayBitForBit) {
  size_t quiet_steps = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    Crowd crowd(*prepared_, seed);
    for (int step = 0; step < 60; ++step) {
      crowd.step();
      EditEffects changes = crowd.edited.take_changes();
      const Cells seen(crowd.previews.over(crowd.edited.fields(), changes));
      const Cells replayed(crowd.plain.fields());
      ASSERT_EQ(Cells(crowd.edited.fields()), replayed) << "seed " << seed;
      ASSERT_EQ(crowd.edited.fields().painted(), crowd.plain.fields().painted());
      if (!crowd.gestures.empty()) continue;
      ++quiet_steps;
      ASSERT_EQ(seen, replayed) << "seed " << seed;
    }
  }
  EXPECT_GT(quiet_steps, 100u);
}

}  // namespace
}  // namespace burnish
