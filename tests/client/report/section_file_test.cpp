#include "client/report/section_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Section kStep = {{{{{0, 0}, {10, 0}}}}, {{{{0, 1}, {10, 1.5}}}}};

TEST(SectionFile, TableHasARowForEachPoint) {
  EXPECT_EQ(section_csv(kStep),
            "surface,line,right,up\noriginal,0,0,0\noriginal,0,10,0\n"
            "edited,0,0,1\nedited,0,10,1.5\n");
}

TEST(SectionFile, DrawingShowsBothSurfacesAndTheNumbersOfTheTable) {
  const std::string drawing = section_svg(kStep, "mm");
  EXPECT_THAT(drawing, StartsWith("<svg"));
  EXPECT_THAT(drawing, HasSubstr("points=\"80.000,170.000 1080.000,170.000 \""));  // y goes down
  EXPECT_THAT(drawing, HasSubstr("points=\"80.000,70.000 1080.000,20.000 \""));
  EXPECT_THAT(drawing,
              HasSubstr("x=\"280.0\" y=\"190.0\" font-size=\"14\" text-anchor=\"middle\">2<"));
  EXPECT_THAT(drawing, HasSubstr(">10 mm<"));
  EXPECT_THAT(drawing, HasSubstr("text-anchor=\"end\">0.5<"));
  EXPECT_THAT(drawing, HasSubstr(">1.5 mm<"));
}

TEST(SectionFile, DrawingOfASectionWithoutLinesIsEmpty) {
  EXPECT_THAT(section_svg({}, ""), StartsWith("<svg"));
}

TEST(SectionFile, OtherEndingsAreRefusedByName) {
  EXPECT_TRUE(check_section_name("a.svg").is_ok());
  EXPECT_TRUE(check_section_name("a.csv").is_ok());
  EXPECT_THAT(check_section_name("a.dxf").message(), HasSubstr("a.dxf"));
}

}  // namespace
}  // namespace burnish
