#include "tests/server/live/simulator.h"

#include <cstdlib>

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

namespace burnish {
namespace {

constexpr int kHistories = 300;

/// BURNISH_SIMULATED_HISTORIES sets their number; BURNISH_SIMULATED_SEED makes other histories.
int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

TEST(Simulator, RandomHistoriesOfManyPeopleEqualTheirSerialReplay) {
  spdlog::set_level(spdlog::level::warn);
  TestLibrary library;
  const std::string sphere = sphere_file(1, 1);
  const ScanInfo scan = library.import(sphere, "ball", {}, 4).value().scan;
  const int histories = from_environment("BURNISH_SIMULATED_HISTORIES", kHistories);
  const int first_seed = from_environment("BURNISH_SIMULATED_SEED", 1);
  Simulator::Counts all;
  for (int seed = first_seed; seed < first_seed + histories; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Simulator simulator(library, scan, static_cast<uint64_t>(seed));
    simulator.run();
    ASSERT_FALSE(HasFailure());
    const Simulator::Counts& counts = simulator.counts();
    all = {all.edits + counts.edits,     all.refused + counts.refused, all.known + counts.known,
           all.crashes + counts.crashes, all.lost + counts.lost,       all.forks + counts.forks,
           all.spills + counts.spills};
  }
  std::printf(
      "%d histories: %zu edits, %zu refused, %zu known, %zu crashes, %zu lost before they "
      "were acknowledged, %zu forks, %zu spills\n",
      histories, all.edits, all.refused, all.known, all.crashes, all.lost, all.forks, all.spills);
  for (const size_t count : {all.edits, all.refused, all.known, all.crashes, all.forks, all.spills})
    EXPECT_GT(count, 0u);
}

}  // namespace
}  // namespace burnish
