#include "server/prepare/sheets/build_sheets.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/sheets/sheet_codec.h"
#include "server/prepare/sheets/unfinished_sheets.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/sheets_of_ball.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A painted ball of several pages.
class BuildSheets : public testing::Test {
 protected:
  SheetFile build(const SheetsOptions& options = {}) {
    const auto built = build_sheets_of_archive(zip_, pages_, path_, options, {}, &report_);
    EXPECT_TRUE(built.is_ok()) << built.status().to_string();
    EXPECT_TRUE(*built);
    return open_sheets(path_, pages_);
  }

  TemporaryFolder folder_;
  PaintedBall ball_;
  std::vector<uint8_t> zip_ = ball_.zip();
  PageFile pages_ = pages_of_archive(zip_, folder_ / "ball.pages");
  fs::path path_ = folder_ / "ball.sheets";
  SheetsReport report_;
};

TEST_F(BuildSheets, TheFinestSheetsShowThePictureWithinFortyDecibels) {
  const SheetFile sheets = build();
  EXPECT_GE(psnr_of_level(ball_, pages_, sheets, 0), 40);
  EXPECT_EQ(report_.lost_triangles, 0u);
}

TEST_F(BuildSheets, CoarserSheetsShowTheFinerOnes) {
  const SheetFile sheets = build();
  for (int level = 1; level < pages_.directory().head.level_count(); ++level)
    EXPECT_GE(psnr_of_level(ball_, pages_, sheets, level), 35) << level;
}

TEST_F(BuildSheets, EveryPageHasSheetsThatFitItsCharts) {
  const SheetFile sheets = build();
  const PageHead& head = pages_.directory().head;
  for (PageId id = 0; id < head.page_count(); ++id) {
    const Page page = pages_.read_page(id).value();
    const auto charts = sheets.read_charts(page);
    ASSERT_TRUE(charts.is_ok()) << charts.status().to_string();
    for (size_t halving = 0; halving < sheets.sheet_entries(id).size(); ++halving) {
      const Sheet sheet = sheets.read_sheet(id, halving).value();
      const Status status =
          check_sheet_layout(sheet.layout, page, *charts, sheet.density * head.grid.step());
      EXPECT_TRUE(status.is_ok()) << status.to_string();
    }
  }
}

TEST_F(BuildSheets, OneThreadAndThreeMakeTheSameBytes) {
  build({.threads = 1});
  const std::string one = content_of(path_);
  build({.threads = 3});
  EXPECT_TRUE(content_of(path_) == one);
}

TEST_F(BuildSheets, ArraysInFilesMakeTheSameBytes) {
  build();
  const std::string in_memory = content_of(path_);
  build({.space = ScratchSpace(folder_.path(), 0)});
  EXPECT_TRUE(content_of(path_) == in_memory);
}

TEST_F(BuildSheets, LeaveNothingElseInTheFolder) {
  build();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 2);
}

TEST_F(BuildSheets, APictureThatDoesNotFitOnASheetIsShownByItsMeans) {
  ball_ = {.quads_per_side = 18, .face_texels = 1000};
  zip_ = ball_.zip();
  pages_ = full_pages_of_archive(zip_, folder_ / "ball.pages");
  const SheetFile sheets = build();
  const SheetEntry finest = sheets.sheet_entries(0).front();
  EXPECT_LT(finest.width * finest.height, 0.25 * report_.used_texels);
  EXPECT_GE(psnr_of_level(ball_, pages_, sheets, 0), 40);
}

TEST_F(BuildSheets, ALargePictureOnFewTrianglesIsAsSharpAsTheFile) {
  ball_ = {.quads_per_side = 18, .face_texels = 800, .wave = 0.03};
  zip_ = ball_.zip();
  pages_ = full_pages_of_archive(zip_, folder_ / "ball.pages");
  const double full = psnr_of_level(ball_, pages_, build(), 0);
  pages_ = pages_of_archive(zip_, folder_ / "ball.pages");
  EXPECT_GE(psnr_of_level(ball_, pages_, build(), 0), full + 8);
  EXPECT_EQ(report_.lost_triangles, 0u);
}

