#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layering/layers.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Layers the_table() {
  return std::move(read_layers(fs::path(SOURCE_ROOT) / "tests/layering/layers.txt")).value();
}

class Layering : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / (std::string("burnish_layering_") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  fs::path root_;
};

TEST(Layers, TheTreesIncludesGoOneWay) {
  EXPECT_THAT(check_includes(SOURCE_ROOT, {"common", "server", "client"}, the_table()), IsEmpty());
}

TEST(Layers, TheTreesTargetsLinkOneWay) {
  std::stringstream targets;
  targets << std::ifstream(TARGET_LIST).rdbuf();
  ASSERT_THAT(targets.str(), HasSubstr("link burnish_mesh burnish_base"));
  EXPECT_THAT(check_targets(TARGET_LIST, the_table()), IsEmpty());
}

TEST_F(Layering, APlantedWrongIncludeIsNamedByFileAndLine) {
  fs::copy(fs::path(SOURCE_ROOT) / "common", root_ / "common", fs::copy_options::recursive);
  ASSERT_THAT(check_includes(root_, {"common"}, the_table()), IsEmpty());
  write("common/grid/planted.cpp",
        "#include \"common/grid/grid.h\"\n\n#include \"server/solver/solver.h\"\n");
  EXPECT_THAT(
      check_includes(root_, {"common"}, the_table()),
      ElementsAre("common/grid/planted.cpp:3: common/grid may not depend on server/solver"));
}

TEST_F(Layering, OnlyTheFilterCommandOfTheClientMayRunTheSolver) {
  write("client/cli/filter/filter_command.cpp", "#include \"server/solver/solver.h\"\n");
  write("client/cli/render_command.cpp", "#include \"server/solver/solver.h\"\n");
  EXPECT_THAT(check_includes(root_, {"client"}, the_table()),
              ElementsAre(HasSubstr("client/cli/render_command.cpp:1:")));
}

TEST_F(Layering, GraphicsAndTransportHeadersStayInTheirFolders) {
  write("common/mesh/a.cpp", "#include <epoxy/gl.h>\n#include <vector>\n#  include <grpcpp/x.h>\n");
  write("client/gl/a.cpp", "#include <epoxy/gl.h>\n");
  EXPECT_THAT(check_includes(root_, {"common", "client"}, the_table()),
              ElementsAre(HasSubstr("common/mesh/a.cpp:1:"), HasSubstr("common/mesh/a.cpp:3:")));
}

TEST_F(Layering, AFileOfNoLayerIsNamed) {
  write("common/stray/a.cpp", "\n");
  EXPECT_THAT(check_includes(root_, {"common"}, the_table()),
              ElementsAre(HasSubstr("common/stray/a.cpp:1: the file is of no layer")));
}

TEST_F(Layering, APlantedWrongLinkIsNamedByItsTargets) {
  write("targets.txt",
        "source mesh common/mesh/a.cpp\nsource session server/session/a.cpp\n"
        "link session mesh\nlink mesh session\nlink mesh gRPC::grpc++\n");
  EXPECT_THAT(check_targets(root_ / "targets.txt", the_table()),
              ElementsAre(HasSubstr("target mesh links gRPC::grpc++"),
                          HasSubstr("target mesh links session: common/mesh may not")));
}

TEST_F(Layering, ATableWithACircleIsRefusedByLine) {
  write("layers.txt", "# two\nlayer a : b\nlayer b : a\n");
  const auto layers = read_layers(root_ / "layers.txt");
  ASSERT_FALSE(layers.is_ok());
  EXPECT_THAT(layers.status().message(),
              HasSubstr("layers.txt:2: a names b, which does not stand above it"));
}

constexpr const char* kParts =
    "layer base :\n"
    "layer mesh : base\npart mesh/ply : mesh\npart mesh/io : mesh mesh/ply\n"
    "part model/view :\npart model/files : model/view\nlayer model : mesh model/files\n"
    "only thread : model\nonly fstream : model/files\n";

