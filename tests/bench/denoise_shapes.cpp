#include "tests/bench/denoise_shapes.h"

#include <cstdio>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/denoise/shape_error.h"

namespace burnish {

Status write_shape(const NoisyShape& shape, const std::filesystem::path& folder) {
  const std::filesystem::path into = folder / (shape.shape + " " + shape.noise);
  std::filesystem::create_directories(into);
  const auto write = [&into](TriangleMesh mesh, const std::string& name) {
    mesh.has_double_positions = true;
    return write_mesh(mesh, into / (name + ".ply"));
  };
  RETURN_IF_ERROR(write(shape.clean, "clean"));
  RETURN_IF_ERROR(write(shape.noisy, "noisy"));
  ASSIGN_OR_RETURN(TriangleMesh kept, with_edges_kept(shape.noisy, shape.preset.filter));
  RETURN_IF_ERROR(write(std::move(kept), "ours-" + std::string(shape.preset.name)));
  ASSIGN_OR_RETURN(const EdgeFilter proposal, proposed_filter(shape.noisy));
  ASSIGN_OR_RETURN(TriangleMesh proposed, with_edges_kept(shape.noisy, proposal));
  return write(std::move(proposed), "ours-auto");
}

Status print_errors(const std::vector<std::string>& clean_and_others) {
  if (clean_and_others.empty()) return invalid_argument("--measure needs a clean mesh");
  ASSIGN_OR_RETURN(const TriangleMesh clean, read_mesh(clean_and_others[0]));
  for (size_t i = 1; i < clean_and_others.size(); ++i) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(clean_and_others[i]));
    if (mesh.triangles != clean.triangles)
      return invalid_argument(clean_and_others[i] + " has not the triangles of " +
                              clean_and_others[0]);
    const ShapeError error = shape_error(clean, mesh);
    std::printf("%.17g %.17g\n", error.angle, error.distance);
  }
  return Status::ok();
}

}  // namespace burnish
