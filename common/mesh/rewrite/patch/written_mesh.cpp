#include "common/mesh/rewrite/patch/written_mesh.h"

#include <cmath>
#include <utility>

#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/patch/ply_number.h"

namespace burnish {

static constexpr size_t kParallelVertices = 10'000;  // fewer are not worth waking the threads

/// Returns the diagonal of the box around all triangles, before they moved. Returns 0 if there are
/// none.
static double diagonal_of(const MovedMesh& moved) {
  if (moved.after.triangles.empty()) return 0;
  Vec3d lowest = moved.before[moved.after.triangles[0][0]], highest = lowest;
  for (const Triangle& triangle : moved.after.triangles)
    for (const uint32_t v : triangle) {
      lowest = lowest.cwiseMin(moved.before[v]);
      highest = highest.cwiseMax(moved.before[v]);
    }
  return (highest - lowest).norm();
}

WrittenNumber WrittenNumber::of_text(const MovedMesh& moved, TextDigits digits) {
  const bool is_double = moved.after.has_double_positions;
  digits.refine(kTextStepShare * diagonal_of(moved));
  if (!is_double) digits.limit_to_float();
  return {.type = is_double ? PlyType::kFloat64 : PlyType::kFloat32,
          .is_text = true,
          .digits = std::move(digits)};
}

WrittenNumber WrittenNumber::of_normals(TextDigits digits) {
  digits.refine(kNormalStep);
  digits.ignore_magnitude();
  digits.limit_to_float();
  return {.type = PlyType::kFloat32, .is_text = true, .digits = std::move(digits)};
}

static std::string shortest_text(PlyType type, double value) {
  return ply_number(type, PlyEncoding::kAscii, value);
}

double WrittenNumber::kept(double value, double before) const {
  if (digits) return digits->kept(value, before);
  double kept = kept_by(type, value);
  // The shortest text of a float is another double than the float.
  if (is_text && type == PlyType::kFloat32) parse_double(shortest_text(type, kept), kept);
  return kept;
}

bool WrittenNumber::tells_apart(double value, double before) const {
  if (digits) return digits->kept(value, before) != digits->kept(before, before);
  return kept_by(type, value) != kept_by(type, before);
}

double WrittenNumber::nearer(double kept, double before) const {
  double next = std::nextafter(kept, before);
  if (digits || is_integer(type))
    next = kept + std::copysign(digits ? digits->step(kept, before) : 1, before - kept);
  else if (type == PlyType::kFloat32)
    next = std::nextafter(static_cast<float>(kept), static_cast<float>(before));
  next = this->kept(next, before);
  const bool lies_between =
      before < kept ? before < next && next < kept : kept < next && next < before;
  return lies_between ? next : before;
}

std::string WrittenNumber::text_of(double kept, double before, std::string_view old) const {
  return digits ? digits->text_of(kept, before, old) : shortest_text(type, kept);
}

WrittenMesh::WrittenMesh(const MovedMesh& moved, std::array<WrittenNumber, 3> axes)
    : axes_(std::move(axes)), vertices_(moved.before.size()), written_(moved) {
#pragma omp parallel for schedule(static) if (vertices_.size() >= kParallelVertices)
  for (size_t v = 0; v < vertices_.size(); ++v)
    vertices_[v] = position(moved.before[v], moved.after.vertices[v]);
  written_.after.vertices = vertices_;
}

Vec3d WrittenMesh::position(const Vec3d& before, const Vec3d& after) const {
  Vec3d written = before;
  for (int i = 0; i < 3; ++i) {
    const WrittenNumber& axis = axes_[static_cast<size_t>(i)];
    if (after[i] != before[i] && axis.tells_apart(after[i], before[i]))
      written[i] = axis.kept(after[i], before[i]);
  }
  if (!(written_.cap > 0) || (written - before).norm() <= written_.cap) return written;
  for (int i = 0; i < 3; ++i)
    if (std::abs(written[i] - before[i]) > std::abs(after[i] - before[i]))
      written[i] = axes_[static_cast<size_t>(i)].nearer(written[i], before[i]);
  return written;
}

}  // namespace burnish
