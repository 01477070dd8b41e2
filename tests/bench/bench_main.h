#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "tests/bench/input.h"
#include "tests/bench/report.h"

namespace burnish {

/// What the programs of tests/bench take: [--out FOLDER] [--threads N] [--corners-max N] SCAN...
struct BenchArguments {
  std::vector<ScanArgument> scans;
  std::filesystem::path out;  ///< empty: print only
  int threads = 0;            ///< the most to use; all cores by default
  double corners_max = 1.5e7;
};

/// One program of tests/bench.
struct Bench {
  const char* name;                        ///< of the program, and of its JSON
  std::vector<const char*> default_scans;  ///< when the command line names none
  Status (*run)(const BenchArguments& arguments, BenchReport& report);
};

/// Measures the memory bandwidth with all threads and with one, runs the bench, writes its files.
/// The exit status of main(): 2 for wrong arguments, 1 for a failure.
int bench_main(const Bench& bench, int argc, char** argv);

/// Bandwidth measured at the start by bench_main(), GB/s. Needs: threads is 1 or what
/// `arguments.threads` says.
double triad_of(const BenchReport& report, int threads);

/// 1 and all, or just 1.
std::vector<int> thread_counts(const BenchArguments& arguments);

/// The system of one scan at `depth`, or nothing and a remark that says why it is left out: too
/// large for this machine or for --corners-max. Fails: what the scan itself is wrong about.
Result<std::optional<BenchSystem>> system_or_remark(const ScanArgument& scan,
                                                    const TriangleMesh& mesh, int depth,
                                                    const BenchArguments& arguments,
                                                    BenchReport& report);

}  // namespace burnish
