#include "tests/server/live/live_work.h"

#include "common/base/check.h"

namespace burnish {

LiveWork::LiveWork() {
  BURNISH_CHECK(library_.import(sphere_file(), "ball").is_ok(), "import");
  journal_ = std::move(Journal::open(library_.folder->journal())).value();
  SessionManagerOptions options;
  options.solver.backend = BackendKind::kCpu;
  options.solver.threads = 1;
  manager_ =
      std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
          .value();
  BURNISH_CHECK(manager_->open({"ball", "work", {5, 0}}, "ann", {}).is_ok(), "open");
  live_ = std::make_unique<LiveSessions>(*manager_, 0);
}

std::vector<Vec3f> LiveWork::displacement() {
  std::vector<Vec3f> u;
  const auto copy = [&](Session& session) {
    const auto now = session.solver().displacement();
    u.assign(now.begin(), now.end());
    return Status::ok();
  };
  EXPECT_TRUE(manager_->visit("work", {}, copy).is_ok());
  return u;
}

FrameSample LiveWork::sample(LiveGuest& guest) {
  const FrameTarget& target = *guest.subscriber().target;
  return sample_displacement<Vec3f>(*target.layout, target.frame_mesh(), displacement()).value();
}

FrameSample LiveWork::shown(LiveGuest& guest) {
  const FrameLayout& layout = *guest.subscriber().target->layout;
  FrameSample seen;
  seen.steps.resize(size_t{3} * layout.value_count());
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    guest.decoder.state().read_tile(tile, {seen.steps.data() + size_t{3} * layout.tile_begin(tile),
                                           size_t{3} * layout.tile_size(tile)});
  return seen;
}

}  // namespace burnish
