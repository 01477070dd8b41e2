#include "tests/server/live/live_work.h"

#include "common/base/check.h"
#include "server/journal/sqlite_journal.h"

namespace burnish {

LiveWork::LiveWork() {
  BURNISH_CHECK(library_.import(sphere_file(), "ball").is_ok(), "import");
  journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
  SessionManagerOptions options;
  options.solver.backend = BackendKind::kCpu;
  options.solver.threads = 1;
  manager_ =
      std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
          .value();
  BURNISH_CHECK(manager_->open({"ball", "work", {5, 0}}, "ann", {}).is_ok(), "open");
  live_ = std::make_unique<LiveSessions>(*manager_, 0);
}

std::vector<Vec3f> LiveWork::displacement(const std::string& session) {
  std::vector<Vec3f> u;
  const auto copy = [&](Session& live) {
    const auto now = live.solver().displacement();
    u.assign(now.begin(), now.end());
    return Status::ok();
  };
  EXPECT_TRUE(manager_->visit(session, {}, copy).is_ok());
  return u;
}

std::vector<int32_t> LiveWork::sample(LiveGuest& guest) {
  const std::string& session = guest.welcome.session.name;
  const auto mesh = manager_->attach(session, {}).value().mesh;
  const SparseGrid& grid = mesh->hierarchy->at(mesh->hierarchy->finest).grid;
  std::vector<std::shared_ptr<const PageEvaluation>> pages;
  for (const PageTile& tile : guest.pages.state().tiles)
    pages.push_back(std::make_shared<const PageEvaluation>(
        make_page_evaluation(guest.pages.page(tile.shown.page), guest.pages.head().grid.bits, grid,
                             guest.pages.kind())));
  std::vector<int32_t> values;
  const auto samples = sample_pages(grid, pages, displacement(session));
  for (const PageSample& page : samples.value())
    values.insert(values.end(), page.steps.begin(), page.steps.end());
  return values;
}

}  // namespace burnish
