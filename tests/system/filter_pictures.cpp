// Draws an inscription as scanned, after a filter of other programs, and after two of ours, for the
// README. Prints how well its letters can be told from the noise, there and after Taubin's filter.
// filter_pictures OUT

#include <cstdio>
#include <filesystem>
#include <functional>

#include "client/pictures/picture.h"
#include "client/scene/png_writer.h"
#include "common/base/check.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/letters.h"
#include "tests/system/process.h"
#include "tests/system/sheet.h"

namespace burnish {
namespace {

// As in deploy/demo.
constexpr uint64_t kVertices = 320'000;
constexpr double kNoise = 0.3;

constexpr ImageSize kPicture{2560, 1920};  // drawn at twice the size of the sheet
constexpr Box kInscription{640, 960, 940, 600};

using Positions = std::vector<Vec3d>;

/// Moves each vertex this part of the way to the mean of its neighbours (the umbrella operator of
/// Taubin 1995, section 3).
Positions relaxed(const TriangleMesh& mesh, const Positions& from, double part) {
  Positions sums(from.size(), Vec3d::Zero());
  std::vector<double> counts(from.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const uint32_t a = t[i], b = t[(i + 1) % 3];  // the neighbour's triangle has b, a
      sums[a] += from[b];
      counts[a] += 1;
    }
  Positions to = from;
  for (size_t v = 0; v < to.size(); ++v)
    if (counts[v] > 0) to[v] += part * (sums[v] / counts[v] - from[v]);
  return to;
}

Positions laplacian(const TriangleMesh& mesh) {
  constexpr int kSteps = 3;
  Positions to = mesh.vertices;
  for (int step = 0; step < kSteps; ++step) to = relaxed(mesh, to, 1);
  return to;
}

Positions taubin(const TriangleMesh& mesh) {
  constexpr int kSteps = 10;
  constexpr double kShrink = 0.5, kGrow = -0.53;
  Positions to = mesh.vertices;
  for (int step = 0; step < kSteps; ++step) to = relaxed(mesh, relaxed(mesh, to, kShrink), kGrow);
  return to;
}

Positions ours(const TriangleMesh& mesh, const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  const std::string in = (folder / "in.ply").string(), out = (folder / "out.ply").string();
  BURNISH_CHECK(write_mesh(mesh, in).is_ok(), "the scan is written");
  std::vector<std::string> words = {BURNISH_BINARY, "filter", in, out};
  words.insert(words.end(), options.begin(), options.end());
  Process process(words, folder / "log");
  BURNISH_CHECK(process.wait(std::chrono::minutes(20)) == 0, "the scan is filtered");
  const auto read = read_mesh(out);
  BURNISH_CHECK(read.is_ok(), "the result is read");
  return read->vertices;
}

Positions preset(const TriangleMesh& mesh) {
  return ours(mesh, {"--preset", "Bring out an inscription"});
}

Positions edges_kept(const TriangleMesh& mesh) {
  return ours(mesh, {"--keep-edges", "machined", "--crispness", "0.5", "--beta", "2.2",
                     "--wavelength", "40"});
}

Image draw(TriangleMesh mesh, Positions positions) {
  mesh.vertices = std::move(positions);
  PictureOptions picture{.size = kPicture, .azimuth_degrees = 0, .elevation_degrees = 0};
  auto image = draw_picture(mesh, picture);
  BURNISH_CHECK(image.is_ok(), "the picture is drawn");
  return halved(cut(*image, kInscription));
}

struct Filter {
  const char* name;
  std::function<Positions(const TriangleMesh&)> apply;
  bool is_drawn = true;
};

void draw_all(const std::filesystem::path& out) {
  const NoisyTablet tablet(kVertices, kNoise);
  const Filter filters[] = {{"as scanned", [](const TriangleMesh& mesh) { return mesh.vertices; }},
                            {"Laplacian smoothing", laplacian},
                            {"Taubin smoothing", taubin, false},
                            {"Burnish, preset", preset},
                            {"Burnish, edges kept", edges_kept}};
  std::vector<Image> tiles;
  for (const Filter& filter : filters) {
    Positions noisy = filter.apply(tablet.noisy());
    const LetterContrast told = tablet.contrast(noisy, filter.apply(tablet.mirrored()));
    std::printf("| %s | %.2f | %.2f | %.1f |\n", filter.name, told.contrast, told.noise,
                told.ratio());
    if (filter.is_drawn) tiles.push_back(draw(tablet.noisy(), std::move(noisy)));
  }
  BURNISH_CHECK(write_png(in_rows(tiles, 2), out / "inscription.png").is_ok(),
                "the sheet is written");
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: filter_pictures OUT\n");
    return 2;
  }
  burnish::draw_all(words[1]);
}
