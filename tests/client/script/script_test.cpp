#include "client/script/script.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ScriptParser, LinesAreCommandsWithWords) {
  const auto script = parse_script("# first\n\nbeta 0.5\npreset Keep grooves  # Figure 3\n", "s");
  ASSERT_TRUE(script.is_ok());
  ASSERT_EQ(script->size(), 2u);
  EXPECT_EQ((*script)[0].number, 3u);
  EXPECT_EQ((*script)[0].command, "beta");
  EXPECT_EQ((*script)[1].rest(), "Keep grooves");
}

TEST(ScriptParser, AWrongLineIsNamedWithItsForm) {
  EXPECT_EQ(parse_script("wait\npolish\n", "s").status().message(),
            "s:2: unknown command 'polish'");
  EXPECT_EQ(parse_script("beta\n", "s").status().message(),
            "s:1: 0 words after 'beta'; write beta VALUE: the gradient scale");
  EXPECT_FALSE(parse_script("undo twice\n", "s").is_ok());
}

TEST(ScriptParser, HelpNamesEveryCommandThatIsTaken) {
  EXPECT_NE(script_help().find("drag X Y"), std::string::npos);
  EXPECT_NE(script_help().find("screenshot FILE"), std::string::npos);
}

}  // namespace
}  // namespace burnish
