// The presets on a tablet with a scanner's noise, through the program.

#include <gtest/gtest.h>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/letters.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

class Presets : public testing::Test {
 protected:
  std::vector<Vec3d> filtered(const TriangleMesh& mesh, const std::string& preset) {
    const std::string in = (folder_ / "in.ply").string(), out = (folder_ / "out.ply").string();
    EXPECT_TRUE(write_mesh(mesh, in).is_ok());
    Process process({BURNISH_BINARY, "filter", in, out, "--preset", preset}, folder_ / "log");
    EXPECT_EQ(process.wait(std::chrono::minutes(4)), 0) << process.output();
    const auto read = read_mesh(out);
    return read.is_ok() ? read->vertices : mesh.vertices;
  }

  LetterContrast after(const std::string& preset) {
    return tablet_.contrast(filtered(tablet_.noisy(), preset),
                            filtered(tablet_.mirrored(), preset));
  }

  // Coarse for speed: a stroke is hardly wider than two cells, so its own height falls a little.
  // preset_figures measures a finer scan.
  const TemporaryFolder folder_;
  const NoisyTablet tablet_{90'000, 0.3};
  const LetterContrast before_ =
      tablet_.contrast(tablet_.noisy().vertices, tablet_.mirrored().vertices);
};

TEST_F(Presets, BringOutAnInscriptionRaisesTheLettersContrastToNoiseOnANoisyTablet) {
  const LetterContrast brought = after("Bring out an inscription");
  EXPECT_GT(brought.contrast, 0.8 * before_.contrast);
  EXPECT_LT(brought.noise, before_.noise);
  EXPECT_GT(brought.ratio(), 1.5 * before_.ratio());
  EXPECT_LT(brought.largest_move, 8);
}

TEST_F(Presets, SharpeningAtFullStrengthBuriesNoLetters) {
  const LetterContrast sharp = after("Sharpen all");
  EXPECT_GT(sharp.contrast, 0.9 * before_.contrast);
  EXPECT_GT(sharp.ratio(), before_.ratio());
  EXPECT_LT(sharp.largest_move, 8);
}

TEST_F(Presets, ReduceScannerNoiseTakesHalfOfItAndLeavesTheLetters) {
  const LetterContrast calm = after("Reduce scanner noise");
  EXPECT_LT(calm.noise, 0.5 * before_.noise);
  EXPECT_GT(calm.contrast, 0.6 * before_.contrast);
}

}  // namespace
}  // namespace burnish
