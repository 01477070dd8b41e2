#include <iostream>
#include <malloc.h>
#include <optional>
#include <thread>
#include <unistd.h>

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include "common/base/atomic_file.h"
#include "common/base/wait_policy.h"
#include "server/config/command_line.h"
#include "server/library/stale_files.h"
#include "server/live/live_sessions.h"
#include "server/main/daemon.h"
#include "server/main/gauges.h"
#include "server/main/journals.h"
#include "server/process/disk_watch.h"
#include "server/process/hidden_folder.h"
#include "server/process/input_end.h"
#include "server/process/log_setup.h"
#include "server/scheduling/pools.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/device_probe.h"

namespace burnish {
namespace {

constexpr int kExitFailed = 1;
constexpr int kExitDeviceFailed = 3;
constexpr int kSolverThreads = 1;                            // all cores of the CPU, or the one GPU
constexpr auto kLastWords = std::chrono::milliseconds(200);  // time to send NOT_SERVING

Status write_port_file(const std::filesystem::path& path, int port) {
  if (path.empty()) return Status::ok();
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  RETURN_IF_ERROR(file.write(std::to_string(port) + "\n"));
  return file.commit();
}

/// Files that are read again while the server runs; null if the configuration names no such file.
struct TrustFiles {
  std::unique_ptr<Reloaded<Certificates>> certificates;
  std::unique_ptr<Reloaded<UserTable>> users;
};

Result<TrustFiles> open_trust_files(const ServerConfig& config) {
  TrustFiles files;
  if (!config.tls_certificate.empty()) {
    const CertificateFiles names{config.tls_certificate, config.tls_key, config.tls_client_ca};
    std::vector<std::filesystem::path> watched = {names.certificate, names.key};
    if (!names.client_ca.empty()) watched.push_back(names.client_ca);
    ASSIGN_OR_RETURN(files.certificates, Reloaded<Certificates>::open(watched, [names] {
                       return read_certificates(names);
                     }));
  }
  if (!config.users.empty()) {
    ASSIGN_OR_RETURN(files.users, Reloaded<UserTable>::open({config.users}, [name = config.users] {
                       return read_users_file(name);
                     }));
  }
  return files;
}

template <typename T>
void reload(Reloaded<T>* file, bool in_any_case, const char* what) {
  if (!file) return;
  const auto changed = file->refresh(in_any_case);
  if (!changed.is_ok()) {
    spdlog::error("{} are unchanged: {}", what, changed.status().message());
  } else if (changed.value()) {
    spdlog::info("{} read again", what);
  }
}

ServerOptions server_options(const ServerConfig& config, const TrustFiles& files) {
  ServerOptions options;
  options.listen = config.listen;
  options.socket = config.socket;
  options.socket_user_only = config.socket_user_only;
  options.certificates = files.certificates.get();
  options.client_certificate_required = config.tls_client_certificate_required;
  options.users = files.users.get();
  options.web = config.web_listen;
  options.web_hosts = config.web_hosts;
  options.connections = {static_cast<size_t>(config.connections_max),
                         static_cast<size_t>(config.connections_per_peer),
                         std::chrono::seconds(config.silent_connection_seconds)};
  options.streams_per_user = static_cast<uint64_t>(config.streams_per_user);
  options.upload_silence_max = std::chrono::seconds(config.silent_upload_seconds);
  return options;
}

Pools::Limits pool_limits(const ServerConfig& config) {
  return {static_cast<int>(config.workers), static_cast<int>(config.workers_per_user),
          static_cast<uint64_t>(config.requests_per_user),
          static_cast<uint64_t>(config.request_bytes_per_user)};
}

MeshStoreOptions store_options(const ServerConfig& config) {
  MeshStoreOptions options;
  options.upload_bytes_max = static_cast<uint64_t>(config.upload_bytes_max);
  options.upload_bytes_per_user = static_cast<uint64_t>(config.upload_bytes_per_user);
  options.memory_bytes_max = resolved_memory_bytes_max(config);
  options.device_memory_bytes_max =
      device_bytes_max(config.backend, static_cast<int>(config.devices));
  options.threads = static_cast<int>(config.threads);
  return options;
}

SessionManagerOptions session_options(const ServerConfig& config) {
  SessionManagerOptions options;
  options.kept.sessions_max = static_cast<size_t>(config.sessions_max);
  options.kept.sessions_per_user = static_cast<uint64_t>(config.kept_sessions_per_user);
  options.kept.sessions_for_owners = static_cast<size_t>(config.sessions_for_owners);
  options.kept.history_bytes_per_session = static_cast<uint64_t>(config.history_bytes_per_session);
  options.kept.history_bytes_per_user = static_cast<uint64_t>(config.history_bytes_per_user);
  options.sessions_per_user = static_cast<uint64_t>(config.sessions_per_user);
  options.solver.backend = config.backend;
  options.solver.devices = static_cast<int>(config.devices);
  options.solver.threads = static_cast<int>(config.threads);
  return options;
}

// A failed device may hold its callers for ever, so nothing can be waited for. Acknowledged edits
// are on disk. The supervisor starts the server again, which replays them.
[[noreturn]] void end_at_once(const Status& status) {
  spdlog::critical("{}; ending, so that the supervisor starts the server again", status.message());
  spdlog::default_logger()->flush();
  std::this_thread::sleep_for(kLastWords);
  std::_Exit(kExitDeviceFailed);
}

Result<std::unique_ptr<MetricsExporter>> start_metrics(const std::string& listen,
                                                       std::function<std::vector<Gauge>()> gauges) {
  if (listen.empty()) return std::unique_ptr<MetricsExporter>();
  ASSIGN_OR_RETURN(auto exporter, MetricsExporter::start(listen, std::move(gauges)));
  set_metrics(exporter->figures());
  std::cout << "metrics on port " << exporter->port() << std::endl;
  return exporter;
}

/// Without a device only the server's own threads can be late: a busy machine has not failed.
DeviceWatch::Times watch_times(BackendKind backend) {
  DeviceWatch::Times times;
  if (!has_device(backend)) times.answer_max = std::chrono::hours(1);
  return times;
}

void tend_disk(const DataFolder& folder, DiskWatch& watch) {
  const uint64_t free = folder.free_bytes();
  folder.keep_spare();
  if (const auto level = watch.look(free))
    spdlog::warn("the disk of {} has {} MiB free, less than {} MiB: delete scans, or make room",
                 folder.path().string(), free >> 20, *level >> 20);
}

/// Serves until a signal or a long time without use ends it.
Status serve(const CommandLine& line, const sigset_t& signals) {
  const ServerConfig& config = line.config;
  ASSIGN_OR_RETURN(const std::string where_solved, say_where_solved(config.backend));
  ASSIGN_OR_RETURN(const TrustFiles files, open_trust_files(config));
  ASSIGN_OR_RETURN(const auto folder, DataFolder::open(config.data));
  folder->keep_spare();
  if (config.device_memory_bytes_max > 0)
    set_cuda_memory_budget(static_cast<uint64_t>(config.device_memory_bytes_max));
  remove_stale_files(*folder);
  ASSIGN_OR_RETURN(const auto opened_store, MeshStore::open(*folder, store_options(config)));
  MeshStore& store = *opened_store;
  const HiddenFolder hidden(config.data,
                            [&store](const std::string& id) { return store.name_of(id); });
  ASSIGN_OR_RETURN(const OpenedJournal journal, open_journal_of(config, *folder));
  RETURN_IF_ERROR(share_scans(config, journal, store));
  ASSIGN_OR_RETURN(const auto sessions, SessionManager::create(*folder, store, *journal.journal,
                                                               session_options(config)));
  if (journal.watch)
    sessions->set_hold_check([watch = journal.watch.get()] { return watch->check(); });
  LiveSessions live(*sessions, kSolverThreads);
  Pools pools(pool_limits(config));
  ASSIGN_OR_RETURN(const auto server,
                   Server::start(server_options(config, files), store, *sessions, live, pools));
  const std::jthread fleet = follow_fleet(config, journal, *sessions, live);
  ASSIGN_OR_RETURN(const auto exporter, start_metrics(config.metrics_listen, [&] {
                     return read_gauges(*server, *folder, store, *sessions, live,
                                        files.certificates.get(), journal.membership.get());
                   }));
  const DeviceWatch device([backend = config.backend] { return probe_device(backend); },
                           watch_times(config.backend));

  RETURN_IF_ERROR(write_port_file(line.port_file, server->port()));
  if (!server->web_address().empty()) std::cout << "web on " << server->web_address() << std::endl;
  std::cout << "listening on " << server->address() << std::endl;
  spdlog::info("sessions are solved on {}", where_solved);
  spdlog::info("data in {}: {} scans, {} sessions", config.data.string(), store.list().size(),
               sessions->list().size());
  DiskWatch disk;
  DaemonOptions options;
  options.drain_time = std::chrono::seconds(config.drain_seconds);
  options.idle_max = std::chrono::seconds(config.idle_exit_seconds);
  if (line.ends_with_input) options.is_abandoned = [] { return has_ended(STDIN_FILENO); };
  options.tend = [&](bool in_any_case) {
    (void)sessions->check_hold();
    tend_disk(*folder, disk);
    live.end_unwelcome();
    if (config.idle_spill_seconds > 0)
      sessions->spill_idle(std::chrono::seconds(config.idle_spill_seconds));
    reload(files.certificates.get(), in_any_case, "certificates");
    reload(files.users.get(), in_any_case, "users");
  };
  options.find_successors = [&] { return tell_fleet_of_drain(journal); };
  const Status status = watch_over(*server, device, signals, options);
  if (!status.is_ok()) end_at_once(status);
  spdlog::info("stopped");
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  umask(S_IRWXG | S_IRWXO);  // only this user may read scans and edits
  burnish::sleep_while_waiting(argv);
  // glibc gives nearly every thread its own heap, and the memory of closed sessions stays in many
  // heaps. Fourteen sessions opened and closed in turn left 326 MB resident; with two heaps they
  // leave 131 MB.
  mallopt(M_ARENA_MAX, 2);
  int exit_code = 0;
  const auto line = burnish::parse_command_line(argc, argv, exit_code);
  if (!line) return exit_code;
  burnish::set_up_log(line->config.log_level, line->config.log_format);
  const sigset_t signals = burnish::block_signals();
  const burnish::Status status = line->copy
                                     ? burnish::copy_journal_of(line->copy->from, line->copy->to)
                                     : burnish::serve(*line, signals);
  if (status.is_ok()) return 0;
  std::cerr << "burnish-server: " << status.message() << "\n";
  return burnish::kExitFailed;
}
