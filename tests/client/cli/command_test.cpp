#include "client/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/edit/transfer_curve.h"

namespace burnish {
namespace {

/// Runs `burnish paint --curve` as a program would.
struct Program {
  Program() {
    CLI::App* command = table.add("paint", "Test", [this] { return outcome; });
    command->add_option("--curve", curve)->check([](const std::string& text) {
      return usage_message(TransferCurve::parse(text).status());
    });
  }

  int run(std::vector<std::string> words) {
    words.insert(words.begin(), "burnish");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int code = table.run(static_cast<int>(argv.size()), argv.data());
    printed = testing::internal::GetCapturedStdout();
    complained = testing::internal::GetCapturedStderr();
    return code;
  }

  CLI::App app{"Test", "burnish"};
  CommandTable table{app};
  Status outcome;
  std::string curve;
  std::string printed, complained;
};

TEST(Command, ExitCodesAre0DoneAnd1FailedAnd2Usage) {
  EXPECT_EQ(Program().run({"paint"}), 0);
  Program failing;
  failing.outcome = not_found("no such thing");
  EXPECT_EQ(failing.run({"paint"}), 1);
  EXPECT_EQ(failing.complained, "burnish: no such thing\n");
  EXPECT_EQ(Program().run({}), 2);
  EXPECT_EQ(Program().run({"dance"}), 2);
  EXPECT_EQ(Program().run({"paint", "--nonsense"}), 2);
}

TEST(Command, AnUnknownCommandIsNamed) {
  Program program;
  EXPECT_EQ(program.run({"dance"}), 2);
  EXPECT_THAT(program.complained, testing::HasSubstr("'dance'"));
}

TEST(Command, HelpIsNoFailure) {
  Program program;
  EXPECT_EQ(program.run({"paint", "--help"}), 0);
  EXPECT_THAT(program.printed, testing::HasSubstr("--curve"));
}

TEST(Command, ACurveMayBeginWithAMinus) {
  Program apart;
  EXPECT_EQ(apart.run({"paint", "--curve", "-20:5,0:50"}), 0);
  EXPECT_EQ(apart.curve, "-20:5,0:50");
  Program joined;
  EXPECT_EQ(joined.run({"paint", "--curve=-20:5"}), 0);
  EXPECT_EQ(joined.curve, "-20:5");
}

TEST(Command, AnOptionsBadValueIsUsage) {
  Program program;
  EXPECT_EQ(program.run({"paint", "--curve", "5"}), 2);
  EXPECT_THAT(program.complained, testing::HasSubstr("not kappa:alpha"));
}

}  // namespace
}  // namespace burnish