TEST_F(BuildSheets, ATextureThatRepeatsOftenIsShownByItsMean) {
  // Each triangle has the picture many times over.
  std::string text = ball_.obj();
  std::string repeated;
  for (size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    std::string line = text.substr(at, end - at);
    if (line.starts_with("vt ")) {
      const double u = std::atof(line.c_str() + 3);
      line = "vt " + std::to_string(u * 1e5) + " " + line.substr(line.rfind(' ') + 1);
    }
    repeated += line + '\n';
  }
  zip_ = zip_of(repeated, png_of(drawn(64, 64, [](uint32_t x, uint32_t) {
                  return Rgba8{static_cast<uint8_t>(x < 32 ? 0 : 200), 100, 50, 255};
                })));
  pages_ = pages_of_archive(zip_, folder_ / "ball.pages");
  const Sheet sheet = build().read_sheet(0, 0).value();
  double sum = 0;
  for (const Rgba8& texel : sheet.texels) sum += texel[0];
  EXPECT_NEAR(sum / static_cast<double>(sheet.texels.size()), 100, 10);
}

/// Returns a bumpy table, whose triangles have vertices of their own at whole numbers.
std::string soup_at_whole_numbers() {
  std::string vertices, faces;
  int count = 0;
  const auto add = [&](int x, int y) {
    const int z = (x * 7 + y * 3) % 5 / 4;
    vertices += "v " + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
    vertices += "vt " + std::to_string(x / 64.0) + ' ' + std::to_string(y / 64.0) + '\n';
    ++count;
    faces += ' ' + std::to_string(count) + '/' + std::to_string(count);
  };
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int half : {0, 1}) {
        faces += "f";
        add(x, y);
        half == 0 ? add(x + 1, y) : add(x + 1, y + 1);
        half == 0 ? add(x + 1, y + 1) : add(x, y + 1);
        faces += '\n';
      }
  return "mtllib ball.mtl\n" + vertices + "usemtl skin\n" + faces;
}

TEST_F(BuildSheets, FindTheTrianglesOfASoupOnPlanesOfTheGrid) {
  // Vertices of one place and one colour are one in pages.
  zip_ = zip_of(soup_at_whole_numbers(), png_of(drawn(64, 64, [](uint32_t x, uint32_t y) {
                  return x + y < 8 ? Rgba8{0, 0, 0, 255} : Rgba8{200, 100, 50, 255};
                })));
  pages_ = pages_of_archive(zip_, folder_ / "ball.pages");
  build();
  EXPECT_EQ(report_.lost_triangles, 0u);
}

TEST_F(BuildSheets, CanBeCancelledInEachPhase) {
  for (const std::string cancelled : {"pictures", "sheets"}) {
    const Progress progress = [&](std::string_view phase, double) { return phase != cancelled; };
    const auto built = build_sheets_of_archive(zip_, pages_, path_, {}, progress);
    EXPECT_EQ(built.status().code(), StatusCode::kCancelled) << cancelled;
    EXPECT_FALSE(fs::exists(path_));
  }
}

TEST_F(BuildSheets, ACancelledBuildGoesOnWhereItWas) {
  build();
  const std::string at_once = content_of(path_);
  fs::remove(path_);
  UnfinishedSheets unfinished;
  const SheetsOptions options{.threads = 1, .unfinished = &unfinished};
  size_t decodings = 0, rounds = 0;
  for (StatusCode code = StatusCode::kCancelled; code == StatusCode::kCancelled; ++rounds) {
    const uint64_t begin = unfinished.pages();
    const Progress until_a_page_more = [&](std::string_view phase, double) {
      decodings += rounds > 0 && phase == "pictures";
      return unfinished.pages() <= begin;
    };
    const auto built =
        build_sheets_of_archive(zip_, pages_, path_, options, until_a_page_more, &report_);
    code = built.status().code();
    ASSERT_TRUE(built.is_ok() || code == StatusCode::kCancelled) << built.status().to_string();
    EXPECT_EQ(report_.kept_pages, begin);
  }
  EXPECT_GT(rounds, 1u);
  EXPECT_EQ(decodings, 0u) << "pictures were decoded again";
  EXPECT_TRUE(content_of(path_) == at_once);
}

TEST_F(BuildSheets, WhatWasMadeOfOtherPagesIsNotKept) {
  UnfinishedSheets unfinished;
  const SheetsOptions options{.threads = 1, .unfinished = &unfinished};
  const Progress until_a_page = [&](std::string_view, double) { return unfinished.pages() == 0; };
  const auto first = build_sheets_of_archive(zip_, pages_, path_, options, until_a_page);
  ASSERT_EQ(first.status().code(), StatusCode::kCancelled);
  ASSERT_GT(unfinished.pages(), 0u);
  ball_.quads_per_side = 20;
  zip_ = ball_.zip();
  pages_ = pages_of_archive(zip_, folder_ / "ball.pages");
  build(options);
  EXPECT_EQ(report_.kept_pages, 0u);
  const std::string after = content_of(path_);
  build();
  EXPECT_TRUE(content_of(path_) == after);
}

