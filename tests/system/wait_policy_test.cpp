#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

// Returns OpenMP's own settings when a program starts with these variables.
std::string settings_of(const std::string& program, std::vector<std::string> environment) {
  std::vector<std::string> words = {
      "/usr/bin/env", "-u", "OMP_WAIT_POLICY", "-u", "GOMP_SPINCOUNT", "OMP_DISPLAY_ENV=verbose"};
  words.insert(words.end(), environment.begin(), environment.end());
  words.insert(words.end(), {program, "--version"});
  const TemporaryFolder folder;
  Process process(words, folder / "output");
  EXPECT_EQ(process.wait(std::chrono::seconds(60)), 0);
  return process.output();
}

class WaitPolicy : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
#ifndef _OPENMP
    GTEST_SKIP() << "built without OpenMP";
#endif
  }
};

TEST_P(WaitPolicy, ThreadsSleepWhileTheyWait) {
  EXPECT_THAT(settings_of(GetParam(), {}), testing::HasSubstr("GOMP_SPINCOUNT = '0'"));
}

TEST_P(WaitPolicy, WhatTheUserHasSetStays) {
  const std::string settings = settings_of(GetParam(), {"GOMP_SPINCOUNT=77"});
  EXPECT_THAT(settings, testing::HasSubstr("GOMP_SPINCOUNT = '77'"));
  EXPECT_THAT(settings, testing::Not(testing::HasSubstr("GOMP_SPINCOUNT = '0'")));
}

INSTANTIATE_TEST_SUITE_P(Programs, WaitPolicy,
                         testing::Values(BURNISH_BINARY, BURNISH_SERVER_BINARY),
                         [](const auto& program) {
                           return program.index == 0 ? "burnish" : "server";
                         });

}  // namespace
}  // namespace burnish
