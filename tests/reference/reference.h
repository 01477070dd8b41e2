#pragma once

#include <functional>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "common/edit/transfer_curve.h"
#include "common/mesh/triangle_mesh.h"
#include "tests/reference/pieces.h"

/// The whole filter in double precision, slow and plain: every backend is compared with it. It
/// shares no numerical code with the product, so a test passes only if both agree.
namespace burnish::reference {

using Matrix8d = Eigen::Matrix<double, 8, 8>;

/// The surface's part of the system in one cell, before any metric (section 4.3). Units: grid.
/// Local corner a has offset (a & 1, (a >> 1) & 1, a >> 2).
struct Cell {
  Lattice key{};
  std::array<int, 8> corners{};      ///< indices into System::corners
  Matrix8d rho = Matrix8d::Zero();   ///< int B_a B_b
  Matrix8d ell1 = Matrix8d::Zero();  ///< int <v1, grad B_a> <v1, grad B_b>
  Matrix8d ell2 = Matrix8d::Zero();
  double area = 0;    ///< grid units squared
  double kappa1 = 0;  ///< area-weighted means, user units (times L)
  double kappa2 = 0;
};

/// One row of E: eight corners and trilinear weights. `cell` is -1 if no active cell contains or
/// touches the vertex, which then does not move.
struct EvaluationRow {
  int cell = -1;
  std::array<double, 8> weights{};
};

/// The data that no edit changes.
struct System {
  int depth = 0;
  Vec3d origin = Vec3d::Zero();           ///< the cube's least corner, file units
  double cell_size = 1;                   ///< file units
  double length_unit = 1;                 ///< L = sqrt(total area), file units
  std::vector<Cell> cells;                ///< sorted by key
  std::vector<Lattice> corners;           ///< sorted; one unknown each
  std::vector<EvaluationRow> evaluation;  ///< one per vertex
  std::vector<Vec3d> vertices;            ///< as given, file units

  Vec3d cell_centre(const Cell& cell) const;        ///< file units
  const Cell* find_cell(const Lattice& key) const;  ///< null if the surface does not pass
};

/// Needs: a valid mesh; depth >= 1.
System build(const TriangleMesh& mesh, int depth);

/// The three numbers per cell that edits choose. Units: user (alpha times L).
struct CellFields {
  double alpha1, alpha2, beta;
};
using GradientScale = std::function<double(const Vec3d& cell_centre_in_file_units)>;

/// Returns alpha_i = curve(kappa_i) with the cell's mean curvatures. Shapes: one per cell.
std::vector<CellFields> fields(const System& system, const TransferCurve& curve,
                               const GradientScale& beta);
std::vector<CellFields> fields(const System& system, const TransferCurve& curve, double beta);

/// Returns S of Eq. 4, one row and column per corner.
Eigen::SparseMatrix<double> system_matrix(const System& system,
                                          const std::vector<CellFields>& fields);

/// Returns b = sum over cells of (beta - 1) [(a2/a1) ell1 + (a1/a2) ell2] signal. Shapes: `signal`
/// has one row of coefficients per corner and a column per function.
Eigen::MatrixXd constraint(const System& system, const std::vector<CellFields>& fields,
                           const Eigen::MatrixXd& signal);

/// Returns the coefficients of the position itself: c° = (i, j, k) of each corner. Shapes: corners
/// x 3.
Eigen::MatrixXd corner_positions(const System& system);

/// Returns E times coefficients; zero rows for vertices without a cell. Shapes: vertices x columns.
Eigen::MatrixXd evaluate(const System& system, const Eigen::MatrixXd& coefficients);

struct Solution {
  Eigen::MatrixXd displacement;  ///< u = c - signal; corners x columns
  double residual = 0;           ///< |b - S u| / |b|, both scaled by 1 / sqrt(diagonal); 0 if b = 0
  /// Largest |E du| of the last refinement, in the signal's units: about how well the surface is
  /// determined. It is rounding for most meshes. It is 1e-3 cells if a flat part parallel to an
  /// axis is curved by less than 1e-6 cells: S is then singular except for rounding.
  double last_move = 0;
  int pinned = 0;  ///< corners with almost no surface, held at u = 0
};

/// Solves S u = b for any signal, by a sparse factorisation and refinement. Cost: seconds up to
/// some 1e5 corners, half a minute and 2 GB at 5e5.
Solution solve(const System& system, const std::vector<CellFields>& fields,
               const Eigen::MatrixXd& signal);

/// Returns the edited surface: every vertex moved by E u, in file units. Shapes: one per vertex.
std::vector<Vec3d> edited_vertices(const System& system, const std::vector<CellFields>& fields);

/// Does the same with known coefficients: vertices + cell size times E u.
std::vector<Vec3d> displaced_vertices(const System& system, const Eigen::MatrixXd& displacement);

}  // namespace burnish::reference
