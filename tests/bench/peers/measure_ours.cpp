#include "tests/bench/peers/measure_ours.h"

#include <algorithm>
#include <sstream>

#include "server/prepare/prepare.h"
#include "server/solver/fields.h"
#include "server/solver/solver.h"
#include "tests/bench/peers/stopwatch.h"

namespace burnish::bench {
namespace {

constexpr int kStepsMax = 500;
constexpr double kConvergedDistance = 1e-8;
constexpr double kStartDistance = 1e-6;  // of the state before an edit
constexpr int kRepeats = 3;              // the figures of the median

class OurMeasurement {
 public:
  OurMeasurement(const PreparedScan& scan, std::unique_ptr<Solver> solver, const Answers& answers)
      : scan_(scan), solver_(std::move(solver)), fields_(*scan.prepared), answers_(answers) {}

  Result<Row> measure(double alpha) {
    Row row;
    row.name = "burnish";
    row.alpha = alpha;
    row.setup_ms = scan_.setup_ms;
    const double stepped = kMetricStepFactor * alpha;
    RETURN_IF_ERROR(converge(stepped));
    RETURN_IF_ERROR(converge(alpha));
    row.factor_ms = set_metric(alpha, 1);
    using Update = double (OurMeasurement::*)(double, double);
    const auto edit = [&](EditKind kind, double from_beta, double to_alpha, double to_beta,
                          Update update) -> Status {
      std::array<EditTime, kRepeats> times;
      for (EditTime& time : times) {
        set_metric(alpha, from_beta);
        RETURN_IF_ERROR(solver_->solve(kStartDistance, kStepsMax).status());
        time.update_ms = (this->*update)(to_alpha, to_beta);
        ASSIGN_OR_RETURN(time, settle(time, to_alpha, to_beta));
      }
      const auto middle = times.begin() + kRepeats / 2;
      std::nth_element(times.begin(), middle, times.end(),
                       [](const auto& a, const auto& b) { return a.total_ms() < b.total_ms(); });
      row.edits[kind] = *middle;
      return Status::ok();
    };
    RETURN_IF_ERROR(edit(kSmooth, 1, alpha, 0, &OurMeasurement::set_gradient_scale));
    RETURN_IF_ERROR(
        edit(kSliderStep, 0, alpha, kSliderStepBeta, &OurMeasurement::set_gradient_scale));
    RETURN_IF_ERROR(edit(kMetricStep, 0, stepped, 0, &OurMeasurement::set_metric));
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

  double set_metric(double alpha, double beta) {
    return milliseconds([&] {
      fields_.set_transfer_curve(TransferCurve(alpha));
      fields_.set_gradient_scale(beta);
      solver_->set_metric(fields_.view());
    });
  }

  double set_gradient_scale(double /*alpha*/, double beta) {
    return milliseconds([&] {
      fields_.set_gradient_scale(beta);
      solver_->set_gradient_scale(fields_.view());
    });
  }

  Result<EditTime> settle(EditTime time, double alpha, double beta) {
    Result<SolveReport> report = SolveReport();
    time.solve_ms = milliseconds([&] { report = solver_->solve(kSettledDistance, kStepsMax); });
    RETURN_IF_ERROR(report.status());
    time.iterations = report->cycles;
    time.error = error(vertex_moves(), (1 - beta) * answer(alpha));
    return time;
  }

  Status converge(double alpha) {
    set_metric(alpha, 0);
    RETURN_IF_ERROR(solver_->solve(kConvergedDistance, kStepsMax).status());
    converged_[alpha] = vertex_moves();
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
  const double ms = milliseconds([&] { scan.hierarchy = make_hierarchy(*scan.prepared); });
  scan.report.phases.push_back({"hierarchy", ms * 1e-3});
  scan.setup_ms += ms;
  return scan;
}

Result<std::vector<Row>> measure_ours(const PreparedScan& scan, std::span<const double> alphas,
                                      const Answers& answers) {
  ASSIGN_OR_RETURN(auto solver,
                   Solver::create(scan.prepared, scan.hierarchy, {.backend = BackendKind::kCpu}));
  OurMeasurement measurement(scan, std::move(solver), answers);
  std::vector<Row> rows;
  for (const double alpha : alphas) {
    ASSIGN_OR_RETURN(Row row, measurement.measure(alpha));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace burnish::bench
