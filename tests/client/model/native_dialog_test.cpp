#include "client/model/files/native_dialog.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

/// A $PATH with programs of the test's own.
class NativeDialog : public testing::Test {
 protected:
  NativeDialog() { setenv("PATH", (folder_ / "").c_str(), 1); }
  ~NativeDialog() override { setenv("PATH", path_.c_str(), 1); }

  void add(const std::string& name, const std::string& script) const {
    const auto program = folder_.write(name, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms(0700));
  }

  const std::string path_ = std::getenv("PATH");
  const TemporaryFolder folder_;
  const FileQuestion question_{
      .title = "Open a scan", .extensions = {".ply", ".obj"}, .start = "/scans"};
};

TEST_F(NativeDialog, ThereIsNoneWithoutItsProgram) {
  EXPECT_TRUE(native_dialog(question_).empty());
}

TEST_F(NativeDialog, ZenityComesBeforeKdialogAndHearsTitleFolderAndFormats) {
  add("kdialog", "");
  EXPECT_THAT(native_dialog(question_).at(0), testing::EndsWith("kdialog"));
  add("zenity", "");
  const auto command = native_dialog(question_);
  EXPECT_THAT(command.at(0), testing::EndsWith("zenity"));
  EXPECT_THAT(command, testing::IsSupersetOf({std::string("--title=Open a scan"),
                                              std::string("--filename=/scans/"),
                                              std::string("--file-filter=*.ply *.obj")}));
}

TEST_F(NativeDialog, TheAnswerIsThePathThatItPrints) {
  add("zenity", "echo '/scans/my head.ply'");
  const auto answer = ask_natively(native_dialog(question_), {});
  ASSERT_TRUE(answer.is_ok()) << answer.status().message();
  EXPECT_EQ(answer->value(), "/scans/my head.ply");
}

TEST_F(NativeDialog, CancellingIsNoAnswerAndNoFailure) {
  add("zenity", "exit 1");
  const auto answer = ask_natively(native_dialog(question_), {});
  ASSERT_TRUE(answer.is_ok());
  EXPECT_FALSE(answer->has_value());
}

TEST_F(NativeDialog, AProgramThatFailsIsNamedWithItsCode) {
  add("zenity", "exit 7");
  const auto answer = ask_natively(native_dialog(question_), {});
  EXPECT_EQ(answer.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(answer.status().message(), testing::HasSubstr("7"));
}

TEST_F(NativeDialog, AStopEndsAProgramThatWaits) {
  add("zenity", "exec /bin/sleep 1000");
  const StopToken asked(std::make_shared<std::atomic<bool>>(true));
  const auto answer = ask_natively(native_dialog(question_), asked);
  ASSERT_TRUE(answer.is_ok());
  EXPECT_FALSE(answer->has_value());
}

}  // namespace
}  // namespace burnish
