#include "tests/common/mesh/rewrite/rewriting.h"

namespace burnish {
namespace {

const std::string kOffText =
    "STCNOFF\n# a square\n4 1 0\n\n0 0 0   0 0 1.00  0.5 0.5 0.5 1  0.0 0\n"
    "1.0 0 0   0 0 1  1 0 0 1  1 0 # corner\n1 1 0   0 0 1  0 1 0 1  1 1\n"
    "0 1 0   0 0 1  0 0 1 1  0 1\n4  0 1 2 3  0.25 0.5 1\n";

TEST(OffRewriter, AnUnmovedTextIsTheSameBytes) {
  EXPECT_EQ(rewritten(MeshFormat::kOff, kOffText), kOffText);
  const std::string crlf = with_crlf(kOffText);
  EXPECT_EQ(rewritten(MeshFormat::kOff, crlf), crlf);
}

TEST(OffRewriter, PositionsAndNormalsChangeAndColoursStay) {
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0]); };
  EXPECT_EQ(rewritten(MeshFormat::kOff, kOffText, turn),
            "STCNOFF\n# a square\n4 1 0\n\n0 0 0   -1 0 0.00  0.5 0.5 0.5 1  0.0 0\n"
            "0.0 0 1   -1 0 0  1 0 0 1  1 0 # corner\n0 1 1   -1 0 0  0 1 0 1  1 1\n"
            "0 1 0   -1 0 0  0 0 1 1  0 1\n4  0 1 2 3  0.25 0.5 1\n");
}

TEST(OffRewriter, AColourChangesInTheRangeOfTheFile) {
  EXPECT_EQ(recoloured(MeshFormat::kOff, kOffText, 1, {255, 51, 0, 255}),
            replaced(kOffText, "1  1 0 0 1  1 0 #", "1  1 0.2 0 1  1 0 #"));
  const std::string bytes = "COFF\n3 1 0\n0 0 0 9 8 7\n1 0 0 90 80 70\n0 1 0 5 6 7\n3 0 1 2\n";
  EXPECT_EQ(recoloured(MeshFormat::kOff, bytes, 1, {90, 0, 70, 255}),
            replaced(bytes, "90 80 70", "90 0 70"));
}

TEST(OffRewriter, NormalsThatWereEqualAtOnePlaceStayEqual) {
  const std::string seam =
      "NOFF\n6 2 0\n0 0 0 0 0 1\n0 0 0 0 0 1\n0 1 0 0 0 1\n0 1 0 0.5 0 0.8660254\n"
      "1 0 0 0 0 1\n-1 0 0 0 0 1\n3 0 4 2\n3 1 3 5\n";
  const auto fold = [](size_t v, const Vec3d& p) { return v == 5 ? Vec3d(-1, 0, -1) : p; };
  EXPECT_THAT(rewritten(MeshFormat::kOff, seam, fold),
              testing::HasSubstr("0 0 0 -0.4472136 0 0.8944272\n0 0 0 -0.4472136 0 0.8944272\n"
                                 "0 1 0 0 0 1\n0 1 0 -0.7071068 0 0.7071068\n"));
}

TEST(OffRewriter, ElementsMayTakeSeveralLinesOrShareOne) {
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return 2 * p; };
  EXPECT_EQ(rewritten(MeshFormat::kOff, "OFF4 1 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1\n2 3", move),
            "OFF4 1 0\n0 0 0 2 0 0\n2 2 0 0 2 0\n4 0 1\n2 3");
  EXPECT_EQ(rewritten(MeshFormat::kOff, "OFF\n3 1 0\n0 0\n0\n1 0 0\r0 1 0\n3 0\n1 2\n", move),
            "OFF\n3 1 0\n0 0\n0\n2 0 0\r0 2 0\n3 0\n1 2\n");
}

TEST(OffRewriter, FacesAndVerticesThatAreNotDrawnKeepTheirBytes) {
  const auto move = [](size_t v, const Vec3d& p) -> Vec3d { return v == 1 ? p : 2 * p; };
  EXPECT_EQ(rewritten(MeshFormat::kOff,
                      "OFF\n4 2 0\n0 0 0\ninf 1 nan\n1 0 0\n0 1 0\n2 0 1\n3 0 2 3\n", move),
            "OFF\n4 2 0\n0 0 0\ninf 1 nan\n2 0 0\n0 2 0\n2 0 1\n3 0 2 3\n");
}

TEST(OffRewriter, CountsMayFollowTheFirstWord) {
  const std::string text = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return 2 * p; };
  EXPECT_EQ(rewritten(MeshFormat::kOff, text, move), "OFF 3 1 0\n0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n");
}

}  // namespace
}  // namespace burnish
