#include "tests/reference/curvature.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace burnish::reference {

using Eigen::Matrix3d;

bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > kDegenerateRatio * longest);
}

bool is_inside_out(const TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> triangles_of_edge;
  const Vec3d middle = mesh.vertices[mesh.triangles[0][0]];
  double six_volumes = 0;
  for (const Triangle& t : mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (int i = 0; i < 3; ++i) ++triangles_of_edge[std::minmax(t[i], t[(i + 1) % 3])];
    const Vec3d a = mesh.vertices[t[0]] - middle;
    six_volumes += a.dot((mesh.vertices[t[1]] - middle).cross(mesh.vertices[t[2]] - middle));
  }
  const bool closed = std::none_of(triangles_of_edge.begin(), triangles_of_edge.end(),
                                   [](const auto& edge) { return edge.second == 1; });
  return closed && six_volumes < 0;
}

Vec3d nearest_areas(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d p[3] = {a, b, c};
  const double twice_area = (b - a).cross(c - a).norm();
  double dot[3], length2[3];  // at corner i: of its two sides; of the opposite side
  for (int i = 0; i < 3; ++i) {
    const Vec3d& q = p[(i + 1) % 3];
    const Vec3d& r = p[(i + 2) % 3];
    dot[i] = (q - p[i]).dot(r - p[i]);
    length2[i] = (q - r).squaredNorm();
  }
  Vec3d areas;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    if (dot[i] < 0) {
      // The bisector of side i-j leaves through the side opposite i and cuts a right triangle off
      // j.
      areas[j] = length2[k] / 8 * twice_area / dot[j];
      areas[k] = length2[j] / 8 * twice_area / dot[k];
      areas[i] = twice_area / 2 - areas[j] - areas[k];
      return areas;
    }
    areas[i] = (length2[j] * dot[j] + length2[k] * dot[k]) / (8 * twice_area);
  }
  return areas;
}

namespace {

constexpr double kCancelledRatio = 1e-12;  // of a vertex normal over the sum of its weights

struct Face {
  Vec3d p[3];
  std::array<uint32_t, 3> vertex;
  Vec3d normal;
};

/// Returns the triangles with an area, turned so that normals point outwards.
std::vector<Face> faces_of(const TriangleMesh& mesh, std::vector<size_t>& triangle_of_face) {
  const double side = is_inside_out(mesh) ? -1 : 1;
  std::vector<Face> faces;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    Face face;
    face.vertex = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) face.p[i] = mesh.vertices[face.vertex[i]];
    if (is_degenerate(face.p[0], face.p[1], face.p[2])) continue;
    face.normal = side * (face.p[1] - face.p[0]).cross(face.p[2] - face.p[0]).normalized();
    faces.push_back(face);
    triangle_of_face.push_back(t);
  }
  return faces;
}

/// Each corner adds its triangle's normal times sin(angle) / (product of its sides) (Max 1999),
/// which is exact for vertices on a sphere. Zero if the parts cancel, except for rounding.
std::vector<Vec3d> vertex_normals(const std::vector<Face>& faces, size_t vertex_count) {
  std::vector<Vec3d> normals(vertex_count, Vec3d::Zero());
  std::vector<double> weights(vertex_count, 0);
  for (const Face& face : faces) {
    for (int i = 0; i < 3; ++i) {
      const Vec3d a = face.p[(i + 1) % 3] - face.p[i];
      const Vec3d b = face.p[(i + 2) % 3] - face.p[i];
      const double weight = a.cross(b).norm() / (a.squaredNorm() * b.squaredNorm());
      normals[face.vertex[i]] += weight * face.normal;
      weights[face.vertex[i]] += weight;
    }
  }
  for (size_t v = 0; v < vertex_count; ++v) {
    const bool cancelled = normals[v].norm() <= kCancelledRatio * weights[v];
    normals[v] = cancelled ? Vec3d::Zero() : Vec3d(normals[v].normalized());
  }
  return normals;
}

