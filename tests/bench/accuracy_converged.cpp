#include "tests/bench/accuracy_converged.h"

#include <optional>

#ifdef BURNISH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include "common/grid/morton.h"
#include "tests/reference/reference.h"

namespace burnish {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using reference::CellFields;

namespace {

constexpr int32_t kIndependentCornersMax = 600'000;  // a factor of about 3 GB
constexpr double kOwnDistance = 1e-12;
constexpr int kOwnCyclesMax = 3000;

std::vector<CellFields> fields_of(const Session& session, const reference::System& system) {
  auto fields = reference::fields(system, session.fields().transfer_curve(), 1.0);
  const auto& cells = session.prepared().cells;
  BURNISH_CHECK(cells.size() == system.cells.size(), "both find the same cells");
  for (size_t c = 0; c < cells.size(); ++c) {
    const Vec3i place = morton_point(cells[c]);
    const reference::Cell* cell = system.find_cell({place.x(), place.y(), place.z()});
    BURNISH_CHECK(cell != nullptr, "both find the same cells");
    fields[cell - system.cells.data()].beta = session.fields().view().beta[c];
  }
  return fields;
}

#ifdef BURNISH_CHOLMOD

// As in the reference's own solve: corners with almost no surface stay. Flat parts along the grid
// make the matrix singular, so its factor is shifted and refinement removes the shift.
constexpr double kPinRatio = 1e-20;
constexpr double kShiftLeast = 1e-13;
constexpr double kShiftMost = 1e-8;
constexpr int kRefinementsMax = 8;
constexpr double kKnownTo = 1e-11;  // of the diagonal: enough refinement

/// The scaled matrix of one metric and its factor.
class Factor {
 public:
  explicit Factor(const Eigen::SparseMatrix<double>& s) : scale_(s.diagonal()) {
    std::vector<double> sorted(scale_.begin(), scale_.end());
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double least = kPinRatio * sorted[sorted.size() / 2];
    for (double& d : scale_) d = d > least ? 1 / std::sqrt(d) : 0;
    matrix_ = scale_.asDiagonal() * s * scale_.asDiagonal();
    for (Eigen::Index i = 0; i < scale_.size(); ++i)
      if (scale_[i] == 0) matrix_.coeffRef(i, i) = 1;
    llt_.analyzePattern(matrix_);
    for (double shift = kShiftLeast; shift <= kShiftMost; shift *= 10) {
      llt_.setShift(shift);
      llt_.factorize(matrix_);
      if (llt_.info() == Eigen::Success) return;
    }
    BURNISH_CHECK(false, "a scaled positive matrix has its factors");
  }

  /// Returns u and the largest move of its last refinement; `move_of` measures one.
  template <typename MoveOf>
  std::pair<MatrixXd, double> solve(const MatrixXd& constraint, MoveOf&& move_of) const {
    const MatrixXd b = scale_.asDiagonal() * constraint;
    MatrixXd x = llt_.solve(b);
    double moved = INFINITY;
    for (int i = 0; i < kRefinementsMax && moved > kKnownTo; ++i) {
      const MatrixXd more = llt_.solve(b - matrix_ * x);
      x += more;
      moved = move_of(scale_.asDiagonal() * more);
    }
    return {scale_.asDiagonal() * x, moved};
  }

 private:
  VectorXd scale_;  // D^-1/2, 0 where pinned
  Eigen::SparseMatrix<double> matrix_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> llt_;
};

#endif

}  // namespace

struct Converged::Independent {
  Independent(const TriangleMesh& mesh, const PreparedMesh& prepared)
      : system(reference::build(mesh, prepared.frame.depth)),
        diagonal_in_cells(prepared.statistics.diagonal() / prepared.frame.cell_size) {}

  ConvergedSurface of(const Session& session) {
    const auto fields = fields_of(session, system);
    const MatrixXd positions = reference::corner_positions(system);
    ConvergedSurface out;
    MatrixXd displacement;
#ifdef BURNISH_CHOLMOD
    const TransferCurve& curve = session.fields().transfer_curve();
    if (!factor || factored != curve) {
      factor.reset();  // frees its memory first
      factor.emplace(reference::system_matrix(system, fields));
      factored = curve;
    }
    std::tie(displacement, out.known_to) =
        factor->solve(reference::constraint(system, fields, positions), [&](const MatrixXd& du) {
          return reference::evaluate(system, du).cwiseAbs().maxCoeff() / diagonal_in_cells;
        });
    out.method = "cholmod";
#else
    reference::Solution solution = reference::solve(system, fields, positions);
    displacement = std::move(solution.displacement);
    out.known_to = solution.last_move / diagonal_in_cells;
    out.method = "reference";
#endif
    out.vertices = reference::displaced_vertices(system, displacement);
    return out;
  }

  reference::System system;
  double diagonal_in_cells;
#ifdef BURNISH_CHOLMOD
  std::optional<Factor> factor;
  TransferCurve factored{kAlphaDefault};
#endif
};

Converged::Converged(const TriangleMesh& mesh, Multigrid on) : on_(std::move(on)) {
  if (on_.hierarchy->at(on_.hierarchy->finest).grid.corner_count() <= kIndependentCornersMax)
    independent_ = std::make_unique<Independent>(mesh, *on_.prepared);
}

Converged::~Converged() = default;

ConvergedSurface Converged::of(const Session& session) {
  return independent_ ? independent_->of(session) : own(session);
}

ConvergedSurface Converged::own(const Session& session) const {
  const auto solver = Solver::create(on_, {}).value();
  solver->set_metric(session.fields().view());
  const SolveReport report = solver->solve(kOwnDistance, kOwnCyclesMax).value();
  return {solver->evaluate_vertices(), "own", report.last.distance};
}

}  // namespace burnish
