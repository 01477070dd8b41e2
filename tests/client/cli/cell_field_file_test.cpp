#include "client/cli/cell_field_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

std::string field_refusal(const std::string& text) {
  const auto fields = parse_cell_fields(text, "c.txt");
  return fields.is_ok() ? "accepted" : fields.status().message();
}

TEST(CellFieldFile, LinesAreReadAndFurtherColumnsPassedOver) {
  const auto fields =
      parse_cell_fields("# origin 0 0 0\n1 2 3 5 6 0.5\n4 5 6 7 8 9 -0.25 17\n", "c.txt");
  ASSERT_TRUE(fields.is_ok());
  ASSERT_EQ(fields.value().cells.size(), 2u);
  EXPECT_EQ(fields.value().cells[1].cell, Vec3i(4, 5, 6));
  EXPECT_EQ(fields.value().cells[1].alpha2, 8);
  EXPECT_EQ(fields.value().cells[1].beta, 9);
}

TEST(CellFieldFile, ErrorsNameFileAndLine) {
  EXPECT_THAT(field_refusal("1 2 3 4 5\n"), HasSubstr("c.txt:1: a line must be"));
  EXPECT_THAT(field_refusal("1 2 3 4 5 1\n1.5 2 3 4 5 1\n"),
              HasSubstr("c.txt:2: '1.5' is not an integer"));
  EXPECT_THAT(field_refusal("1 2 3 0 5 1\n"), HasSubstr("c.txt:1: alpha1: alpha 0"));
  EXPECT_THAT(field_refusal("1 2 3 4 5 nan\n"), HasSubstr("outside 0..10"));
  EXPECT_THAT(field_refusal(""), HasSubstr("c.txt has no cells"));
}

}  // namespace
}  // namespace burnish
