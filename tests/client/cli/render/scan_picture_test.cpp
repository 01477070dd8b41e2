#include "client/cli/render/scan_picture.h"

#include <cstdlib>
#include <limits>
#include <optional>

#include <gmock/gmock.h>

#include "client/cli/render/textured_picture.h"
#include "common/mesh/mesh_format.h"
#include "tests/client/cli/render/painted_file.h"
#include "tests/common/mesh/rewrite/textured_grid.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr ImageSize kSize{320, 240};

/// Names another folder for temporary files, while it lives.
class TemporaryFolderElsewhere {
 public:
  explicit TemporaryFolderElsewhere(const std::filesystem::path& folder) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", folder.c_str(), 1);
  }
  ~TemporaryFolderElsewhere() {
    if (before_) {
      setenv("TMPDIR", before_->c_str(), 1);
    } else {
      unsetenv("TMPDIR");
    }
  }
  TemporaryFolderElsewhere(const TemporaryFolderElsewhere&) = delete;
  TemporaryFolderElsewhere& operator=(const TemporaryFolderElsewhere&) = delete;

 private:
  std::optional<std::string> before_;
};

/// Admits everything, and says that it has so much memory.
class MemoryOf : public PreparationBudget {
 public:
  explicit MemoryOf(uint64_t bytes) : bytes_(bytes) {}
  uint64_t memory_bytes_max() const override { return bytes_; }
  Status ask(const PreparationNeed&) override { return Status::ok(); }

 private:
  const uint64_t bytes_;
};

/// Few vertices: their mean colours say little of the pattern.
class PictureOfAPaintedBall : public testing::Test {
 protected:
  ScanPicture draw(const PictureOptions& options, ScanColours colours = ScanColours::kIfAny) {
    auto drawn = draw_scan_picture(file_.path, options, colours);
    EXPECT_TRUE(drawn.is_ok()) << drawn.status().to_string();
    return std::move(*drawn);
  }

  const PaintedFile file_{{.quads_per_side = 8, .face_texels = 254}};
  PictureOptions options_ = unlit_picture(kSize);
};

TEST_F(PictureOfAPaintedBall, ShowsItsTexels) {
  const ScanPicture drawn = draw(options_);
  EXPECT_TRUE(drawn.is_textured);
  EXPECT_THAT(drawn.warnings, IsEmpty());
  EXPECT_GT(part_alike(file_, drawn.image, options_), 0.95);
  PictureOptions by_vertices = options_;
  by_vertices.style.colouring = Colouring::kScan;
  const Image means = draw_picture(file_.mesh, by_vertices).value();
  EXPECT_LT(part_alike(file_, means, options_), 0.2);
}

TEST_F(PictureOfAPaintedBall, ShowsThemFromNearAndWithoutPerspective) {
  options_.zoom = 3;
  EXPECT_GT(part_alike(file_, draw(options_).image, options_), 0.95);
  options_.orthographic = true;
  options_.elevation_degrees = -70;
  EXPECT_GT(part_alike(file_, draw(options_).image, options_), 0.95);
}

TEST_F(PictureOfAPaintedBall, IsLitAsWellAsColoured) {
  options_.style.lighting.kind = LightKind::kClay;
  const ScanPicture drawn = draw(options_);
  EXPECT_TRUE(drawn.is_textured);
  EXPECT_LT(part_alike(file_, drawn.image, options_), 0.5);
}

TEST_F(PictureOfAPaintedBall, HasNoTexelsAsClay) {
  const ScanPicture drawn = draw(options_, ScanColours::kNone);
  EXPECT_FALSE(drawn.is_textured);
  EXPECT_EQ(drawn.image.rgb, draw_picture(file_.mesh, options_)->rgb);
}

/// A square beside its picture.
class PictureOfASquare : public testing::Test {
 protected:
  PictureOfASquare() {
    folder_.write("scan.obj", grid_.obj());
    folder_.write("scan.ply", grid_.ply());
    folder_.write("scan.glb", grid_.glb(skin_).glb());
    folder_.write("skin.mtl", kSkinMtl);
  }

