#include "common/archive/entry_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(EntryName, PathsBelowTheFolderAreTaken) {
  for (const char* name : {"scan.obj", "a/b/c.png", "folder/", "..a/b..", "Bäume.jpg", "a b.mtl"})
    EXPECT_TRUE(check_entry_name(name).is_ok()) << name;
}

TEST(EntryName, PathsThatLeadElsewhereAreRefusedByName) {
  for (const char* name : {"", "/etc/passwd", "../a", "a/../../b", "a/..", "./a", "a//b", "C:/a",
                           "c:a", "a\\b", "..\\a", "a\nb", "a\x7f", "/"})
    EXPECT_EQ(check_entry_name(name).code(), StatusCode::kInvalidArgument) << name;
  EXPECT_THAT(check_entry_name("a/../b").message(), HasSubstr("'a/../b'"));
}

TEST(EntryName, LongNamesAreRefusedWithTheLimit) {
  EXPECT_TRUE(check_entry_name(std::string(1024, 'a')).is_ok());
  const Status refused = check_entry_name(std::string(1025, 'a'));
  EXPECT_THAT(refused.message(), HasSubstr("1025"));
  EXPECT_THAT(refused.message(), HasSubstr("1024"));
}

}  // namespace
}  // namespace burnish
