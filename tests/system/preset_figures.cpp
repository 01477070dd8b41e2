// Measures each preset at full strength on a tablet with a scanner's noise, for docs/window.md.
// With options of `burnish filter` it measures these alone. preset_figures [VERTICES [NOISE [KIND
// [SEED]]]] [-- OPTION...]

#include <algorithm>
#include <cstdio>

#include "client/tools/presets.h"
#include "common/base/check.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/letters.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

using Words = std::vector<std::string>;

std::vector<Vec3d> filtered(const TriangleMesh& mesh, const Words& options) {
  const TemporaryFolder folder;
  const std::string in = (folder / "in.ply").string(), out = (folder / "out.ply").string();
  BURNISH_CHECK(write_mesh(mesh, in).is_ok(), "the scan is written");
  Words words = {BURNISH_BINARY, "filter", in, out};
  words.insert(words.end(), options.begin(), options.end());
  Process process(words, folder / "log");
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

void print_filtered(const NoisyTablet& tablet, const std::string& name, const Words& options) {
  print_row(name, tablet.contrast(filtered(tablet.noisy(), options),
                                  filtered(tablet.mirrored(), options)));
}

void print_all(const NoisyTablet& tablet, const Words& options) {
  std::printf(
      "| preset | contrast of the letters, mm | noise, mm | contrast over noise | largest move, mm "
      "|\n|---|---|---|---|---|\n");
  print_row("as scanned", tablet.contrast(tablet.noisy().vertices, tablet.mirrored().vertices));
  if (!options.empty()) return print_filtered(tablet, "these options", options);
  for (const Preset& preset : presets())
    print_filtered(tablet, preset.name, {"--preset", preset.name});
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const std::vector<std::string> all(words + 1, words + count);
  const auto mark = std::find(all.begin(), all.end(), "--");
  const std::vector<std::string> scan(all.begin(), mark);
  const std::vector<std::string> options(mark == all.end() ? mark : mark + 1, all.end());
  const auto word = [&](size_t i, const char* otherwise) {
    return i < scan.size() ? scan[i] : std::string(otherwise);
  };
  const auto kind = burnish::parse_noise_kind(word(2, "range"));
  BURNISH_CHECK(kind.is_ok(), kind.status().message());
  burnish::print_all(
      {std::stoull(word(0, "320000")), std::stod(word(1, "0.3")), *kind, std::stoull(word(3, "1"))},
      options);
}
