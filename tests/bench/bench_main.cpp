#include "tests/bench/bench_main.h"

#include <charconv>
#include <cstdio>
#include <iostream>
#include <string_view>

#include "common/base/parallel.h"
#include "tests/bench/triad.h"

namespace burnish {

namespace {

template <typename Number>
Status parse_value(std::string_view option, std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number > 0) return Status::ok();
  return invalid_argument(std::string(option) + " '" + std::string(text) +
                          "' is not a positive number");
}

Result<BenchArguments> parse(const Bench& bench, int argc, char** argv) {
  BenchArguments arguments;
  std::vector<const char*> words(argv + 1, argv + argc), scans;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (!word.starts_with("--")) {
      scans.push_back(words[i]);
      continue;
    }
    if (word != "--out" && word != "--threads" && word != "--corners-max")
      return invalid_argument("unknown option '" + std::string(word) + "'");
    if (++i == words.size()) return invalid_argument(std::string(word) + " needs a value");
    if (word == "--out") arguments.out = words[i];
    if (word == "--threads") RETURN_IF_ERROR(parse_value(word, words[i], arguments.threads));
    if (word == "--corners-max")
      RETURN_IF_ERROR(parse_value(word, words[i], arguments.corners_max));
  }
  for (const char* scan : scans.empty() ? bench.default_scans : scans) {
    ASSIGN_OR_RETURN(arguments.scans.emplace_back(), parse_scan(scan));
  }
  return arguments;
}

Status measure(const Bench& bench, BenchArguments& arguments) {
  if (!arguments.out.empty()) {
    std::error_code error;
    std::filesystem::create_directories(arguments.out, error);
    if (error) return errno_status("folder " + arguments.out.string(), error.value());
  }
  use_threads(arguments.threads);
  arguments.threads = thread_count();
  BenchReport report(bench.name);
  for (int threads : thread_counts(arguments)) {
    use_threads(threads);
    const double triad = triad_gigabytes_per_second();
    report.facts()["triad_gb_per_s"][std::to_string(threads)] = triad;
    std::printf("%s: triad with %d threads: %.1f GB/s\n", bench.name, threads, triad);
  }
  use_threads(arguments.threads);
  RETURN_IF_ERROR(bench.run(arguments, report));
  return arguments.out.empty() ? Status::ok() : report.write(arguments.out);
}

}  // namespace

int bench_main(const Bench& bench, int argc, char** argv) {
  auto arguments = parse(bench, argc, argv);
  if (!arguments.is_ok()) {
    std::cerr << bench.name << ": " << arguments.status().message() << "\nusage: " << bench.name
              << " [--out FOLDER] [--threads N] [--corners-max N] [SCAN[@DEPTH]]...\n"
                 "SCAN is a mesh file, or KIND:VERTICES of a generated scan\n";
    return 2;
  }
  const Status status = measure(bench, *arguments);
  if (status.is_ok()) return 0;
  std::cerr << bench.name << ": " << status.message() << "\n";
  return 1;
}

double triad_of(const BenchReport& report, int threads) {
  return report.facts().at("triad_gb_per_s").at(std::to_string(threads)).get<double>();
}

std::vector<int> thread_counts(const BenchArguments& arguments) {
  if (arguments.threads == 1) return {1};
  return {1, arguments.threads};
}

Result<std::optional<BenchSystem>> system_or_remark(const ScanArgument& scan,
                                                    const TriangleMesh& mesh, int depth,
                                                    const BenchArguments& arguments,
                                                    BenchReport& report) {
  auto system = make_system(scan, mesh, depth, arguments.corners_max);
  if (system.is_ok()) return std::optional(std::move(system).value());
  if (system.status().code() != StatusCode::kResourceExhausted) return system.status();
  report.remark("left out: " + system.status().message());
  return std::optional<BenchSystem>();
}

}  // namespace burnish