  Result<ScanPicture> draw(const std::string& name, ScanColours colours = ScanColours::kIfAny) {
    PictureOptions options = unlit_picture(kSize);
    options.azimuth_degrees = options.elevation_degrees = 0;
    return draw_scan_picture(folder_ / name, options, colours);
  }

  /// Returns the part of the square's pixels that are one of the picture's two greys.
  static double part_of_the_greys(const Image& image) {
    int sharp = 0, all = 0;
    for (int y = kSize.height / 3; y < kSize.height * 2 / 3; ++y)
      for (int x = kSize.width / 3; x < kSize.width * 2 / 3; ++x, ++all) {
        const int grey = image.pixel(x, y)[1];
        sharp += std::abs(grey - 60) < 12 || std::abs(grey - 190) < 12;
      }
    return double(sharp) / all;
  }

  const TexturedGrid grid_{.begin = 0.05, .end = 0.95};
  const std::string skin_ = png_of(drawn(256, 256, [](uint32_t x, uint32_t) {
    return x / 16 % 2 == 0 ? Rgba8{60, 60, 60, 255} : Rgba8{190, 190, 190, 255};
  }));
  TemporaryFolder folder_;
};

TEST_F(PictureOfASquare, ShowsTexelsOfEveryFormatThatHasPictures) {
  folder_.write("skin.png", skin_);
  for (const std::string name : {"scan.obj", "scan.ply", "scan.glb"}) {
    const auto drawn = draw(name, ScanColours::kNeeded);
    ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
    EXPECT_TRUE(drawn->is_textured) << name;
    EXPECT_GT(part_of_the_greys(drawn->image), 0.7) << name;
  }
}

TEST_F(PictureOfASquare, ThatIsNotThereIsSaid) {
  const auto drawn = draw("scan.obj");
  ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
  EXPECT_FALSE(drawn->is_textured);
  EXPECT_THAT(drawn->warnings, ElementsAre(HasSubstr("skin.png")));
}

