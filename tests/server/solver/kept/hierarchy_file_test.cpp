#include "server/solver/kept/hierarchy_file.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/common/temporary_folder.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/hierarchy_bytes.h"
#include "tests/server/solver/kept/sealed_hierarchy.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr uint64_t kFingerprint = 0x1234567890abcdef;

/// A scan's hierarchy in a file.
class FileOfAHierarchy {
 public:
  FileOfAHierarchy(const TriangleMesh& mesh, int depth) : on(TestSystem(mesh, depth)) {
    EXPECT_TRUE(write_hierarchy(on, kFingerprint, path).is_ok());
  }

  Result<Multigrid> read(uint64_t fingerprint = kFingerprint) const {
    return read_hierarchy(path, on.prepared, fingerprint);
  }

  std::vector<uint8_t> bytes() const {
    const std::string content = content_of(path);
    return {content.begin(), content.end()};
  }

  Status read_changed(std::span<const uint8_t> bytes) const {
    folder.write("changed", {bytes.begin(), bytes.end()});
    return read_hierarchy(folder / "changed", on.prepared, kFingerprint).status();
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "kept.hierarchy";
  Multigrid on;
};

/// Small, with sheets in one place, small components, ties and irregular rows.
const FileOfAHierarchy& awkward() {
  static const FileOfAHierarchy file(reference::small_components_over_a_sphere(), 5);
  return file;
}

void expect_same_bits(const TriangleMesh& mesh, int depth) {
  const FileOfAHierarchy file(mesh, depth);
  const auto read = file.read();
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_TRUE(HierarchyBytes::of(*read->hierarchy) == HierarchyBytes::of(*file.on.hierarchy));
  EXPECT_TRUE(HierarchyBytes::of(*read->plan) == HierarchyBytes::of(*file.on.plan));
  EXPECT_LE(read->hierarchy->byte_count(), file.on.hierarchy->byte_count());
}

TEST(HierarchyFile, HasTheBitsOfASmoothScan) {
  expect_same_bits(generate_scan({"blob", 40'000}).value(), 7);
}

TEST(HierarchyFile, HasTheBitsOfSheetsKeptApart) {
  expect_same_bits(reference::two_near_sheets(120, 0.004), 7);
}

TEST(HierarchyFile, HasTheBitsOfASoup) {
  expect_same_bits(reference::shaken_soup(reference::bumped_sheet(40), 0.01), 6);
}

TEST(HierarchyFile, HasTheBitsOfSmallComponentsAndTheirPatches) {
  EXPECT_GT(awkward().on.hierarchy->small_components.count(), 0);
  expect_same_bits(reference::small_components_over_a_sphere(), 5);
  expect_same_bits(reference::sphere_with_debris(3), 6);
}

TEST(HierarchyFile, HasTheBitsOfAScanOfOneDepth) {
  expect_same_bits(reference::needles(), 4);
}

TEST(HierarchyFile, OfTheSameScanHasTheSameBytesAndTheLengthThatIsForetold) {
  const FileOfAHierarchy again(reference::small_components_over_a_sphere(), 5);
  EXPECT_TRUE(again.bytes() == awkward().bytes());
  EXPECT_EQ(again.bytes().size(), hierarchy_file_bytes(again.on));
}

TEST(HierarchyFile, OfAnotherPreparedMeshOrReleaseIsRefused) {
  const Status status = awkward().read(kFingerprint + 1).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), HasSubstr("another prepared mesh"));
  EXPECT_NE(hierarchy_fingerprint(1), hierarchy_fingerprint(2));
}

TEST(HierarchyFile, AFlippedBitInEachArrayIsFound) {
  const std::vector<uint8_t> good = awkward().bytes();
  for (const SectionEntry& section : table_of_file(good)) {
    if (section.count == 0) continue;
    std::vector<uint8_t> bad = good;
    bad[section.offset + section.count * section.element_bytes / 2] ^= 4;
    const Status status = awkward().read_changed(bad);
    EXPECT_EQ(status.code(), StatusCode::kDataLoss) << section.id;
    EXPECT_THAT(status.message(), HasSubstr("section " + std::to_string(section.id) + ","));
  }
}

TEST(HierarchyFile, AFlippedBitInHeaderAndTableIsFound) {
  const std::vector<uint8_t> good = awkward().bytes();
  const size_t end = sizeof(HierarchyHeader) + table_of_file(good).size() * sizeof(SectionEntry);
  for (size_t at = 0; at < end; at += at < sizeof(HierarchyHeader) ? 1 : 97) {
    std::vector<uint8_t> bad = good;
    bad[at] ^= 1;
    EXPECT_EQ(awkward().read_changed(bad).code(), StatusCode::kDataLoss) << at;
  }
}

TEST(HierarchyFile, ATruncatedOrLongerFileIsFound) {
  std::vector<uint8_t> bytes = awkward().bytes();
  bytes.push_back(0);
  EXPECT_EQ(awkward().read_changed(bytes).code(), StatusCode::kDataLoss);
  for (size_t size = bytes.size() - 2; size > 0; size /= 3)
    EXPECT_EQ(awkward().read_changed(std::span(bytes).first(size)).code(), StatusCode::kDataLoss)
        << size;
  EXPECT_EQ(awkward().read_changed({}).code(), StatusCode::kDataLoss);
}

TEST(HierarchyFile, CountsThatTheFileHasNoRoomForAreRefusedBeforeTheyAreAllocated) {
  const std::vector<uint8_t> good = awkward().bytes();
  for (const uint64_t count : {uint64_t{1} << 40, ~uint64_t{0}}) {
    std::vector<uint8_t> bad = good;
    SectionEntry entry = table_of_file(good)[0];
    entry.count = count;
    std::memcpy(bad.data() + sizeof(HierarchyHeader), &entry, sizeof entry);
    seal_hierarchy(bad);
    EXPECT_THAT(awkward().read_changed(bad).message(), HasSubstr(std::to_string(count)));
  }
}

/// The arrays whose values lead nowhere: a tile without a halo may be called wide.
std::set<std::string> free_arrays() {
  return {"points", "wide tiles", "weights of coarse corners", "weights of the restriction"};
}

TEST(HierarchyFile, AnIndexOutsideItsArrayIsFoundThoughTheChecksumsAreRight) {
  const std::vector<uint8_t> good = awkward().bytes();
  const std::vector<SectionEntry> table = table_of_file(good);
  size_t section = 0;
  Multigrid read = awkward().read().value();
  visit_arrays(*read.hierarchy, *read.plan, [&](const char* name, const auto& array) {
    const SectionEntry& entry = table[section++];
    if (array.empty() || free_arrays().contains(name)) return;
    std::vector<uint8_t> bad = good;
    std::fill_n(bad.begin() + static_cast<std::ptrdiff_t>(entry.offset), entry.element_bytes, 0x7d);
    seal_hierarchy(bad);
    EXPECT_EQ(awkward().read_changed(bad).code(), StatusCode::kDataLoss)
        << entry.id << ", " << name;
  });
  EXPECT_EQ(section, table.size());
}

TEST(HierarchyFile, ACancelledReadAndWriteEndAndLeaveNothing) {
  const Progress never = [](std::string_view, double) { return false; };
  EXPECT_EQ(
      read_hierarchy(awkward().path, awkward().on.prepared, kFingerprint, never).status().code(),
      StatusCode::kCancelled);
  const TemporaryFolder folder;
  EXPECT_EQ(write_hierarchy(awkward().on, kFingerprint, folder / "file", never).code(),
            StatusCode::kCancelled);
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace burnish
