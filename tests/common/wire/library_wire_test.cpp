#include "common/wire/library_wire.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/format_wire.h"
#include "common/wire/status_wire.h"

namespace burnish {
namespace {

using testing::HasSubstr;

v1::ImportHeader good_header() {
  v1::ImportHeader message;
  message.set_name("igea");
  message.set_format(v1::MESH_FORMAT_PLY);
  message.set_size_bytes(10);
  return message;
}

std::string refusal(const v1::ImportHeader& message) {
  const auto header = from_wire(message);
  return header.is_ok() ? "accepted" : header.status().message();
}

TEST(LibraryWire, EveryFormatReadsBack) {
  for (const auto format : {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kOff,
                            MeshFormat::kGlb, MeshFormat::kGltf, MeshFormat::kZip}) {
    EXPECT_EQ(from_wire(to_wire(format)).value(), format);
    EXPECT_EQ(mesh_format_of_name(mesh_format_name(format)).value(), format);
  }
}

TEST(LibraryWire, AHeaderNeedsANameAFormatAndASize) {
  EXPECT_EQ(refusal(good_header()), "accepted");
  v1::ImportHeader message = good_header();
  message.clear_name();
  EXPECT_THAT(refusal(message), HasSubstr("name is empty"));
  message.set_name(std::string(201, 'x'));
  EXPECT_THAT(refusal(message), HasSubstr("201 bytes"));
  message.set_name("a\nb");
  EXPECT_THAT(refusal(message), HasSubstr("control characters"));
  message = good_header();
  message.set_format(static_cast<v1::MeshFormat>(77));
  EXPECT_THAT(refusal(message), HasSubstr("mesh format 77"));
  message = good_header();
  message.set_size_bytes(0);
  EXPECT_THAT(refusal(message), HasSubstr("0 bytes"));
}

TEST(LibraryWire, AHashHas64HexadecimalDigits) {
  v1::ImportHeader message = good_header();
  message.set_sha256("../../etc");
  EXPECT_THAT(refusal(message), HasSubstr("sha256"));
  message.set_sha256(std::string(64, 'a'));
  EXPECT_EQ(refusal(message), "accepted");
}

TEST(LibraryWire, DepthAndCurvatureRadiusHaveLimits) {
  EXPECT_TRUE(prepared_key_from_wire(0, 0).is_ok());
  EXPECT_TRUE(prepared_key_from_wire(12, 0.1).is_ok());
  EXPECT_THAT(prepared_key_from_wire(3, 0).status().message(), HasSubstr("depth 3"));
  EXPECT_THAT(prepared_key_from_wire(13, 0).status().message(), HasSubstr("4..12"));
  EXPECT_THAT(prepared_key_from_wire(7, -1).status().message(), HasSubstr("curvature radius"));
  EXPECT_FALSE(prepared_key_from_wire(7, 0.3).is_ok());
  for (const double nothing : {-0.0, 1e-300, 1e-320, 9e-5})
    EXPECT_FALSE(std::signbit(prepared_key_from_wire(7, nothing).value().curvature_radius));
  EXPECT_EQ(prepared_key_from_wire(7, 1e-300).value(), (PreparedKey{7, 0}));
  EXPECT_FALSE(prepared_key_from_wire(7, std::numeric_limits<double>::quiet_NaN()).is_ok());
}

TEST(LibraryWire, ADescriptionComesBackUnchanged) {
  ScanDescription description;
  ScanInfo& scan = description.scan;
  scan.id = std::string(64, '0');
  scan.name = "tablet";
  scan.format = MeshFormat::kStl;
  scan.default_depth = 8;
  scan.has_colours = true;
  scan.statistics.vertices = 5;
  scan.statistics.box_max = Vec3d(1, 2, 3);
  scan.prepared = {{{7, 0.125}, 99}};
  description.prepared =
      PreparedDescription{{7, 0.125}, 1.5, 0.01, 1234, 5678, 40, {0.5f, 0.25f}, {0.125, 8}};
  const auto back = from_wire(to_wire(description));
  ASSERT_TRUE(back.is_ok());
  EXPECT_EQ(to_wire(back.value()).SerializeAsString(), to_wire(description).SerializeAsString());
  EXPECT_EQ(back.value().scan.statistics.box_max, Vec3d(1, 2, 3));
  EXPECT_EQ(back.value().prepared->histogram.size(), 2u);
  EXPECT_EQ(back.value().prepared->walls.share, 0.125);
  EXPECT_EQ(back.value().prepared->walls.depth, 8);
}

TEST(StatusWire, CodesAreThoseOfGrpcBothWays) {
  EXPECT_EQ(status_code_to_wire(StatusCode::kNotFound), 5);
  EXPECT_EQ(status_code_to_wire(StatusCode::kUnavailable), 14);
  for (int code : {0, 1, 3, 4, 5, 6, 7, 8, 9, 12, 13, 14, 15, 16})
    EXPECT_EQ(status_code_to_wire(status_code_from_wire(code)), code);
  EXPECT_EQ(status_code_from_wire(2), StatusCode::kInternal);
}

TEST(LibraryWire, AProposalReadsBackAndAnUnknownFilterIsNamed) {
  const EdgeProposal proposal{0.125, 0.5, true, {1, NormalFilterKind::kEdges, 35, 10, 0.75}};
  EXPECT_EQ(from_wire(to_wire(proposal)).value(), proposal);
  EXPECT_FALSE(from_wire(v1::EdgeProposal()).value().filter.is_on());
  v1::EdgeProposal other = to_wire(proposal);
  other.mutable_filter()->set_kind(static_cast<v1::NormalFilterKind>(7));
  EXPECT_THAT(from_wire(other).status().message(), HasSubstr("7"));
}

}  // namespace
}  // namespace burnish
