// Measures each preset at full strength on a tablet with a scanner's noise, for docs/window.md.
// preset_figures [VERTICES [NOISE [PRESET]]]

#include <cstdio>
#include <cstdlib>

#include "client/tools/presets.h"
#include "common/base/check.h"
#include "common/mesh/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/letters.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

std::vector<Vec3d> filtered(const TriangleMesh& mesh, const std::string& preset) {
  const TemporaryFolder folder;
  const std::string in = (folder / "in.ply").string(), out = (folder / "out.ply").string();
  BURNISH_CHECK(write_mesh(mesh, in).is_ok(), "the scan is written");
  Process process({BURNISH_BINARY, "filter", in, out, "--preset", preset}, folder / "log");
  BURNISH_CHECK(process.wait(std::chrono::minutes(20)) == 0, "the scan is filtered");
  const auto read = read_mesh(out);
  BURNISH_CHECK(read.is_ok(), "the result is read");
  return read->vertices;
}

void print_row(const std::string& name, const LetterContrast& row) {
  std::printf("| %s | %.2f | %.2f | %.1f | %.1f |\n", name.c_str(), row.contrast, row.noise,
              row.ratio(), row.largest_move);
  std::fflush(stdout);
}

void print_all(const NoisyTablet& tablet, const std::string& only) {
  std::printf(
      "| preset | contrast of the letters, mm | noise, mm | contrast over noise | largest move, mm "
      "|\n|---|---|---|---|---|\n");
  print_row("as scanned", tablet.contrast(tablet.noisy().vertices, tablet.clean().vertices));
  for (const Preset& preset : presets())
    if (only.empty() || only == preset.name)
      print_row(preset.name, tablet.contrast(filtered(tablet.noisy(), preset.name),
                                             filtered(tablet.clean(), preset.name)));
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const uint64_t vertices = count > 1 ? std::strtoull(words[1], nullptr, 10) : 320'000;
  const double noise = count > 2 ? std::strtod(words[2], nullptr) : 0.3;
  burnish::print_all({vertices, noise}, count > 3 ? words[3] : "");
}
