#include <cmath>

#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/manager/session_manager.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

class SessionMeasures : public testing::Test {
 protected:
  SessionMeasures() {
    EXPECT_TRUE(library_.import(sphere_file(3), "ball", {}, 5).is_ok());
    journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
    SessionManagerOptions options;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
            .value();
    EXPECT_TRUE(manager_->open({"ball", "one", {5, 0}}, {}, {}).is_ok());
  }

  /// Smooths all, which makes a sphere smaller, and solves.
  ExportSummary smoothed() {
    const std::vector<Edit> edits = {{"a", SetGradientScale{0}},
                                     {"b", SetTransferCurve{TransferCurve{2}}}};
    EXPECT_TRUE(manager_->apply("one", {}, edits, {}).is_ok());
    ExportWish wish{MeshFormat::kPly, true, 0};
    wish.deviation = true;
    return manager_->export_mesh("one", wish, {}).value()->summary();
  }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
};

TEST_F(SessionMeasures, AnUneditedSessionHasNotMoved) {
  const auto measured = manager_->deviation("one", {});
  ASSERT_TRUE(measured.is_ok()) << measured.status().message();
  EXPECT_TRUE(measured->deviation.is_zero());
}

TEST_F(SessionMeasures, ASmoothedSphereMovesInwards) {
  const ExportSummary summary = smoothed();
  ASSERT_TRUE(summary.deviation);
  EXPECT_EQ(summary.edits, 2u);
  EXPECT_GT(summary.deviation->inward_max, 0);
  EXPECT_LT(summary.deviation->volume_after, summary.deviation->volume_before);
  const auto measured = manager_->deviation("one", {});
  EXPECT_TRUE(measured->settled);
  EXPECT_EQ(measured->deviation.max, summary.deviation->max);
}

TEST_F(SessionMeasures, AnExportIsMeasuredOnlyIfAskedFor) {
  const auto file = manager_->export_mesh("one", {MeshFormat::kPly, false, 1}, {});
  EXPECT_FALSE(file.value()->summary().deviation);
}

TEST_F(SessionMeasures, ASectionShowsBothSurfaces) {
  smoothed();
  const auto section = manager_->section({"one", Plane{}}, {});
  ASSERT_TRUE(section.is_ok()) << section.status().message();
  ASSERT_EQ(section->original.size(), 1u);
  ASSERT_EQ(section->edited.size(), 1u);
  EXPECT_TRUE(section->edited[0].is_closed());
  EXPECT_LT(section->edited[0].points[0].norm(), section->original[0].points[0].norm());
}

TEST_F(SessionMeasures, AnUnknownSessionIsNotFound) {
  EXPECT_EQ(manager_->deviation("none", {}).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(manager_->section({"none", Plane{}}, {}).status().code(), StatusCode::kNotFound);
}

TEST_F(SessionMeasures, WithoutMemoryForACopyNothingIsMeasured) {
  const auto all = library_.store->memory().take(
      kServer, library_.store->memory().max() - library_.store->memory().taken());
  ASSERT_TRUE(all.is_ok());
  EXPECT_EQ(manager_->deviation("one", {}).status().code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish
