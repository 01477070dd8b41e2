#include "client/report/about_text.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(AboutText, HasTheCopyrightOfTheLicence) {
  std::ifstream licence(LICENCE_FILE);
  std::string copyright;
  while (std::getline(licence, copyright) && copyright.find("Copyright") == std::string::npos)
    continue;
  ASSERT_THAT(copyright, HasSubstr("Copyright"));
  EXPECT_THAT(about_texts()[1].text, HasSubstr(copyright));
}

TEST(AboutText, HasTheVersion) {
  EXPECT_EQ(about_texts()[0].text, "Burnish " BURNISH_VERSION);
}

}  // namespace
}  // namespace burnish