/// Returns the symmetric tensor in the face's plane that best maps its three edges to the
/// differences of the vertex normals along them, in least squares.
Matrix3d face_tensor(const Face& face, const std::vector<Vec3d>& normals) {
  const Vec3d u = (face.p[1] - face.p[0]).normalized();
  const Vec3d v = face.normal.cross(u);
  Eigen::Matrix<double, 6, 3> rows;  // of the unknowns: II = [x0 x1; x1 x2]
  Eigen::Matrix<double, 6, 1> values;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3d edge = face.p[j] - face.p[i];
    const Vec3d change = normals[face.vertex[j]] - normals[face.vertex[i]];
    rows.row(2 * i) << edge.dot(u), edge.dot(v), 0;
    rows.row(2 * i + 1) << 0, edge.dot(u), edge.dot(v);
    values.segment<2>(2 * i) << change.dot(u), change.dot(v);
  }
  const Vec3d x = rows.colPivHouseholderQr().solve(values);
  return x[0] * u * u.transpose() + x[1] * (u * v.transpose() + v * u.transpose()) +
         x[2] * v * v.transpose();
}

/// Returns the tensor turned by the least rotation that takes one normal to the other. Opposite
/// normals share their plane, so the tensor stays unchanged.
Matrix3d carried(const Matrix3d& tensor, const Vec3d& from, const Vec3d& to) {
  if (from.dot(to) < -1 + 1e-12 || from.isZero(0)) return tensor;
  const Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
  return turn * tensor * turn.transpose();
}

std::vector<Matrix3d> vertex_tensors(const std::vector<Face>& faces,
                                     const std::vector<Vec3d>& normals) {
  std::vector<Matrix3d> tensors(normals.size(), Matrix3d::Zero());
  std::vector<double> weights(normals.size(), 0);
  for (const Face& face : faces) {
    const Matrix3d tensor = face_tensor(face, normals);
    const Vec3d areas = nearest_areas(face.p[0], face.p[1], face.p[2]);
    for (int i = 0; i < 3; ++i) {
      const uint32_t vertex = face.vertex[i];
      if (normals[vertex].isZero(0)) continue;  // no tangent plane, no tensor
      tensors[vertex] += areas[i] * carried(tensor, face.normal, normals[vertex]);
      weights[vertex] += areas[i];
    }
  }
  for (size_t v = 0; v < tensors.size(); ++v)
    if (weights[v] > 0) tensors[v] /= weights[v];
  return tensors;
}

TriangleCurvature diagonalised(const Matrix3d& tensor, const Face& face) {
  const Vec3d u = (face.p[1] - face.p[0]).normalized();
  const Vec3d v = face.normal.cross(u);
  Eigen::Matrix2d plane;
  plane << u.dot(tensor * u), u.dot(tensor * v), v.dot(tensor * u), v.dot(tensor * v);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> rising(plane);
  const Eigen::Vector2d small = rising.eigenvectors().col(0);
  const Eigen::Vector2d large = rising.eigenvectors().col(1);
  return {rising.eigenvalues()[1], rising.eigenvalues()[0], large[0] * u + large[1] * v,
          small[0] * u + small[1] * v};
}

}  // namespace

std::vector<TriangleCurvature> triangle_curvature(const TriangleMesh& mesh) {
  std::vector<size_t> triangle_of_face;
  const std::vector<Face> faces = faces_of(mesh, triangle_of_face);
  const std::vector<Vec3d> normals = vertex_normals(faces, mesh.vertices.size());
  const std::vector<Matrix3d> tensors = vertex_tensors(faces, normals);

  std::vector<TriangleCurvature> curvature(mesh.triangles.size());
  for (size_t f = 0; f < faces.size(); ++f) {
    Matrix3d mean = Matrix3d::Zero();
    for (uint32_t v : faces[f].vertex) mean += carried(tensors[v], normals[v], faces[f].normal) / 3;
    curvature[triangle_of_face[f]] = diagonalised(mean, faces[f]);
  }
  return curvature;
}

}  // namespace burnish::reference
