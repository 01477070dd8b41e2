// Smooths a mesh by filters of CGAL, with each of some settings. tests/bench/denoise/cgal.py
// compiles it. cgal_filters IN.ply FOLDER writes FOLDER/SETTING.ply for each.

#define CGAL_EIGEN3_ENABLED

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/boost/graph/helpers.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

std::string in_words(const char* format, double a, double b) {
  char text[60];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

void write(const Mesh& mesh, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
}

double mean_squared_edge(const Mesh& mesh) {
  double sum = 0;
  for (const auto edge : mesh.edges()) {
    const auto side = mesh.halfedge(edge);
    sum += CGAL::squared_distance(mesh.point(mesh.source(side)), mesh.point(mesh.target(side)));
  }
  return sum / mesh.number_of_edges();
}

/// Mean curvature flow. Borders stay.
void smooth_shapes(const Mesh& noisy, const std::string& folder) {
  for (const double steps : {1., 5.})
    for (const double time : {0.003, 0.01, 0.03, 0.1, 0.3, 1.0}) {
      Mesh mesh = noisy;
      auto stays = mesh.add_property_map<Mesh::Vertex_index, bool>("v:stays", false).first;
      for (const auto vertex : mesh.vertices()) stays[vertex] = mesh.is_border(vertex);
      pmp::smooth_shape(faces(mesh), mesh, time * mean_squared_edge(noisy),
                        CGAL::parameters::number_of_iterations(static_cast<unsigned>(steps))
                            .vertex_is_constrained_map(stays));
      mesh.remove_property_map(stays);
      write(mesh, folder + in_words("/flow %g, %g.ply", time, steps));
    }
}

/// The bilateral filter of point sets, on the mesh's vertices with their normals.
void smooth_points(const Mesh& noisy, const std::string& folder) {
  Mesh mesh = noisy;
  auto normals =
      mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
          .first;
  pmp::compute_vertex_normals(mesh, normals);
  std::vector<PointWithNormal> first;
  for (const auto vertex : mesh.vertices()) first.emplace_back(mesh.point(vertex), normals[vertex]);
  mesh.remove_property_map(normals);
  for (const double angle : {15., 25., 45.}) {
    std::vector<PointWithNormal> points = first;
    for (int done = 1; done <= 16; ++done) {
      CGAL::bilateral_smooth_point_set<CGAL::Sequential_tag>(
          points, 18,
          CGAL::parameters::point_map(CGAL::First_of_pair_property_map<PointWithNormal>())
              .normal_map(CGAL::Second_of_pair_property_map<PointWithNormal>())
              .sharpness_angle(angle));
      if (done != 1 && done != 3 && done != 8 && done != 16) continue;
      for (const auto vertex : mesh.vertices()) mesh.point(vertex) = points[vertex].first;
      write(mesh, folder + in_words("/points %g°, %g.ply", angle, done));
    }
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  Mesh noisy;
  std::ifstream in(words[1], std::ios::binary);
  if (!CGAL::IO::read_PLY(in, noisy)) return 1;
  smooth_shapes(noisy, words[2]);
  smooth_points(noisy, words[2]);
}
