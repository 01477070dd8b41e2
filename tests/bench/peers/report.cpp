#include "tests/bench/peers/report.h"

#include <algorithm>
#include <cstdio>

namespace burnish::bench {

using nlohmann::ordered_json;

namespace {

constexpr double kMetricEditGain = 10;  // target over CHOLMOD's re-factorisation

struct Column {
  const char* name;
  const char* unit;
  double (*value)(const Row&);
};

constexpr Column kColumns[] = {
    {"setup", "ms", [](const Row& row) { return row.setup_ms; }},
    {"factor", "ms", [](const Row& row) { return row.factor_ms; }},
    {"beta 1 to 0", "ms", [](const Row& row) { return row.edits[kSmooth].total_ms(); }},
    {"beta 0 to 0.1", "ms", [](const Row& row) { return row.edits[kSliderStep].total_ms(); }},
    {"alpha x 1.25", "ms", [](const Row& row) { return row.edits[kMetricStep].total_ms(); }},
    {"memory", "MiB", [](const Row& row) { return static_cast<double>(row.byte_count >> 20); }},
};

Distance worst_error(const Row& row) {
  Distance worst;
  for (const EditTime& edit : row.edits)
    worst = {std::max(worst.max, edit.error.max), std::max(worst.rms, edit.error.rms)};
  return worst;
}

void print_row(const Row& row) {
  std::printf("%-22s", row.name.c_str());
  if (!row.failure.empty()) {
    std::printf(" %s\n", row.failure.c_str());
    return;
  }
  std::printf("%9.0f %9.0f", row.setup_ms, row.factor_ms);
  for (const EditTime& edit : row.edits) {
    std::printf("%9.0f", edit.total_ms());
    if (edit.iterations > 0)
      std::printf(" (%4d)", edit.iterations);
    else
      std::printf("       ");
  }
  const Distance worst = worst_error(row);
  std::printf("%7lu  %.0e %.0e\n", static_cast<unsigned long>(row.byte_count >> 20), worst.max,
              worst.rms);
}

void print_winner(const Column& column, std::span<const Row> rows) {
  const Row* best = nullptr;
  for (const Row& row : rows)
    if (row.failure.empty() && (best == nullptr || column.value(row) < column.value(*best)))
      best = &row;
  const double ours = column.value(rows.front());
  if (best == &rows.front()) {
    std::printf("  %-14s burnish wins with %.0f %s\n", column.name, ours, column.unit);
    return;
  }
  std::printf("  %-14s %s wins with %.0f %s, burnish takes %.1f times as much\n", column.name,
              best->name.c_str(), column.value(*best), column.unit, ours / column.value(*best));
}

void print_target(const char* what, double ours, double wanted) {
  std::printf("    %-6s %s: %.3g, target below %.3g\n", ours < wanted ? "met" : "MISSED", what,
              ours, wanted);
}

void print_targets(const Row& ours, const Row& cholmod) {
  std::printf("  targets against %s\n", cholmod.name.c_str());
  const double back_solve = cholmod.edits[kSmooth].solve_ms;
  print_target("beta 1 to 0 settles before its back-solve, ms", ours.edits[kSmooth].total_ms(),
               back_solve);
  print_target("beta 0 to 0.1 settles before its back-solve, ms",
               ours.edits[kSliderStep].total_ms(), back_solve);
  print_target("what counts as settled is, distance", worst_error(ours).max, kSettledBar);
  const EditTime& metric = ours.edits[kMetricStep];
  const double refactor = cholmod.edits[kMetricStep].update_ms;
  print_target("metric edit settles in a tenth of its re-factorisation, ms", metric.total_ms(),
               refactor / kMetricEditGain);
  print_target("metric edit shows a first step in a tenth of its re-factorisation, ms",
               metric.update_ms + metric.solve_ms / metric.iterations, refactor / kMetricEditGain);
  print_target("preparation before its assembly and analysis, ms", ours.setup_ms, cholmod.setup_ms);
  print_target("memory below its, MiB", static_cast<double>(ours.byte_count >> 20),
               static_cast<double>(cholmod.byte_count >> 20));
}

ordered_json edit_to_json(std::string_view name, const EditTime& edit) {
  return {{"edit", name},
          {"update_ms", edit.update_ms},
          {"solve_ms", edit.solve_ms},
          {"iterations", edit.iterations},
          {"error_max", edit.error.max},
          {"error_rms", edit.error.rms}};
}

}  // namespace

void print_rows(std::span<const Row> rows) {
  std::printf("\n  alpha %g, %d threads\n%-22s%9s %9s%16s%16s%16s%7s  %s\n", rows.front().alpha,
              rows.front().threads, "solver", "setup ms", "factor ms", "beta 1 to 0",
              "beta 0 to 0.1", "alpha x 1.25", "MiB", "error: max, rms");
  for (const Row& row : rows) print_row(row);
  std::printf(
      "  (iterations of all columns; error: largest of the three edits, in parts of the box's "
      "diagonal,\n  to the first direct solver's answer to the same system)\n");
  for (const Column& column : kColumns) print_winner(column, rows);
  for (const Row& row : rows)
    if (row.name.starts_with("CHOLMOD") && row.failure.empty()) print_targets(rows.front(), row);
  for (const Row& row : rows)
    if (!row.note.empty()) std::printf("  %s: %s\n", row.name.c_str(), row.note.c_str());
}

ordered_json rows_to_json(std::span<const Row> rows) {
  ordered_json out = ordered_json::array();
  for (const Row& row : rows) {
    ordered_json one = {{"solver", row.name}, {"threads", row.threads}, {"alpha", row.alpha}};
    if (!row.failure.empty()) {
      one["failure"] = row.failure;
    } else {
      one["setup_ms"] = row.setup_ms;
      one["factor_ms"] = row.factor_ms;
      for (int kind = 0; kind < kEdits; ++kind)
        one["edits"].push_back(edit_to_json(kEditNames[kind], row.edits[kind]));
      one["bytes"] = row.byte_count;
      one["note"] = row.note;
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace burnish::bench
