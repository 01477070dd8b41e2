#include "tests/common/mesh/rewrite/rewriting.h"

namespace burnish {
namespace {

const std::string kObjText =
    "\xEF\xBB\xBF# Blender\nmtllib stone.mtl\no tablet\n"
    "v 0.000000 0.0 0.0 0.5 0.25 1\nv  1.0\t0 0 \nv 1 1.0e+00 0 # corner\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0.0000 0.0000 1.0000\nvn 0 0 -3\nvn 0 0 0\nvn 1 0 0\n"
    "usemtl stone\ns 1\ng front\nf 1/1/1 2/2/1 3/3/1 \\\n 4/4/1\n"
    "f -4//2 -3//2 -2//2\nf 1//3 3//3 4//3\nf 1/1 2/2 3/3\nl 1 2\n"
    "v 5 \\\n 6 7\nf 1 3 5";

TEST(ObjRewriter, AnUnmovedTextIsTheSameBytes) {
  EXPECT_EQ(rewritten(MeshFormat::kObj, kObjText), kObjText);
  const std::string crlf = with_crlf(kObjText);
  EXPECT_EQ(rewritten(MeshFormat::kObj, crlf), crlf);
}

TEST(ObjRewriter, ColoursBlanksAndContinuedLinesStayBehindAMovedVertex) {
  const auto move = [](size_t v, const Vec3d& p) {
    return v == 0 || v == 4 ? Vec3d(p[0], p[1], p[2] + 0.5) : p;
  };
  const std::string text = rewritten(MeshFormat::kObj, kObjText, move);
  EXPECT_THAT(text, testing::HasSubstr("v 0.000000 0.0 0.5 0.5 0.25 1\nv  1.0\t0 0 \nv 1 1.0e+00"));
  EXPECT_THAT(text, testing::HasSubstr("v 5 \\\n 6 7.5\nf 1 3 5"));
}

TEST(ObjRewriter, AColourOfAVertexChangesWhereItStands) {
  EXPECT_EQ(recoloured(MeshFormat::kObj, kObjText, 0, {128, 255, 255, 255}),
            replaced(kObjText, "0.5 0.25 1\n", "0.5 1 1\n"));
  EXPECT_EQ(recoloured(MeshFormat::kObj, kObjText, 1, {0, 0, 0, 255}), kObjText);  // it has none
}

TEST(ObjRewriter, ANormalIsTheMeanOfTheFacesThatUseIt) {
  const auto turn = [](size_t, const Vec3d& p) { return Vec3d(0, p[1], p[0] + p[2]); };
  const std::string text = rewritten(MeshFormat::kObj, kObjText, turn);
  // Towards -x; the second points inwards and is 3 long; the third is none; nothing uses the
  // fourth.
  EXPECT_THAT(text, testing::HasSubstr("vn -1.0000 0.0000 0.0000\nvn 3 0 0\nvn 0 0 0\nvn 1 0 0\n"));
}

TEST(ObjRewriter, LargerFacesWeighMore) {
  const std::string roof =
      "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 0 1 0\nv 4 0 0\nv 4 1 0\nvn 0 0 1\n"
      "f 1//1 2//1 3//1 4//1\nf 2//1 5//1 6//1 3//1\n";
  const auto fold = [](size_t v, const Vec3d& p) {
    return v >= 4 ? Vec3d(3, p[1], p[2] - 1) : p;  // the small face now looks along x
  };
  EXPECT_THAT(rewritten(MeshFormat::kObj, roof, fold), testing::HasSubstr("vn 0.3162 0 0.9487\n"));
}

const std::string kSeamFaces =
    "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 0\nv 0 1 0\n"
    "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0.5 0 0.8660254\n";

TEST(ObjRewriter, NormalsThatWereEqualAtOnePlaceStayEqualAndOthersKeepTheirCrease) {
  const auto fold = [](size_t v, const Vec3d& p) { return v == 3 ? Vec3d(-1, 0, -1) : p; };
  for (const char* second : {"f 1//5 2//6 4//4\n", "f 5//5 6//6 4//4\n"})
    EXPECT_THAT(rewritten(MeshFormat::kObj, kSeamFaces + "f 1//1 3//3 2//2\n" + second, fold),
                testing::HasSubstr("vn -0.4472136 0 0.8944272\nvn 0 0 1\nvn 0 0 1\n"
                                   "vn -0.7071068 0 0.7071068\nvn -0.4472136 0 0.8944272\n"
                                   "vn -0.7071068 0 0.7071068\n"))
        << second;
}

TEST(ObjRewriter, ANormalOfAFaceIsThatFacesAlone) {
  const auto fold = [](size_t v, const Vec3d& p) { return v == 3 ? Vec3d(-1, 0, -1) : p; };
  EXPECT_THAT(
      rewritten(MeshFormat::kObj, kSeamFaces + "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\n", fold),
      testing::HasSubstr("vn 0 0 1\nvn -0.7071068 0 0.7071068\nvn 0 0 1\n"));
}

TEST(ObjRewriter, VerticesAndFacesThatAreNotDrawnKeepTheirBytes) {
  const std::string text = "v 0 0 0\rv nan -1.#IND 4\rv 1 0 0\rv 0 1 0\rf 1 2\rf 1 3 4\rf 2\r";
  const auto move = [](size_t v, const Vec3d& p) -> Vec3d { return v == 1 ? p : 2 * p; };
  EXPECT_EQ(rewritten(MeshFormat::kObj, text), text);
  EXPECT_EQ(rewritten(MeshFormat::kObj, text, move),
            "v 0 0 0\rv nan -1.#IND 4\rv 2 0 0\rv 0 2 0\rf 1 2\rf 1 3 4\rf 2\r");
}

TEST(ObjRewriter, NormalsThatAreNotThereAreIgnored) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//9 2//-4 3//x\n";
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return 2 * p; };
  EXPECT_EQ(rewritten(MeshFormat::kObj, text, move),
            "v 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 0 1\nf 1//9 2//-4 3//x\n");
}

}  // namespace
}  // namespace burnish
