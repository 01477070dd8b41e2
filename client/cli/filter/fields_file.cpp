#include "client/cli/filter/fields_file.h"

#include <cstdio>
#include <string>

#include "common/base/atomic_file.h"
#include "common/grid/morton.h"

namespace burnish {

template <typename... Numbers>
static void append(std::string& text, const char* format, Numbers... numbers) {
  char line[512];
  std::snprintf(line, sizeof line, format, numbers...);
  text += line;
}

static void append_header(std::string& text, const PreparedMesh& prepared) {
  const GridFrame& frame = prepared.frame;
  append(text, "# origin %.17g %.17g %.17g cell_size %.17g L %.17g depth %d", frame.origin.x(),
         frame.origin.y(), frame.origin.z(), frame.cell_size, prepared.length_unit, frame.depth);
  text += "; columns i j k alpha1 alpha2 beta kappa1 kappa2\n";
}

Status write_fields_file(const Session& session, const std::filesystem::path& path) {
  const PreparedMesh& prepared = session.prepared();
  const CellAlphas alphas = session.fields().alphas();
  const std::span<const float> beta = session.fields().view().beta;
  std::string text;
  append_header(text, prepared);
  for (size_t c = 0; c < prepared.cells.size(); ++c) {
    const Vec3i cell = morton_point(prepared.cells[c]);
    append(text, "%d %d %d %.9g %.9g %.9g %.9g %.9g\n", cell.x(), cell.y(), cell.z(),
           static_cast<double>(alphas.alpha1[c]), static_cast<double>(alphas.alpha2[c]),
           static_cast<double>(beta[c]), static_cast<double>(prepared.curvature[c].kappa1),
           static_cast<double>(prepared.curvature[c].kappa2));
  }
  return write_file(path, text);
}

}  // namespace burnish
