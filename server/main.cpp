#include <csignal>
#include <iostream>
#include <pthread.h>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "common/base/atomic_file.h"
#include "server/config/command_line.h"
#include "server/rpc/server.h"
#include "server/session/data_folder.h"
#include "server/session/executor.h"
#include "server/session/journal.h"
#include "server/session/mesh_store.h"
#include "server/session/session_manager.h"

namespace burnish {
namespace {

constexpr auto kDrainTime = std::chrono::seconds(5);

/// SIGTERM and SIGINT, blocked for all threads so that main() can wait for them.
sigset_t block_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // A full disk or quota is an error of the write, not the end of the server.
  std::signal(SIGXFSZ, SIG_IGN);
  return signals;
}

Status write_port_file(const std::filesystem::path& path, int port) {
  if (path.empty()) return Status::ok();
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  RETURN_IF_ERROR(file.write(std::to_string(port) + "\n"));
  return file.commit();
}

/// Serves until a signal ends it.
Status serve(const CommandLine& line, const sigset_t& signals) {
  const ServerConfig& config = line.config;
  ASSIGN_OR_RETURN(const auto folder, DataFolder::open(config.data));
  MeshStore store(*folder, {static_cast<uint64_t>(config.upload_bytes_max),
                            resolved_mesh_bytes_max(config), config.threads});
  ASSIGN_OR_RETURN(const auto journal, Journal::open(folder->journal()));
  SessionManagerOptions options;
  options.sessions_max = static_cast<size_t>(config.sessions_max);
  options.solver.backend = config.backend;
  options.solver.threads = config.threads;
  ASSIGN_OR_RETURN(const auto sessions, SessionManager::create(*folder, store, *journal, options));
  Executor executor(config.workers);
  ASSIGN_OR_RETURN(const auto server, Server::start(config.listen, store, *sessions, executor));

  RETURN_IF_ERROR(write_port_file(line.port_file, server->port()));
  std::cout << "listening on " << server->address() << std::endl;
  spdlog::info("data in {}: {} scans, {} sessions", config.data.string(), store.list().size(),
               sessions->list().size());
  int signal = 0;
  sigwait(&signals, &signal);
  spdlog::info("{}: draining", signal == SIGINT ? "SIGINT" : "SIGTERM");
  server->drain(kDrainTime);
  spdlog::info("stopped");
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  int exit_code = 0;
  const auto line = burnish::parse_command_line(argc, argv, exit_code);
  if (!line) return exit_code;
  spdlog::set_default_logger(spdlog::stderr_color_mt("burnish-server"));
  spdlog::set_level(spdlog::level::from_str(line->config.log_level));
  const sigset_t signals = burnish::block_ending_signals();
  const burnish::Status status = burnish::serve(*line, signals);
  if (status.is_ok()) return 0;
  std::cerr << "burnish-server: " << status.message() << "\n";
  return 1;
}
