#include "server/library/preparing_line.h"

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

constexpr PreparedKey kPrepared{5, 0};

/// Gives up as soon as it has to wait in line.
bool is_not_waiting(std::string_view phase, double) {
  return !phase.starts_with("waiting");
}

TEST(PreparingLine, ASmallScanHasATurnBesideALargeOneAndAnotherLargeOneWaits) {
  PreparingLine line;
  const auto large = line.wait({"ann", "wall", false}, {});
  EXPECT_TRUE(line.wait({"bob", "coin", true}, is_not_waiting).is_ok());
  EXPECT_EQ(line.wait({"bob", "dome", false}, is_not_waiting).status().code(),
            StatusCode::kCancelled);
  const auto small = line.wait({"bob", "coin", true}, {});
  EXPECT_EQ(line.wait({"cleo", "ring", true}, is_not_waiting).status().code(),
            StatusCode::kCancelled);
}

TEST(PreparingLine, TheSameScanHasOneTurnAtATime) {
  PreparingLine line;
  const auto turn = line.wait({"bob", "coin", false}, {});
  EXPECT_EQ(line.wait({"bob", "coin", true}, is_not_waiting).status().code(),
            StatusCode::kCancelled);
}

TEST(PreparingLine, AUserHasOnePlaceAmongTheLargeScansAndOneAmongTheSmall) {
  PreparingLine line;
  const auto wall = line.wait({"ann", "wall", false}, {});
  EXPECT_FALSE(line.wait({"ann", "dome", false}, is_not_waiting).is_ok());
  const auto coin = line.wait({"ann", "coin", true}, is_not_waiting);
  EXPECT_TRUE(coin.is_ok());
  EXPECT_FALSE(line.wait({"ann", "ring", true}, is_not_waiting).is_ok());
}

TEST(PreparingLine, WhoAsksForManyLetsOthersPassAfterOne) {
  PreparingLine line;
  std::optional wall(line.wait({"ann", "wall", false}, {}).value());
  std::vector<std::string> prepared;
  std::promise<void> is_in_line;
  std::thread later([&, asked = 0]() mutable {
    const auto dome = line.wait({"ann", "dome", false}, [&](std::string_view, double) {
      if (++asked == 2) is_in_line.set_value();
      return true;
    });
    prepared.push_back("dome");
  });
  is_in_line.get_future().wait();
  {
    const auto coin = line.wait({"bob", "coin", false}, [&, asked = 0](auto, double) mutable {
      if (++asked == 2) wall.reset();
      return true;
    });
    prepared.push_back("coin");
  }
  later.join();
  EXPECT_EQ(prepared, (std::vector<std::string>{"coin", "dome"}));
}

TEST(PreparingLine, WhoSeemedSmallAndTakesLongWaitsWithTheLargeOnes) {
  std::chrono::steady_clock::time_point now;
  PreparingLine line([&] { return now; });
  auto needles = line.wait({"ann", "needles", true}, {}).value();
  const Progress progress = needles.progress({});
  now += PreparingLine::kSmallMax - std::chrono::seconds(1);
  EXPECT_TRUE(progress("measuring", 0));
  EXPECT_FALSE(line.wait({"bob", "coin", true}, is_not_waiting).is_ok());
  now += std::chrono::seconds(1);
  EXPECT_TRUE(progress("measuring", 0)) << "no large one is prepared";
  EXPECT_TRUE(line.wait({"bob", "coin", true}, is_not_waiting).is_ok());
  EXPECT_TRUE(line.wait({"ann", "coin", true}, is_not_waiting).is_ok());
  EXPECT_FALSE(line.wait({"ann", "wall", false}, is_not_waiting).is_ok());
}

