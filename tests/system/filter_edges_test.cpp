// `burnish filter --keep-edges` as users see it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/denoise/shape_error.h"
#include "tests/system/filter_command.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST_F(FilterCommand, KeepsTheEdgesOfANoisyPart) {
  ASSERT_EQ(burnish({"generate", "part", in(), "--vertices", "2500", "--noise", "0.2",
                     "--noise-kind", "gauss"}),
            0)
      << output_;
  ASSERT_EQ(burnish({"filter", in(), out(), "--keep-edges", "machined", "--exact"}), 0) << output_;
  const TriangleMesh clean = *generate_scan({"part", 2500, 1, 0.0});
  const TriangleMesh noisy = *read_mesh(in()), kept = *read_mesh(out());
  EXPECT_LT(shape_error(clean, kept).angle, 0.25 * shape_error(clean, noisy).angle);

  ASSERT_EQ(burnish({"filter", in(), out(), "--keep-edges", "machined", "--edge-strength", "0",
                     "--exact"}),
            0)
      << output_;
  EXPECT_EQ(read_mesh(out())->vertices, noisy.vertices);
}

TEST_F(FilterCommand, TheScansOwnNoiseSaysHowEdgesAreKept) {
  ASSERT_EQ(burnish({"generate", "part", in(), "--vertices", "2500", "--noise", "0.2",
                     "--noise-kind", "gauss"}),
            0)
      << output_;
  ASSERT_EQ(burnish({"filter", in(), out(), "--keep-edges", "machined"}), 0) << output_;
  const auto expected = read_mesh(out())->vertices;
  ASSERT_EQ(
      burnish({"filter", in(), out(), "--keep-edges", "auto", "--report", path("report.json")}), 0);
  EXPECT_THAT(output_, HasSubstr("mean edges), machined part: edges kept at strength 1"));
  EXPECT_EQ(read_mesh(out())->vertices, expected);
  const nlohmann::json edges = report().at("edges");
  EXPECT_EQ(edges.at("filter"), "edges");
  EXPECT_NEAR(edges.at("noise_in_edges").get<double>(), 0.2, 0.04);

  ASSERT_EQ(burnish({"generate", "part", in(), "--vertices", "2500", "--noise", "0"}), 0);
  ASSERT_EQ(burnish({"filter", in(), out(), "--keep-edges", "auto"}), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("too little to take away"));
  EXPECT_EQ(read_mesh(out())->vertices, read_mesh(in())->vertices);
  ASSERT_EQ(burnish({"filter", in(), out(), "--beta", "2"}), 0) << output_;
  const auto plain = read_mesh(out())->vertices;
  for (const char* const nothing : {"auto", "off"}) {
    ASSERT_EQ(burnish({"filter", in(), out(), "--beta", "2", "--keep-edges", nothing}), 0)
        << output_;
    EXPECT_EQ(read_mesh(out())->vertices, plain);
  }
}

TEST_F(FilterCommand, AnEditAsALineIsTheEditOfItsOption) {
  ASSERT_EQ(burnish({"generate", "part", in(), "--vertices", "2500", "--noise", "0.2"}), 0)
      << output_;
  ASSERT_EQ(burnish({"filter", in(), out(), "--alpha", "20", "--beta", "0.5"}), 0) << output_;
  const auto expected = read_mesh(out())->vertices;
  ASSERT_EQ(burnish({"filter", in(), out(), "--edit", "curve 0:20", "--edit", "beta 0.5"}), 0)
      << output_;
  EXPECT_EQ(read_mesh(out())->vertices, expected);
  EXPECT_EQ(burnish({"filter", in(), out(), "--edit", "beta 11"}), 2);
  EXPECT_THAT(output_, HasSubstr("beta 11 is outside 0..10"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--edit", "undo"}), 2);
  EXPECT_THAT(output_, HasSubstr("'undo' is no edit of a scan"));
}

TEST_F(FilterCommand, WordsOfKeptEdgesAreChecked) {
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "corners"}), 2);
  EXPECT_THAT(output_, HasSubstr("'corners' keeps no edges; there are machined, scanner, soft, "
                                 "relief, auto, off"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "off", "--edge-angle", "30"}), 1);
  EXPECT_THAT(output_, HasSubstr("--keep-edges off keeps none: leave out --edge-strength"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "soft", "--edge-angle", "3"}), 2);
  EXPECT_THAT(output_, HasSubstr("3 is outside 5 to 120"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--crispness", "1"}), 2);
  EXPECT_THAT(output_, HasSubstr("--keep-edges"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "soft", "--keep-volume", "on"}), 1);
  EXPECT_THAT(output_, HasSubstr("--keep-edges cannot stand beside --keep-volume on"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "soft", "--band", "1:0"}), 1);
  EXPECT_THAT(output_, HasSubstr("--keep-edges cannot stand beside --band"));
  EXPECT_EQ(burnish({"filter", in(), out(), "--keep-edges", "relief", "--preset",
                     "Bring out an inscription"}),
            1);
  EXPECT_THAT(output_, HasSubstr("--keep-edges cannot stand beside --preset 'Bring out"));
}

}  // namespace
}  // namespace burnish
