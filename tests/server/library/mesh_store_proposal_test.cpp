#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/denoise/edge_proposal.h"
#include "common/generate/generate.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A library with a noisy machined part.
class ScanProposal : public testing::Test {
 protected:
  ScanProposal() {
    part_ = generate_scan({"part", 4000, 1, 0.2, NoiseKind::kGauss}).value();
    const auto imported = library_.import(mesh_file(part_), "part");
    EXPECT_TRUE(imported.is_ok()) << imported.status().to_string();
    scan_ = imported->scan;
  }

  Result<EdgeProposal> ask(const Progress& progress = {}) {
    return library_.store->propose_edges(scan_.id, progress);
  }
  /// Deletes the imported file.
  void lose_original() {
    const auto original = library_.store->find_original(scan_.id, {});
    ASSERT_TRUE(original.is_ok());
    std::filesystem::remove(original->path);
  }

  TestLibrary library_;
  TriangleMesh part_;
  ScanInfo scan_;
};

TEST_F(ScanProposal, IsThatOfTheFilterOnFiles) {
  const auto proposal = ask();
  ASSERT_TRUE(proposal.is_ok()) << proposal.status().to_string();
  EXPECT_TRUE(proposal->is_machined);
  EXPECT_EQ(*proposal, *propose_edges(**make_denoise_surface(part_)));
}

TEST_F(ScanProposal, IsRememberedWithoutTheFile) {
  const auto first = ask();
  lose_original();
  const Progress nobody_hears = [](std::string_view, double) { return false; };
  const auto second = ask(nobody_hears);
  ASSERT_TRUE(second.is_ok()) << second.status().to_string();
  EXPECT_EQ(*first, *second);
}

TEST_F(ScanProposal, OfALostFileFailsAndNamesIt) {
  lose_original();
  const Status failed = ask().status();
  EXPECT_EQ(failed.code(), StatusCode::kDataLoss) << failed.to_string();
  EXPECT_THAT(failed.message(), HasSubstr("measuring the noise"));
}

TEST_F(ScanProposal, HearsACancelInEachPhaseAndTheNextCallMeasures) {
  std::vector<std::string> phases;
  const Progress note = [&](std::string_view phase, double) {
    if (std::ranges::find(phases, phase) == phases.end()) phases.emplace_back(phase);
    return true;
  };
  ASSERT_TRUE(ask(note).is_ok());
  EXPECT_THAT(phases, testing::IsSupersetOf({"rings", "noise", "edges"}));
  for (const std::string& in : phases) {
    library_.restart();
    const Progress cancel = [&](std::string_view phase, double) { return phase != in; };
    EXPECT_EQ(ask(cancel).status().code(), StatusCode::kCancelled) << in;
    EXPECT_TRUE(ask().is_ok()) << in;
  }
}

TEST_F(ScanProposal, TakesItsMemoryFromTheBudgetAndGivesItBack) {
  Quota& memory = library_.store->memory();
  const uint64_t before = memory.taken();
  uint64_t most = 0;
  const Progress look = [&](std::string_view, double) {
    most = std::max(most, memory.taken());
    return true;
  };
  ASSERT_TRUE(ask(look).is_ok());
  EXPECT_GE(most, before + predict_proposal_bytes(MeshView(part_)).arrays);
  EXPECT_EQ(memory.taken(), before);
}

TEST_F(ScanProposal, WithoutMemoryFailsAndNamesTheLimit) {
  Quota& memory = library_.store->memory();
  {
    const auto others = memory.take(kServer, memory.max() - memory.taken());
    const Status refused = ask().status();
    EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted) << refused.to_string();
    EXPECT_THAT(refused.message(), HasSubstr("limits.memory_bytes_max"));
  }
  EXPECT_TRUE(ask().is_ok());
}

TEST_F(ScanProposal, LetsOtherScansBeImportedMeanwhile) {
  bool is_imported = false;
  const Progress import_once = [&](std::string_view phase, double) {
    if (phase != "noise" || is_imported) return true;
    is_imported = library_.import(sphere_file(), "ball").is_ok();
    return true;
  };
  EXPECT_TRUE(ask(import_once).is_ok());
  EXPECT_TRUE(is_imported);
}

}  // namespace
}  // namespace burnish
