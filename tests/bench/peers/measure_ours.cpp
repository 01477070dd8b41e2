#include "tests/bench/peers/measure_ours.h"

#include <algorithm>
#include <sstream>

#include "server/fields/fields.h"
#include "server/prepare/prepare.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/peers/stopwatch.h"

namespace burnish::bench {
namespace {

constexpr int kStepsMax = 500;
constexpr double kConvergedDistance = 1e-8;
constexpr double kStartDistance = 1e-6;  // of the state before an edit
constexpr int kRepeats = 3;              // runs; the median's figures count

struct State {
  double alpha, beta;
};

class OurMeasurement {
 public:
  OurMeasurement(const PreparedScan& scan, std::unique_ptr<Solver> solver, const Answers& answers)
      : scan_(scan), solver_(std::move(solver)), fields_(*scan.prepared), answers_(answers) {}

  Result<Row> measure(double alpha) {
    Row row;
    row.name = "burnish";
    row.alpha = alpha;
    row.setup_ms = scan_.setup_ms;
    const State input{alpha, 1}, smoothed{alpha, 0}, slid{alpha, kSliderStepBeta};
    const State stepped{kMetricStepFactor * alpha, 0};
    RETURN_IF_ERROR(converge(stepped));
    RETURN_IF_ERROR(converge(smoothed));
    row.factor_ms = set_metric(input);
    ASSIGN_OR_RETURN(row.edits[kSmooth], time_edit(input, smoothed));
    ASSIGN_OR_RETURN(row.edits[kSliderStep], time_edit(smoothed, slid));
    ASSIGN_OR_RETURN(row.edits[kMetricStep], time_edit(smoothed, stepped));
    row.byte_count =
        scan_.prepared->byte_count() + scan_.hierarchy->byte_count() + solver_->byte_count();
    row.note = note(alpha);
    return row;
  }

 private:
  std::string note(double alpha) const {
    const Distance converged = error(converged_.at(alpha), answer(alpha));
    std::ostringstream text;
    text << (scan_.prepared->byte_count() >> 20) << " MiB of prepared mesh and "
         << (scan_.hierarchy->byte_count() >> 20) << " MiB of hierarchy, shared by all sessions, "
         << (solver_->byte_count() >> 20) << " MiB of the session";
    if (answers_.contains(alpha))
      text << "; converged " << converged.max << " (max), " << converged.rms
           << " (rms) from the direct solution of its own matrix";
    return text.str();
  }

  Result<EditTime> time_edit(const State& from, const State& to) {
    std::vector<EditTime> times;
    do {
      set_metric(from);
      RETURN_IF_ERROR(solver_->solve(kStartDistance, kStepsMax).status());
      EditTime time;
      time.update_ms = from.alpha == to.alpha ? set_gradient_scale(to.beta) : set_metric(to);
      Result<SolveReport> report = SolveReport();
      time.solve_ms = milliseconds([&] { report = solver_->solve(kSettledBar, kStepsMax); });
      RETURN_IF_ERROR(report.status());
      time.iterations = report->cycles;
      time.error = error(vertex_moves(), (1 - to.beta) * answer(to.alpha));
      times.push_back(time);
    } while (wants_another(times.size(), times.back().total_ms()));
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end(),
                     [](const auto& a, const auto& b) { return a.total_ms() < b.total_ms(); });
    return *middle;
  }

  double set_metric(const State& state) {
    return milliseconds([&] {
      fields_.set_transfer_curve(TransferCurve(state.alpha));
      fields_.set_gradient_scale(state.beta);
      solver_->set_metric(fields_.view());
    });
  }

  double set_gradient_scale(double beta) {
    return milliseconds([&] {
      fields_.set_gradient_scale(beta);
      solver_->set_gradient_scale(fields_.view());
    });
  }

  Status converge(const State& state) {
    set_metric(state);
    RETURN_IF_ERROR(solver_->solve(kConvergedDistance, kStepsMax).status());
    converged_[state.alpha] = vertex_moves();
    return Status::ok();
  }

  const MatrixXd& answer(double alpha) const {
    return answers_.contains(alpha) ? answers_.at(alpha) : converged_.at(alpha);
  }

  Distance error(const MatrixXd& moves, const MatrixXd& wanted) const {
    return distance_between(moves, wanted, scan_.prepared->statistics.diagonal());
  }

  MatrixXd vertex_moves() const {
    const std::vector<Vec3d> moved = solver_->evaluate_vertices();
    MatrixXd moves(moved.size(), 3);
    for (size_t v = 0; v < moved.size(); ++v)
      moves.row(static_cast<Eigen::Index>(v)) = moved[v] - scan_.prepared->vertices[v];
    return moves;
  }

  const PreparedScan& scan_;
  std::unique_ptr<Solver> solver_;
  Fields fields_;
  const Answers& answers_;
  Answers converged_;
};

}  // namespace

Result<PreparedScan> prepare_scan(const TriangleMesh& mesh, int depth) {
  PreparedScan scan;
  Result<std::shared_ptr<const PreparedMesh>> prepared = internal_error("not prepared");
  scan.setup_ms =
      milliseconds([&] { prepared = prepare(mesh, {.depth = depth}, {}, &scan.report); });
  ASSIGN_OR_RETURN(scan.prepared, std::move(prepared));
  const double ms =
      milliseconds([&] { static_cast<Multigrid&>(scan) = make_multigrid(scan.prepared).value(); });
  scan.report.phases.push_back({"hierarchy", ms * 1e-3});
  scan.setup_ms += ms;
  return scan;
}

Result<std::vector<Row>> measure_ours(const PreparedScan& scan, BackendKind backend,
                                      std::span<const double> alphas, const Answers& answers) {
  ASSIGN_OR_RETURN(auto solver, Solver::create(scan, {.backend = backend}));
  OurMeasurement measurement(scan, std::move(solver), answers);
  std::vector<Row> rows;
  for (const double alpha : alphas) {
    ASSIGN_OR_RETURN(Row row, measurement.measure(alpha));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace burnish::bench
