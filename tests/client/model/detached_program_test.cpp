#include "client/model/local_server/detached_program.h"

#include <cerrno>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

void wait_for_end(const DetachedProgram& program) {
  while (!program.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(DetachedProgram, HasALogForItsUserAloneAndNothingElseOfOurs) {
  const TemporaryFolder folder;
  const auto log = folder / "log";
  auto program = DetachedProgram::start(
      {"/bin/sh", "-c", "umask; pwd; read line || echo no input; echo error >&2"}, log);
  ASSERT_TRUE(program.is_ok());
  wait_for_end(*program);
  EXPECT_EQ(content_of(log), "0077\n/\nno input\nerror\n");
  EXPECT_EQ(std::filesystem::status(log).permissions(), std::filesystem::perms(0600));
}

TEST(DetachedProgram, IsNotAChildAndIsInASessionOfItsOwn) {
  const TemporaryFolder folder;
  auto program =
      DetachedProgram::start({"/bin/sh", "-c", "cut -d' ' -f6 /proc/$$/stat"}, folder / "log");
  ASSERT_TRUE(program.is_ok());
  EXPECT_EQ(waitpid(-1, nullptr, 0), -1);
  EXPECT_EQ(errno, ECHILD);
  wait_for_end(*program);
  EXPECT_NE(std::atoi(content_of(folder / "log").c_str()), getsid(0));
}

TEST(DetachedProgram, OneThatCannotBeRunEnds) {
  const TemporaryFolder folder;
  auto program = DetachedProgram::start({"/nowhere/program"}, folder / "log");
  ASSERT_TRUE(program.is_ok());
  wait_for_end(*program);
}

}  // namespace
}  // namespace burnish
