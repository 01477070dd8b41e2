#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Optional;

TEST(Refusal, ADeadServerFailsWithItsNameWithinTheDeadline) {
  ServerProcess server;
  server.kill();
  const CommandOutcome outcome = server.burnish({"meshes", "--timeout", "5"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("cannot reach server " + server.address));
}

TEST(Refusal, ASecondServerOnOneFolderIsRefused) {
  ServerProcess server;
  Process second(server.command_line(), server.folder / "second.log");
  EXPECT_EQ(second.wait(kPatience), 1);
  EXPECT_THAT(second.output(), HasSubstr("another burnish-server uses the data folder"));
}

TEST(Refusal, ASecondServerOnOnePortIsRefused) {
  ServerProcess server;
  Process second({BURNISH_SERVER_BINARY, "--listen", server.address, "--data",
                  (server.folder / "other").string()},
                 server.folder / "second.log");
  EXPECT_EQ(second.wait(kPatience), 1);
  EXPECT_THAT(second.output(), HasSubstr("cannot listen on " + server.address));
}

TEST(Refusal, ACopyOfAJournalThatIsNotThereLeavesNothing) {
  const TemporaryFolder folder;
  const auto from = folder / "mistyped", to = folder / "target";
  Process copy({BURNISH_SERVER_BINARY, "journal", "copy", from.string(), to.string()},
               folder / "log");
  EXPECT_EQ(copy.wait(kPatience), 1);
  EXPECT_THAT(copy.output(), HasSubstr(from.string() + ": is neither a data folder"));
  EXPECT_FALSE(std::filesystem::exists(from));
  EXPECT_FALSE(std::filesystem::exists(to));
}

TEST(Refusal, ACopyOfWhatIsNoJournalLeavesNothing) {
  const TemporaryFolder folder;
  const auto from = folder / "mistaken", to = folder / "target";
  std::filesystem::create_directory(from);
  folder.write("mistaken/journal.sqlite", "");
  Process copy({BURNISH_SERVER_BINARY, "journal", "copy", from.string(), to.string()},
               folder / "log");
  EXPECT_EQ(copy.wait(kPatience), 1);
  EXPECT_THAT(copy.output(), HasSubstr((from / "journal.sqlite").string() + " is no journal"));
  EXPECT_EQ(std::filesystem::file_size(from / "journal.sqlite"), 0u);
  EXPECT_FALSE(std::filesystem::exists(to));
}

TEST(Refusal, AFullDiskFailsTheImportAndTheServerLivesOn) {
  ServerProcess server;
  server.kill();
  server.start({.file_bytes_max = 200'000});
  const CommandOutcome outcome =
      server.burnish({"import", write_sphere(server.folder, 6), "--name", "big"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("File too large"));
  EXPECT_EQ(server.burnish({"meshes"}).exit_code, 0);
  EXPECT_EQ(server.scans(), 0u);
  EXPECT_EQ(server.staged(), 0u);
}

TEST(Refusal, AFullDiskFailsTheExportOfEitherSide) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder, 5);
  ASSERT_EQ(server.burnish({"import", scan, "--depth", "5", "--name", "ball"}).exit_code, 0);
  ASSERT_EQ(server.burnish({"open", "ball", "--depth", "5", "--session", "work"}).exit_code, 0);
  const auto out = server.folder / "out.obj";

  Process client({BURNISH_BINARY, "export", "work", out.string(), "--server", server.address},
                 server.folder / "client.log", {.file_bytes_max = 100'000});
  EXPECT_EQ(client.wait(kPatience), 1);
  EXPECT_THAT(client.output(), HasSubstr("File too large"));
  EXPECT_FALSE(std::filesystem::exists(out));

  server.kill();
  server.start({.file_bytes_max = 100'000});
  const CommandOutcome outcome = server.burnish({"export", "work", out.string()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("File too large"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(server.staged(), 0u);
}

TEST(Refusal, BadInputNamesWhatIsWrong) {
  ServerProcess server;
  const std::string bad = server.folder.write("bad.ply", "ply\nnonsense\n").string();
  const CommandOutcome import = server.burnish({"import", bad});
  EXPECT_EQ(import.exit_code, 1);
  EXPECT_THAT(import.output, HasSubstr("bad"));
  EXPECT_EQ(server.scans(), 0u);
  EXPECT_THAT(server.burnish({"import", "nowhere.ply"}).output, HasSubstr("nowhere.ply"));
  EXPECT_THAT(server.burnish({"describe", "nothing"}).output,
              HasSubstr("no scan has the name or id 'nothing'"));
  EXPECT_EQ(server.burnish({"import", bad, "--depth", "13"}).exit_code, 2);
  EXPECT_EQ(server.burnish({"edit", "s"}).exit_code, 2);
  EXPECT_EQ(server.burnish({"edit", "s", "--beta", "11"}).exit_code, 2);
  EXPECT_EQ(server.burnish({"edit", "s", "--curve", "1:2:3"}).exit_code, 2);
  EXPECT_EQ(server.burnish({"export", "s", "x.ply", "--exact", "--cycles", "3"}).exit_code, 2);
}

TEST(Refusal, NoCommandOpensTheWindowWhichNeedsAScreen) {
  const TemporaryFolder folder;
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  Process program({BURNISH_BINARY}, folder / "out");
  EXPECT_THAT(program.wait(kPatience), AnyOf(Optional(1), Optional(2)));
  EXPECT_THAT(program.output(), AnyOf(HasSubstr("burnish: cannot open a window"),
                                      HasSubstr("burnish: name a command")));  // no window built
}

}  // namespace
}  // namespace burnish
