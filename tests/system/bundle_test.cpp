// An OBJ with its material file and two pictures: in, edited, and out again with all of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/picture/encoding.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Rgba8 shade(uint32_t x, uint32_t y) {
  return {static_cast<uint8_t>(8 * x), static_cast<uint8_t>(8 * y), 60, 255};
}

/// A sphere whose texture coordinates are its x and y.
std::string textured_obj() {
  const TriangleMesh mesh = make_icosphere(3, 1);
  std::string text = "# made by a test\r\nmtllib ball.mtl\r\n";
  const auto put = [&](const char* keyword, std::initializer_list<double> numbers) {
    text += keyword;
    for (const double number : numbers) text += " " + std::to_string(number);
    text += "\r\n";
  };
  for (const Vec3d& v : mesh.vertices) put("v", {v.x(), v.y(), v.z()});
  for (const Vec3d& v : mesh.vertices) put("vt", {0.5 + 0.4 * v.x(), 0.5 + 0.4 * v.y()});
  text += "usemtl skin\r\n";
  for (const Triangle& t : mesh.triangles) {
    text += "f";
    for (const uint32_t v : t) text += " " + std::to_string(v + 1) + "/" + std::to_string(v + 1);
    text += "\r\n";
  }
  return text;
}

/// A server with the scan in a session "work".
class BundleOnAServer : public testing::Test {
 protected:
  BundleOnAServer() {
    std::filesystem::create_directories(in() / "maps");
    server_.folder.write("in/ball.obj", textured_obj());
    server_.folder.write("in/ball.mtl",
                         "newmtl skin\nmap_Kd maps/skin.png\nmap_Bump -bm 0.5 bumps.jpg\n");
    server_.folder.write("in/maps/skin.png", png_of(drawn(32, 32, shade)));
    server_.folder.write("in/bumps.jpg", jpeg_of(drawn(16, 16, shade)));
    EXPECT_THAT(done({"import", (in() / "ball.obj").string(), "--depth", "5"}),
                HasSubstr("with 3 files"));
    done({"open", "ball", "--depth", "5", "--session", "work"});
  }

  std::filesystem::path in() const { return server_.folder / "in"; }
  std::string path(const std::string& name) const { return (server_.folder / name).string(); }

  std::string done(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return outcome.output;
  }

  void expect_same_files(const std::filesystem::path& folder, const std::string& mesh) {
    for (const char* name : {"ball.mtl", "maps/skin.png", "bumps.jpg"})
      EXPECT_EQ(content_of(folder / name), content_of(in() / name)) << name;
    EXPECT_EQ(content_of(folder / mesh), content_of(in() / "ball.obj"));
  }

  ServerProcess server_;
};

TEST_F(BundleOnAServer, AnUneditedScanComesOutByteForByte) {
  std::filesystem::create_directory(path("beside"));
  done({"export", "work", path("beside/out.obj")});
  expect_same_files(path("beside"), "out.obj");
  done({"export", "work", path("folder/")});
  expect_same_files(path("folder"), "ball.obj");
  done({"export", "work", path("out.zip")});
  EXPECT_THAT(done({"import", path("out.zip")}), HasSubstr("already there"));
  EXPECT_THAT(done({"import", in().string()}), HasSubstr("already there"));
}

TEST_F(BundleOnAServer, OneFileThatGoesAlongIsToldInTheSingular) {
  std::filesystem::create_directories(path("one"));
  server_.folder.write("one/ball.obj", "# another\n" + textured_obj());
  server_.folder.write("one/ball.mtl", "newmtl skin\nKd 1 0 0\n");
  EXPECT_THAT(done({"import", path("one/ball.obj"), "--depth", "5"}),
              HasSubstr("with 1 file that it names: ball.mtl"));
}

TEST_F(BundleOnAServer, AnEditMovesTheObjAlone) {
  done({"edit", "work", "--beta", "0"});
  std::filesystem::create_directory(path("beside"));
  done({"export", "work", path("beside/out.obj")});
  EXPECT_NE(content_of(path("beside/out.obj")), content_of(in() / "ball.obj"));
  EXPECT_EQ(content_of(path("beside/maps/skin.png")), content_of(in() / "maps/skin.png"));
  EXPECT_THAT(content_of(path("beside/out.obj")), HasSubstr("mtllib ball.mtl\r\n"));
}

TEST_F(BundleOnAServer, AFileWithOtherContentIsReplacedByForceOnly) {
  std::filesystem::create_directory(path("beside"));
  server_.folder.write("beside/ball.mtl", "mine");
  const CommandOutcome refused = server_.burnish({"export", "work", path("beside/out.obj")});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("beside/ball.mtl"));
  EXPECT_THAT(refused.output, HasSubstr("another folder"));
  EXPECT_THAT(refused.output, HasSubstr("--force"));
  EXPECT_THAT(refused.output, testing::Not(HasSubstr(".burnish-export")));
  EXPECT_EQ(content_of(path("beside/ball.mtl")), "mine");
  done({"export", "work", path("beside/out.obj"), "--force"});
  expect_same_files(path("beside"), "out.obj");
}

TEST_F(BundleOnAServer, APlyHasTheTexturesColours) {
  EXPECT_THAT(done({"export", "work", path("out.ply")}), HasSubstr("pictures"));
  const TriangleMesh mesh = read_mesh(path("out.ply")).value();
  ASSERT_TRUE(mesh.has_colours());
  for (size_t v = 0; v < mesh.vertices.size(); v += 50) {
    const double u = 0.5 + 0.4 * mesh.vertices[v].x();
    const double from_top = 0.5 - 0.4 * mesh.vertices[v].y();
    EXPECT_NEAR(mesh.colours[v][0], 8 * (32 * u - 0.5), 1.5) << v;
    EXPECT_NEAR(mesh.colours[v][1], 8 * (32 * from_top - 0.5), 1.5) << v;
  }
}

}  // namespace
}  // namespace burnish
