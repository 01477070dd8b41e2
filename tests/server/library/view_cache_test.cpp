#include "server/library/view_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/frame_codec/frame_layout.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

std::shared_ptr<const PackedView> view_of(size_t bytes) {
  return std::make_shared<PackedView>(PackedView{.bytes = std::vector<uint8_t>(bytes)});
}

TEST(ViewCache, KeepsWhatWasUsedLastWithinItsBytes) {
  ViewCache cache(100);
  cache.add({"a", {5, 0}, 0}, view_of(40));
  cache.add({"b", {5, 0}, 0}, view_of(40));
  EXPECT_TRUE(cache.find({"a", {5, 0}, 0}));
  cache.add({"c", {5, 0}, 0}, view_of(40));
  EXPECT_TRUE(cache.find({"a", {5, 0}, 0}));
  EXPECT_FALSE(cache.find({"b", {5, 0}, 0}));
  EXPECT_TRUE(cache.find({"c", {5, 0}, 0}));
  EXPECT_EQ(cache.byte_count(), 80u);
}

TEST(ViewCache, TellsDepthsRadiiAndProxiesApart) {
  ViewCache cache(100);
  cache.add({"a", {5, 0}, 10}, view_of(40));
  EXPECT_FALSE(cache.find({"a", {6, 0}, 10}));
  EXPECT_FALSE(cache.find({"a", {5, 0.1}, 10}));
  EXPECT_FALSE(cache.find({"a", {5, 0}, 11}));
}

TEST(ViewCache, DoesNotKeepAViewAboveItsBytes) {
  ViewCache cache(100);
  cache.add({"a", {5, 0}, 0}, view_of(40));
  cache.add({"b", {5, 0}, 0}, view_of(101));
  EXPECT_TRUE(cache.find({"a", {5, 0}, 0}));
  EXPECT_FALSE(cache.find({"b", {5, 0}, 0}));
}

TEST(MeshStoreView, GivesTheFrameLayoutOfThePreparedMesh) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto packed = library.store->open_view(scan.id, {5, 0}, 0, {}).value();
  const View view = read_view(packed->bytes).value();
  const auto mesh = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  const SparseGrid& grid = mesh->hierarchy->at(mesh->hierarchy->finest).grid;
  EXPECT_EQ(make_smaller_layout({view.grid, view.points}).fingerprint,
            make_smaller_layout({grid, mesh->prepared->evaluation}).fingerprint);
}

TEST(MeshStoreView, IsMadeOnceForAllClients) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(1, 4), "ball").value().scan;
  const auto first = library.store->open_view(scan.id, {5, 0}, 2000, {}).value();
  EXPECT_EQ(library.store->open_view(scan.id, {5, 0}, 2000, {}).value(), first);
  EXPECT_LE(first->triangles, 2000u);
  EXPECT_EQ(first->scan_triangles, 5120u);
}

TEST(MeshStoreView, OfCloseWishesIsOne) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(1, 4), "ball").value().scan;
  const auto first = library.store->open_view(scan.id, {5, 0}, 2048, {}).value();
  for (uint64_t more = 1; more < 60; ++more)
    EXPECT_EQ(library.store->open_view(scan.id, {5, 0}, 2048 + more, {}).value(), first);
  EXPECT_NE(library.store->open_view(scan.id, {5, 0}, 4096, {}).value(), first);
}

TEST(MeshStoreView, CountsInTheMemoryAndGivesWayWhenOthersNeedIt) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(1, 4), "ball").value().scan;
  Quota& memory = library.store->memory();
  ASSERT_EQ(memory.taken(), 0u);
  uint64_t bytes = library.store->open_view(scan.id, {5, 0}, 0, {}).value()->bytes.size();
  EXPECT_GE(memory.taken(), bytes);
  EXPECT_TRUE(memory.take(kServer, memory.max()).is_ok());
  EXPECT_EQ(memory.taken(), 0u);

  const auto held = library.store->open_view(scan.id, {5, 0}, 0, {}).value();
  EXPECT_FALSE(memory.take(kServer, memory.max()).is_ok()) << "somebody is being sent it";
  EXPECT_GE(memory.taken(), bytes);
}

TEST(MeshStoreView, OfADepthThatNobodyPreparedIsRefused) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const Status status = library.store->open_view(scan.id, {6, 0}, 0, {}).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), testing::HasSubstr("is not prepared at depth 6"));
}

TEST(MeshStoreView, CanBeCancelledAndHasToFitTheMemory) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  library.restart({.memory_bytes_max = 1000});
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_EQ(library.store->open_view(scan.id, {5, 0}, 0, cancel).status().code(),
            StatusCode::kCancelled);
  EXPECT_EQ(library.store->open_view(scan.id, {5, 0}, 0, {}).status().code(),
            StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish
