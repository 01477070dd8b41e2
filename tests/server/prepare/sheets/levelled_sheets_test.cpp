// Sheets whose seams are levelled, beside pictures that were levelled as exports do.

#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "common/mesh/rewrite/pictures/edited_pictures.h"
#include "server/prepare/sheets/build_sheets.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/photo_archive.h"
#include "tests/server/prepare/sheets/sheets_of_ball.h"

namespace burnish {
namespace {

using Zip = std::vector<uint8_t>;

Status with_surface(const Zip& zip, const std::function<Status(const TexturedSurface&)>& use) {
  return read_textured_surface(zip, MeshFormat::kZip, "grid", use);
}

/// Returns the archive as an export has it whose seams are levelled.
Zip exported(const PhotoGrid& grid, const Zip& zip) {
  Zip levelled;
  const Status status = with_surface(zip, [&](const TexturedSurface& surface) -> Status {
    PictureWork work;
    const std::vector<Rgba8> colours(surface.mesh.vertices.size());
    ColourEdit edit{colours, colours};
    edit.seams.amount = 1;
    ASSIGN_OR_RETURN(const auto pictures, edit_pictures(surface, edit, work));
    levelled = zip_of(grid, {pictures.at(0).bytes.begin(), pictures.at(0).bytes.end()});
    return Status::ok();
  });
  EXPECT_TRUE(status.is_ok()) << status.to_string();
  return levelled;
}

/// Photos of a square of several charts.
class LevelledSheetsOf : public testing::Test {
 protected:
  SheetFile build(const Zip& zip, const std::string& name, double amount, int threads = 0) {
    const Status built = with_surface(zip, [&](const TexturedSurface& surface) -> Status {
      std::optional<LevelledSeams> seams;
      if (amount > 0) {
        ASSIGN_OR_RETURN(seams, level_seams(surface, {amount}));
      }
      const SheetsInput input{surface, pages_, "grid", seams ? &*seams : nullptr};
      return build_sheets(input, folder_ / name, {.threads = threads}).status();
    });
    EXPECT_TRUE(built.is_ok()) << built.to_string();
    return open_sheets(folder_ / name, pages_);
  }

  const PhotoGrid grid_;
  TemporaryFolder folder_;
  Zip zip_ = zip_of(grid_);
  PageFile pages_ = pages_of_archive(zip_, folder_ / "grid.pages");
};

/// Returns the mean difference of what two files show on the square, levels of a byte.
double mean_difference(const PhotoGrid& grid, const PageFile& pages, const SheetFile& one,
                       const SheetFile& other) {
  double sum = 0, count = 0;
  for (double y = 0.11; y < grid.side(); y += 0.61)
    for (double x = 0.13; x < grid.side(); x += 0.61, ++count)
      sum += (colour_above(pages, one, x, y) - colour_above(pages, other, x, y)).cwiseAbs().mean();
  return sum / count;
}

TEST_F(LevelledSheetsOf, PhotosShowThePicturesOfAnExport) {
  const SheetFile own = build(zip_, "own", 0), levelled = build(zip_, "levelled", 1);
  const SheetFile wanted = build(exported(grid_, zip_), "exported", 0);
  EXPECT_LT(mean_difference(grid_, pages_, levelled, wanted), 2);  // each was packed with losses
  EXPECT_GT(mean_difference(grid_, pages_, own, wanted), 8);
}

TEST_F(LevelledSheetsOf, PhotosHaveStepsThatFallAsThoseOfAnExport) {
  const SheetFile own = build(zip_, "own", 0), levelled = build(zip_, "levelled", 1);
  const auto step = [&](const SheetFile& sheets) {
    return grid_.median_step(
        [&](double x, double y) { return colour_above(pages_, sheets, x, y); });
  };
  EXPECT_GT(step(own), 15);
  EXPECT_LE(step(levelled), 0.3 * step(own));
}

TEST_F(LevelledSheetsOf, OneThreadAndThreeAreTheSameBytes) {
  build(zip_, "one", 0.7, 1);
  build(zip_, "three", 0.7, 3);
  EXPECT_TRUE(content_of(folder_ / "one") == content_of(folder_ / "three"));
}

}  // namespace
}  // namespace burnish
