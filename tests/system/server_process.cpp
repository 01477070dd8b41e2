#include "tests/system/server_process.h"

#include <csignal>

#include "common/base/check.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"

namespace burnish {

std::vector<std::string> ServerProcess::command_line() const {
  std::vector<std::string> words = {BURNISH_SERVER_BINARY, "--listen", listen, "--data",
                                    (folder / "data").string()};
  words.insert(words.end(), flags.begin(), flags.end());
  return words;
}

void ServerProcess::start(const Process::Limits& limits) {
  process = std::make_unique<Process>(command_line(), folder / "server.log", limits);
  const std::string announcement = "listening on ";
  BURNISH_CHECK(process->wait_for_output(announcement, kPatience), process->output());
  address = announced(announcement);
}

std::string ServerProcess::announced(const std::string& announcement) const {
  const std::string output = process->output();
  const size_t begin = output.find(announcement) + announcement.size();
  return output.substr(begin, output.find('\n', begin) - begin);
}

void ServerProcess::kill() {
  process->signal(SIGKILL);
  process->wait(kPatience);
}

void ServerProcess::arm_fault() {
  process->signal(SIGUSR1);
  const bool is_heard = process->wait_for_output("armed\n", kPatience);
  BURNISH_CHECK(is_heard || process->wait({}), process->output());
}

std::unique_ptr<Process> ServerProcess::start_burnish(std::vector<std::string> words) {
  words.insert(words.begin(), BURNISH_BINARY);
  words.insert(words.end(), {"--server", address});
  words.insert(words.end(), client_flags.begin(), client_flags.end());
  return std::make_unique<Process>(words, folder / ("out" + std::to_string(outputs_++)));
}

CommandOutcome ServerProcess::burnish(std::vector<std::string> words) {
  const auto command = start_burnish(std::move(words));
  const int exit_code = command->wait(kPatience).value_or(-1);
  return {exit_code, command->output()};
}

size_t ServerProcess::entries(const std::string& name) const {
  const std::filesystem::directory_iterator found(folder / "data" / name);
  return static_cast<size_t>(std::distance(begin(found), end(found)));
}

std::string write_sphere(const TemporaryFolder& folder, int level) {
  const auto path = folder / ("sphere" + std::to_string(level) + ".ply");
  const Status status = write_mesh(make_icosphere(level, 1), path);
  BURNISH_CHECK(status.is_ok(), status.message());
  return path.string();
}

}  // namespace burnish
