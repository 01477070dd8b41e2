// Kills the server in each pass of an import.

#include <gtest/gtest.h>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

class KilledImport : public testing::TestWithParam<std::string> {
 protected:
  CommandOutcome import() {
    return server_.burnish({"import", scan_, "--depth", "8", "--name", "ball"});
  }

  ServerProcess server_;
  const std::string scan_ = write_sphere(server_.folder, 6);
};

TEST_P(KilledImport, LeavesNothingAndCanBeRepeated) {
  const auto interrupted =
      server_.start_burnish({"import", scan_, "--depth", "8", "--name", "ball"});
  ASSERT_TRUE(interrupted->wait_for_output(GetParam() + "\n", kPatience));
  server_.kill();
  interrupted->signal(SIGKILL);
  EXPECT_TRUE(interrupted->wait(kPatience));
  server_.start();
  EXPECT_EQ(server_.staged(), 0u);
  EXPECT_LE(server_.scans(), 1u);  // the last pass may have ended
  const CommandOutcome again = import();
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_EQ(server_.scans(), 1u);
  EXPECT_EQ(server_.burnish({"open", "ball", "--depth", "8", "--session", "work"}).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(Passes, KilledImport,
                         testing::Values("uploading", "reading", "grid", "curvature", "integrals",
                                         "storing", "pages"));

}  // namespace
}  // namespace burnish
