#include "tests/bench/peers/measure_peer.h"

#include <cmath>

#include "tests/bench/peers/stopwatch.h"

namespace burnish::bench {

static constexpr double kToleranceMin = 1e-10;

Distance distance_between(const MatrixXd& a, const MatrixXd& b, double diagonal) {
  const Eigen::VectorXd squares = (a - b).rowwise().squaredNorm();
  return {std::sqrt(squares.maxCoeff()) / diagonal, std::sqrt(squares.mean()) / diagonal};
}

namespace {

class Measurement {
 public:
  Measurement(const PeerKind& kind, const PeerTask& task, Answers& answers)
      : kind_(kind), task_(task), answers_(answers), peer_(kind.make()) {}

  Status analyse(double alpha) {
    matrix_ = task_.system->matrix(alpha);
    Status status;
    analysis_ms_ = milliseconds([&] { status = peer_->analyse(matrix_, task_.bytes_max); });
    return status;
  }

  Result<Row> measure(double alpha) {
    Row row;
    row.alpha = alpha;
    row.setup_ms = task_.assembly_ms + analysis_ms_;
    matrix_ = task_.system->matrix(alpha);
    ASSIGN_OR_RETURN(row.factor_ms, factor());
    MatrixXd x = MatrixXd::Zero(matrix_.rows(), 3);
    ASSIGN_OR_RETURN(row.edits[kSmooth], solve(alpha, 0, x));
    const MatrixXd smoothed = x;
    ASSIGN_OR_RETURN(row.edits[kSliderStep], solve(alpha, kSliderStepBeta, x));

    x = smoothed;
    const double assembly_ms =
        milliseconds([&] { matrix_ = task_.system->matrix(kMetricStepFactor * alpha); });
    ASSIGN_OR_RETURN(const double factor_ms, factor());
    ASSIGN_OR_RETURN(row.edits[kMetricStep], solve(kMetricStepFactor * alpha, 0, x));
    row.edits[kMetricStep].update_ms += assembly_ms + factor_ms;
    row.byte_count = task_.system->byte_count() + peer_->byte_count();
    row.note = peer_->note();
    return row;
  }

 private:
  Result<double> factor() {
    Status status;
    const double ms = milliseconds([&] { status = peer_->factor(matrix_); });
    RETURN_IF_ERROR(status);
    return ms;
  }

  Result<EditTime> solve(double alpha, double beta, MatrixXd& x) {
    EditTime time;
    MatrixXd b;
    time.update_ms = milliseconds([&] { b = task_.system->right_side(beta); });
    const MatrixXd start = x;
    double tolerance = kind_.is_iterative ? 0.1 : 0;
    do {
      Result<int> iterations = 0;
      time.solve_ms = median_milliseconds([&] {
        x = start;
        iterations = peer_->solve(b, tolerance, x);
      });
      ASSIGN_OR_RETURN(time.iterations, std::move(iterations));
      const MatrixXd moves = task_.system->vertex_moves(x);
      if (!kind_.is_iterative && beta == 0) answers_.try_emplace(alpha, moves);
      if (!answers_.contains(alpha))
        return failed_precondition("no direct solver answered this system");
      time.error = distance_between(moves, (1 - beta) * answers_.at(alpha), task_.diagonal);
      if (time.error.max <= kSettledBar || !kind_.is_iterative) return time;
      tolerance /= 10;
    } while (tolerance >= kToleranceMin);
    return internal_error("does not settle at a relative residual of 1e-10");
  }

  const PeerKind& kind_;
  const PeerTask& task_;
  Answers& answers_;
  std::unique_ptr<Peer> peer_;
  SparseMatrix matrix_;
  double analysis_ms_ = 0;
};

Row failed_row(const Status& status) {
  Row row;
  row.failure = status.message();
  return row;
}

}  // namespace

std::vector<Row> measure_peer(const PeerKind& kind, const PeerTask& task,
                              std::span<const double> alphas, Answers& answers) {
  if (kind.make == nullptr) return {failed_row(not_found("not in this build"))};
  Measurement measurement(kind, task, answers);
  const Status analysed = measurement.analyse(alphas.front());
  if (!analysed.is_ok()) return {failed_row(analysed)};
  std::vector<Row> rows;
  for (const double alpha : alphas) {
    const Result<Row> row = measurement.measure(alpha);
    rows.push_back(row.is_ok() ? *row : failed_row(row.status()));
  }
  return rows;
}

}  // namespace burnish::bench
