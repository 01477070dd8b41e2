#include "client/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/cli/in_range.h"
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

TEST(Command, AValueOutsideItsLimitsIsToldWithTheseAsPeopleWriteThem) {
  double cap = 0;
  int steps = 0;
  std::string palette;
  const auto complaint = [&](const char* option, const char* value) {
    Program program;
    CLI::App* command = program.app.get_subcommand("paint");
    command->add_option("--cap", cap)->check(in_range(0.0, 1e18));
    command->add_option("--wave", cap)->check(above_zero());
    command->add_option("--steps", steps)->check(in_range(1, 100'000));
    command->add_option("--palette", palette)->check(not_empty());
    EXPECT_EQ(program.run({"paint", option, value}), 2);
    return program.complained;
  };
  EXPECT_THAT(complaint("--cap", "-1"), testing::HasSubstr("--cap: -1 is outside 0 to 1e+18"));
  EXPECT_THAT(complaint("--cap", "nan"), testing::HasSubstr("--cap: nan is outside"));
  EXPECT_THAT(complaint("--cap", "x"), testing::HasSubstr("--cap: 'x' is not a number"));
  EXPECT_THAT(complaint("--wave", "0"), testing::HasSubstr("--wave: 0 is not a number above 0"));
  EXPECT_THAT(complaint("--steps", "0"), testing::HasSubstr("--steps: 0 is outside 1 to 100000"));
  EXPECT_THAT(complaint("--palette", ""), testing::HasSubstr("--palette: '' names nothing"));
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