TEST_F(BuildSheets, CanBeCancelledInEachLoopBeforeItsPages) {
  constexpr int kLoops = 10;  // of the finder of triangles
  for (int until = 1; until <= kLoops; ++until) {
    int left = until;
    const Progress progress = [&](std::string_view phase, double) {
      return phase != "sheets" || --left > 0;
    };
    const auto built = build_sheets_of_archive(zip_, pages_, path_, {}, progress);
    EXPECT_EQ(built.status().code(), StatusCode::kCancelled) << until;
    EXPECT_EQ(left, 0) << "went on after report " << until;
  }
}

/// Refuses more than its limits.
class SmallBudget final : public PreparationBudget {
 public:
  explicit SmallBudget(uint64_t memory_bytes) : memory_bytes_(memory_bytes) {}
  uint64_t memory_bytes_max() const override { return memory_bytes_; }
  Status ask(const PreparationNeed& need) override {
    if (need.memory_bytes <= memory_bytes_) return Status::ok();
    return resource_exhausted(std::to_string(need.memory_bytes) + " bytes");
  }

 private:
  uint64_t memory_bytes_;
};

TEST_F(BuildSheets, MoreThanTheBudgetIsRefused) {
  SmallBudget small(1 << 20);
  const auto built = build_sheets_of_archive(zip_, pages_, path_, {.budget = &small});
  EXPECT_EQ(built.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(built.status().message(), HasSubstr("10800 triangles"));
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(BuildSheets, ADamagedPictureOfAnObjIsRefused) {
  std::string png = png_of(ball_.picture());
  png.resize(png.size() / 2);
  const auto built = build_sheets_of_archive(ball_.zip(png), pages_, path_);
  EXPECT_EQ(built.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(built.status().message(), HasSubstr("skin.png"));
}

TEST_F(BuildSheets, WithoutAPictureThereAreNone) {
  const auto built = build_sheets_of_archive(ball_.zip("GIF89a"), pages_, path_);
  ASSERT_TRUE(built.is_ok()) << built.status().to_string();
  EXPECT_FALSE(*built);
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(BuildSheets, AnInterlacedPictureMakesTheSameSheets) {
  build();
  const Sheet plain = open_sheets(path_, pages_).read_sheet(0, 0).value();
  ASSERT_TRUE(
      *build_sheets_of_archive(ball_.zip(interlaced_png_of(ball_.picture())), pages_, path_));
  EXPECT_EQ(open_sheets(path_, pages_).read_sheet(0, 0)->texels, plain.texels);
}

// BURNISH_BALL_QUADS=160 BURNISH_BALL_TEXELS=1364 is a scan of 307,200 triangles with a picture of
// 4098 x 2732 texels.
TEST(LargeBall, HasAtMostFourTimesAsManyTexelsAsItsPicture) {
  const char* quads = std::getenv("BURNISH_BALL_QUADS");
  const char* texels = std::getenv("BURNISH_BALL_TEXELS");
  PaintedBall ball;
  if (quads != nullptr) ball.quads_per_side = std::atoi(quads);
  if (texels != nullptr) ball.face_texels = static_cast<uint32_t>(std::atoi(texels));
  const TemporaryFolder folder;
  const std::vector<uint8_t> zip = ball.zip();
  const PageFile pages = pages_of_archive(zip, folder / "ball.pages");
  SheetsReport report;
  const std::clock_t start = std::clock();
  ASSERT_TRUE(*build_sheets_of_archive(zip, pages, folder / "ball.sheets", {}, {}, &report));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const SheetFile sheets = open_sheets(folder / "ball.sheets", pages);
  const auto triangles = static_cast<double>(pages.directory().head.scan_triangles);
  double all = 0;
  for (const SheetsReport::Level& level : report.levels) {
    std::cout << level.pages << " pages, " << level.texels << " texels, " << level.seconds << " s, "
              << psnr_of_level(ball, pages, sheets, int(&level - report.levels.data())) << " dB\n";
    all += static_cast<double>(level.texels);
  }
  std::cout << seconds << " CPU s, pictures " << report.picture_seconds << " s; "
            << seconds / report.used_texels * 1e6 << " s a Mtexel, " << seconds / triangles * 1e6
            << " us a triangle, " << report.used_texels / triangles << " texels a triangle, "
            << all / report.used_texels << " sheet texels a texel, "
            << static_cast<double>(sheets.head().sheet_bytes) / report.used_texels
            << " bytes a texel, " << static_cast<double>(sheets.head().chart_bytes) / triangles
            << " bytes of charts a triangle\n";
  EXPECT_LE(all, 4 * report.used_texels);
}

}  // namespace
}  // namespace burnish