TEST_F(PictureOfASquare, ThatIsNotThereIsSaidWhereColoursAreNeededToo) {
  const auto drawn = draw("scan.obj", ScanColours::kNeeded);
  EXPECT_EQ(drawn.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(drawn.status().message(), AllOf(HasSubstr("no colours"), HasSubstr("skin.png")));
}

TEST_F(PictureOfASquare, ThatNamesManyMissingFilesSaysAFewThatATerminalCanShow) {
  std::string materials;
  for (int i = 0; i < 1000; ++i)
    materials +=
        "newmtl m" + std::to_string(i) + "\nmap_Kd \x1b[31m" + std::to_string(i) + ".png\n";
  folder_.write("skin.mtl", materials);
  const auto drawn = draw("scan.obj");
  ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
  ASSERT_THAT(drawn->warnings,
              ElementsAre(AllOf(HasSubstr("?[31m0.png"), HasSubstr("and 995 more"))));
  EXPECT_THAT(drawn->warnings[0], Not(HasSubstr("\x1b")));
}

TEST_F(PictureOfASquare, ThatNoTriangleCanShowIsSaid) {
  folder_.write("skin.png", skin_);
  TexturedGrid odd = grid_;
  odd.shift = 1e9;
  folder_.write("far.obj", odd.obj());
  folder_.write("far.ply", odd.ply());
  odd.shift = std::numeric_limits<double>::quiet_NaN();
  folder_.write("nan.obj", odd.obj());
  folder_.write("nan.ply", odd.ply());
  const auto triangle = [](const std::string& property, const std::string& values) {
    return "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 3\n"
           "property float x\nproperty float y\nproperty float z\nelement face 1\n"
           "property list uchar int vertex_indices\n" +
           property + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2" + values + "\n";
  };
  folder_.write("few.ply", triangle("property list uchar float texcoord\n", " 4 0 0 1 0"));
  folder_.write("none.ply", triangle("", ""));
  for (const std::string name :
       {"far.obj", "far.ply", "nan.obj", "nan.ply", "few.ply", "none.ply"}) {
    const auto drawn = draw(name);
    ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
    EXPECT_FALSE(drawn->is_textured) << name;
    EXPECT_THAT(drawn->warnings, ElementsAre(AllOf(HasSubstr("skin.png"), HasSubstr("1048576"))))
        << name;
  }
}

TEST_F(PictureOfASquare, WithoutAFolderForTemporaryFilesHasMeanColours) {
  folder_.write("skin.png", skin_);
  const std::string nowhere = folder_ / "nowhere";
  const TemporaryFolderElsewhere elsewhere(nowhere);
  const auto drawn = draw("scan.obj");
  ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
  EXPECT_FALSE(drawn->is_textured);
  EXPECT_THAT(drawn->warnings, ElementsAre(AllOf(HasSubstr("mean colours"), HasSubstr(nowhere))));
}

TEST_F(PictureOfASquare, TakesNoMoreThanAPartOfTheMemoryForTextures) {
  const std::string content = TexturedGrid{.cells = 1, .begin = 0.05, .end = 0.95}.glb(skin_).glb();
  const std::vector<uint8_t> bytes(content.begin(), content.end());
  const auto warnings_with = [&](uint64_t memory) {
    MemoryOf budget(memory);
    std::vector<std::string> warnings;
    const auto take = [&](const TexturedSurface& surface) -> Status {
      ASSIGN_OR_RETURN(const TexturedPicture drawn,
                       draw_textured_picture(surface, "square", unlit_picture({640, 480}), budget));
      EXPECT_TRUE(drawn.image.has_value());
      warnings = drawn.warnings;
      return Status::ok();
    };
    const Status read = read_textured_surface(bytes, MeshFormat::kGlb, "square", take);
    EXPECT_TRUE(read.is_ok()) << read.to_string();
    return warnings;
  };
  EXPECT_THAT(warnings_with(uint64_t{1} << 33), IsEmpty());
  EXPECT_THAT(warnings_with(240'000), ElementsAre(HasSubstr("coarser")));
}

TEST_F(PictureOfASquare, ThatIsDamagedIsSaid) {
  folder_.write("skin.png", skin_.substr(0, skin_.size() / 2));
  const auto drawn = draw("scan.ply");
  ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
  EXPECT_THAT(drawn->warnings, ElementsAre(HasSubstr("skin.png")));
}

TEST_F(PictureOfASquare, OfAnotherSizeThanPicturesHaveIsRefusedWithTheLimit) {
  folder_.write("skin.png", skin_);
  const auto drawn = draw_scan_picture(folder_ / "scan.obj", {.size = {4, 4}}, ScanColours::kIfAny);
  EXPECT_EQ(drawn.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(drawn.status().message(), HasSubstr("4x4"));
}

TEST_F(PictureOfASquare, WithoutColoursIsRefusedWhereTheyAreNeeded) {
  folder_.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto drawn = draw("plain.obj", ScanColours::kNeeded);
  EXPECT_EQ(drawn.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(drawn.status().message(), HasSubstr("plain.obj"));
  EXPECT_TRUE(draw("plain.obj").is_ok());
}

TEST_F(PictureOfASquare, OfVertexColoursAloneShowsThem) {
  folder_.write("red.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0.1\nf 1 2 3\n");
  const auto drawn = draw("red.obj");
  ASSERT_TRUE(drawn.is_ok()) << drawn.status().to_string();
  EXPECT_FALSE(drawn->is_textured);
  const uint8_t* middle = drawn->image.pixel(kSize.width / 2 - 10, kSize.height / 2 + 10);
  EXPECT_GT(middle[0], 240);
  EXPECT_LT(middle[1], 10);
}

}  // namespace
}  // namespace burnish
