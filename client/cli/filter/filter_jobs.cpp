#include "client/cli/filter/filter_jobs.h"

#include <cerrno>
#include <cstdlib>
#include <map>
#include <unistd.h>

#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"
#include "common/base/scratch_file.h"

namespace burnish {

namespace fs = std::filesystem;

std::string name_in_folder(const std::string& in, const FilterOptions& options) {
  fs::path name = fs::path(in).filename();
  if (!options.to.empty()) name.replace_extension(options.to);
  return (fs::path(options.out_dir) / name).string();
}

namespace {

constexpr size_t kPieceBytes = 1 << 20;

Result<std::vector<FilterJob>> plan_folder(const FilterOptions& options) {
  std::vector<FilterJob> jobs;
  std::map<std::string, std::string> writers;  // IN by OUT
  for (const std::string& in : options.files) {
    if (in == kStandardStream)
      return invalid_argument("'-' is standard input: it goes with one OUT, not with --out-dir");
    jobs.push_back({in, name_in_folder(in, options)});
    const auto [writer, is_new] = writers.emplace(jobs.back().out, in);
    if (!is_new)
      return invalid_argument(writer->second + " and " + in + " would both be written as " +
                              jobs.back().out + "; rename one, or filter them apart");
  }
  return jobs;
}

Result<fs::path> make_folder() {
  ASSIGN_OR_RETURN(const fs::path folder, temporary_folder());
  std::string name = (folder / "burnish-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return errno_status("cannot make " + name, errno);
  return fs::path(name);
}

Status take_standard_input(const fs::path& path) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  std::vector<uint8_t> piece(kPieceBytes);
  while (true) {
    const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno_status("cannot read standard input", errno);
    if (count == 0) return file.commit();
    RETURN_IF_ERROR(file.write(std::span(piece.data(), static_cast<size_t>(count))));
  }
}

Status write_standard_output(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno_status("cannot write to standard output", errno);
    bytes = bytes.subspan(static_cast<size_t>(count));
  }
  return Status::ok();
}

}  // namespace

Result<std::vector<FilterJob>> plan_jobs(const FilterOptions& options) {
  if (!options.out_dir.empty()) return plan_folder(options);
  if (options.files.size() != 2)
    return invalid_argument("named " + std::to_string(options.files.size()) +
                            " files: name 2, IN and OUT, or give --out-dir");
  return std::vector<FilterJob>{{options.files[0], options.files[1]}};
}

Result<JobFiles> JobFiles::open(const FilterJob& job, const FilterOptions& options) {
  JobFiles files;
  files.in_ = job.in;
  files.out_ = job.out;
  if (job.in != kStandardStream && job.out != kStandardStream) return files;
  ASSIGN_OR_RETURN(files.folder_, make_folder());
  if (job.in == kStandardStream) {
    files.in_ = files.folder_ / ("in." + options.from);
    RETURN_IF_ERROR(take_standard_input(files.in_));
  }
  if (job.out == kStandardStream) {
    const std::string format =
        options.to.empty() ? files.in_.extension().string() : "." + options.to;
    files.out_ = files.folder_ / ("out" + format);
  }
  return files;
}

JobFiles::~JobFiles() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

Status JobFiles::named(const FilterJob& job, const Status& status) const {
  Status named = status;
  if (job.in == kStandardStream) named = named.renamed(in_.string(), "standard input");
  if (job.out == kStandardStream) named = named.renamed(out_.string(), "standard output");
  return named;
}

Status JobFiles::finish(const FilterJob& job) const {
  if (job.out != kStandardStream) return Status::ok();
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(out_));
  return write_standard_output(file.bytes());
}

}  // namespace burnish
