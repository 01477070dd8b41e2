#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "tests/bench/input.h"
#include "tests/bench/report.h"

namespace burnish {

/// Arguments of the programs of tests/bench: [--out FOLDER] [--threads N] [--corners-max N] SCAN...
struct BenchArguments {
  std::vector<ScanArgument> scans;
  std::filesystem::path out;  ///< empty: only print
  int threads = 0;            ///< largest number; all cores by default
  double corners_max = 1.5e7;
};

/// One program of tests/bench.
struct Bench {
  const char* name;                        ///< of the program, and of its JSON
  std::vector<const char*> default_scans;  ///< for a command line without scans
  Status (*run)(const BenchArguments& arguments, BenchReport& report);
};

/// Measures the memory bandwidth with all threads and with one, runs the bench, writes its files.
/// Returns the exit status of main(): 2 for wrong arguments, 1 for a failure.
int bench_main(const Bench& bench, int argc, char** argv);

/// Returns the bandwidth that bench_main() measured at the start, GB/s. Needs: threads is 1 or
/// `arguments.threads`.
double triad_of(const BenchReport& report, int threads);

/// Returns 1 and all, or just 1.
std::vector<int> thread_counts(const BenchArguments& arguments);

/// Returns the system of one scan at `depth`, or nothing and a remark: the scan is too large for
/// this machine or for --corners-max. Fails: if the scan itself is wrong.
Result<std::optional<BenchSystem>> system_or_remark(const ScanArgument& scan,
                                                    const TriangleMesh& mesh, int depth,
                                                    const BenchArguments& arguments,
                                                    BenchReport& report);

}  // namespace burnish