TEST_F(Layering, WhoMayIncludeALayerMayIncludeItsParts) {
  write("layers.txt", kParts);
  const Layers layers = std::move(read_layers(root_ / "layers.txt")).value();
  EXPECT_EQ(layers.objection("model", "mesh/ply/a.h"), "");
  EXPECT_EQ(layers.objection("model/view", "mesh/io/a.h"), "");
  EXPECT_EQ(layers.objection("mesh/ply", "base/a.h"), "");
  EXPECT_EQ(layers.objection("model/view", "base/a.h"), "model/view may not depend on base");
  EXPECT_EQ(layers.objection("base", "mesh/ply/a.h"), "base may not depend on mesh/ply");
}

TEST_F(Layering, APartMayIncludeThePartsThatItNames) {
  write("layers.txt", kParts);
  const Layers layers = std::move(read_layers(root_ / "layers.txt")).value();
  EXPECT_EQ(layers.objection("mesh/io", "mesh/ply/a.h"), "");
  EXPECT_EQ(layers.objection("mesh/io", "mesh/a.h"), "");
  EXPECT_EQ(layers.objection("model", "model/files/a.h"), "");
  EXPECT_EQ(layers.objection("mesh", "mesh/ply/a.h"), "mesh may not depend on mesh/ply");
  EXPECT_EQ(layers.objection("mesh/ply", "mesh/io/a.h"), "mesh/ply may not depend on mesh/io");
  EXPECT_EQ(layers.objection("model", "model/view/a.h"), "model may not depend on model/view");
  EXPECT_EQ(layers.objection("model/files", "model/a.h"), "model/files may not depend on model");
}

TEST_F(Layering, AnOnlyLineNamesALayerWithItsPartsOrOnePart) {
  write("layers.txt", kParts);
  const Layers layers = std::move(read_layers(root_ / "layers.txt")).value();
  EXPECT_EQ(layers.objection("model/view", "thread"), "");
  EXPECT_EQ(layers.objection("model/files", "fstream"), "");
  EXPECT_THAT(layers.objection("model", "fstream"), HasSubstr("other folders than model"));
  EXPECT_THAT(layers.objection("model/view", "fstream"), HasSubstr("than model/view"));
}

TEST_F(Layering, APartOfAnotherLayerCannotBeNamed) {
  write("layers.txt", "layer a :\npart a/x : a\nlayer b : a/x\n");
  EXPECT_THAT(read_layers(root_ / "layers.txt").status().message(),
              HasSubstr("layers.txt:3: b names a/x, but one is a part of another layer"));
  write("layers.txt", "layer a :\nlayer b : a\npart a/x : b\n");
  EXPECT_THAT(read_layers(root_ / "layers.txt").status().message(),
              HasSubstr("layers.txt:3: a/x names b, but one is a part of another layer"));
  write("layers.txt", "layer b :\npart a/x :\n");
  EXPECT_THAT(read_layers(root_ / "layers.txt").status().message(),
              HasSubstr("part a/x: a is not a layer"));
}

TEST(Twins, EachUnitOfABackendHasATwinOrAReason) {
  EXPECT_THAT(check_twins(SOURCE_ROOT, fs::path(SOURCE_ROOT) / "tests/layering/twins.txt"),
              IsEmpty());
}

TEST_F(Layering, AUnitWithoutATwinIsNamed) {
  write("server/solver/cpu/products/transfer.cpp", "");
  write("server/solver/cuda/products/transfer.cu", "");
  write("server/solver/cuda/smoothers/transfer.cu", "");
  write("twins.txt", "");
  EXPECT_THAT(check_twins(root_, root_ / "twins.txt"),
              ElementsAre("server/solver/cuda/smoothers/transfer has no twin"));
}

TEST_F(Layering, AListedUnitMayBeAloneAndNoOtherMayBeListed) {
  write("server/solver/cpu/blocks.h", "");
  write("server/solver/cpu/products/transfer.cpp", "");
  write("server/solver/cuda/device/stream.cpp", "");
  write("server/solver/cuda/products/transfer.cu", "");
  write("twins.txt", "# two\ncpu/blocks : a\ncuda/device/ : b\ncpu/products/transfer : c\n");
  EXPECT_THAT(check_twins(root_, root_ / "twins.txt"),
              ElementsAre("twins.txt lists cpu/products/transfer, which is not alone"));
}

}  // namespace
}  // namespace burnish