TEST(PreparingLine, WhoWaitsWithTheLargeOnesCanBeCancelled) {
  std::chrono::steady_clock::time_point now;
  PreparingLine line([&] { return now; });
  const auto wall = line.wait({"ann", "wall", false}, {});
  auto needles = line.wait({"ann", "needles", true}, {}).value();
  now += PreparingLine::kSmallMax;
  EXPECT_FALSE(needles.progress(is_not_waiting)("measuring", 0));
}

/// Returns a small sphere after so many bytes of comments.
std::string padded_sphere_file(size_t bytes) {
  const TemporaryFolder folder;
  const auto path = folder / "sphere.obj";
  EXPECT_TRUE(write_mesh(make_icosphere(1, 1.0), path).is_ok());
  std::string comments(bytes, 'x');
  for (size_t i = 0; i + 2 < bytes; i += 80) comments.replace(i, 2, "\n#");
  return comments + '\n' + content_of(path);
}

/// Runs `meanwhile` once, while the library prepares a scan that it takes for a large or small one.
void while_it_prepares(TestLibrary& library, size_t file_bytes,
                       const std::function<void()>& meanwhile) {
  bool is_done = false;
  const auto progress = [&](std::string_view, double) {
    if (!std::exchange(is_done, true)) meanwhile();
    return true;
  };
  const auto imported =
      library.import(padded_sphere_file(file_bytes), "other", progress, 5, MeshFormat::kObj);
  EXPECT_TRUE(imported.is_ok()) << imported.status().message();
  EXPECT_TRUE(is_done);
}

constexpr size_t kLarge = size_t{12} << 20;
constexpr size_t kSmall = 1000;

TEST(PreparingScans, ASmallScanIsImportedWhileALargeOneIs) {
  TestLibrary library;
  while_it_prepares(library, kLarge, [&] {
    const auto ball = library.import(sphere_file(), "ball", is_not_waiting);
    ASSERT_TRUE(ball.is_ok()) << ball.status().message();
    const auto mesh = library.store->open_mesh(ball->scan.id, kPrepared, is_not_waiting);
    EXPECT_TRUE(mesh.is_ok()) << mesh.status().message();
  });
  EXPECT_EQ(library.store->list().size(), 2u);
}

TEST(PreparingScans, ALargeOneWaitsForALargeOne) {
  TestLibrary library;
  while_it_prepares(library, kLarge, [&] {
    const auto second = library.import(padded_sphere_file(kLarge + 1), "second", is_not_waiting, 5,
                                       MeshFormat::kObj);
    EXPECT_EQ(second.status().code(), StatusCode::kCancelled);
  });
}

TEST(PreparingScans, WithLittleMemoryASmallScanWaitsForALargeOne) {
  TestLibrary library;
  const Quota::Share taken =
      library.store->memory().take(kServer, library.store->memory().max() - (1 << 28)).value();
  while_it_prepares(library, kLarge, [&] {
    const auto second = library.import(padded_sphere_file(kLarge / 3), "second", is_not_waiting, 5,
                                       MeshFormat::kObj);
    EXPECT_EQ(second.status().code(), StatusCode::kCancelled);
  });
}

TEST(PreparingScans, WhatIsPreparedAndKeptWaitsForNobody) {
  TestLibrary library;
  const ScanInfo ball = library.import(sphere_file(), "ball")->scan;
  {
    const auto made = library.store->open_mesh(ball.id, kPrepared, {}).value();
    library.store->keep_hierarchy(ball.id, kPrepared, made).wait();
  }
  while_it_prepares(library, kSmall, [&] {
    EXPECT_TRUE(library.store->prepare_scan(ball.id, kPrepared, is_not_waiting).is_ok());
    const auto mesh = library.store->open_mesh(ball.id, kPrepared, is_not_waiting);
    ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
    EXPECT_TRUE((*mesh)->is_kept);
    EXPECT_EQ(library.store->prepare_scan(ball.id, {6, 0}, is_not_waiting).code(),
              StatusCode::kCancelled);
  });
}

}  // namespace
}  // namespace burnish
