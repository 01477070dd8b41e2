#include "server/config/command_line.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "server/config/config_file.h"
#include "server/config/config_reference.h"

namespace burnish {
namespace {

/// The given flags. A flag that is not given leaves the configuration alone.
struct Flags {
  std::string config;
  std::string print;
  std::string port_file;
  std::optional<std::string> listen, socket, data, journal, backend, log_level, log_format, users,
      certificate, key, client_ca, metrics, web, fleet_name, advertise;
  std::vector<std::string> web_hosts;
  std::optional<int64_t> threads, idle_exit;
  bool insecure = false;
  bool socket_user_only = false;
  bool ends_with_input = false;
  JournalCopyWish copy;
};

void add_flags(CLI::App& app, Flags& flags) {
  app.set_version_flag("--version", "burnish-server " BURNISH_VERSION);
  app.add_option("--config", flags.config, "Configuration file (TOML); flags override it");
  app.add_option("--print-config", flags.print,
                 "Print a configuration file with every key, its meaning and its default, and end")
      ->type_name("toml|json")
      ->check(CLI::IsMember({"toml", "json"}));
  app.add_option("--listen", flags.listen,
                 "Address, default 127.0.0.1:7411; port 0 takes a free one")
      ->type_name("HOST:PORT");
  app.add_option("--socket", flags.socket, "Listen on this Unix socket as well");
  app.add_flag("--socket-user-only", flags.socket_user_only,
               "Only the server's own user may use the socket, not its group");
  app.add_option("--port-file", flags.port_file, "Write the chosen port into this file");
  app.add_option("--data", flags.data, "Folder for scans and edits, default burnish-data")
      ->type_name("FOLDER");
  app.add_option("--journal", flags.journal,
                 "PostgreSQL database for sessions and edits, in place of a file in the folder")
      ->type_name("postgresql://USER@HOST:PORT/DATABASE");
  app.add_option("--threads", flags.threads, "Threads of the solver; 0, the default: all cores");
  app.add_option("--backend", flags.backend, "auto, cpu or cuda; default auto");
  app.add_option("--log-level", flags.log_level,
                 "trace, debug, info, warn, error or off; default info");
  app.add_option("--log-format", flags.log_format, "text or json; default text");
  app.add_option("--users", flags.users, "File of users and their roles (TOML)");
  app.add_option("--tls-certificate", flags.certificate, "The server's certificate (PEM)");
  app.add_option("--tls-key", flags.key, "Its private key (PEM)");
  app.add_option("--tls-client-ca", flags.client_ca, "Clients need a certificate of this CA (PEM)");
  app.add_option("--metrics", flags.metrics, "Serve Prometheus metrics here")
      ->type_name("HOST:PORT");
  app.add_option("--web", flags.web, "Serve browsers here: the page, and calls over WebSocket")
      ->type_name("HOST:PORT");
  app.add_option("--web-host", flags.web_hosts,
                 "Another name of this machine that browsers may use; may be repeated")
      ->type_name("NAME");
  app.add_option("--idle-exit", flags.idle_exit,
                 "End after this many seconds without a connection; 0, the default: never")
      ->type_name("SECONDS");
  app.add_flag("--end-with-input", flags.ends_with_input,
               "End when standard input ends: with the program that holds its other end");
  app.add_option("--fleet-name", flags.fleet_name,
                 "Name of this server among those that share the journal");
  app.add_option("--advertise", flags.advertise, "Where clients of the fleet reach this server")
      ->type_name("HOST:PORT");
  app.add_flag("--insecure", flags.insecure,
               "Serve other machines in plain text, or without authentication");
}

/// Returns the command that copies a journal.
CLI::App* add_journal_command(CLI::App& app, Flags& flags) {
  CLI::App* journal = app.add_subcommand("journal", "Work on a journal while no server uses it");
  journal->require_subcommand(1);
  CLI::App* copy = journal->add_subcommand(
      "copy", "Copy all sessions and edits into an empty journal, in one transaction");
  copy->add_option("FROM", flags.copy.from, "A data folder, or the URI of a database")->required();
  copy->add_option("TO", flags.copy.to, "Likewise; without sessions")->required();
  return copy;
}

Result<CommandLine> read(const Flags& flags) {
  CommandLine line;
  ServerConfig& config = line.config;
  if (!flags.config.empty()) RETURN_IF_ERROR(read_config_file(flags.config, config));
  const auto set = [](const auto& flag, auto& value) {
    if (flag) value = *flag;
  };
  set(flags.listen, config.listen);
  set(flags.socket, config.socket);
  set(flags.data, config.data);
  set(flags.journal, config.journal);
  set(flags.threads, config.threads);
  set(flags.idle_exit, config.idle_exit_seconds);
  set(flags.log_level, config.log_level);
  set(flags.log_format, config.log_format);
  set(flags.users, config.users);
  set(flags.certificate, config.tls_certificate);
  set(flags.key, config.tls_key);
  set(flags.client_ca, config.tls_client_ca);
  set(flags.metrics, config.metrics_listen);
  set(flags.web, config.web_listen);
  config.web_hosts.insert(config.web_hosts.end(), flags.web_hosts.begin(), flags.web_hosts.end());
  set(flags.fleet_name, config.fleet_name);
  set(flags.advertise, config.fleet_advertise);
  if (flags.backend) {
    ASSIGN_OR_RETURN(config.backend, parse_backend(*flags.backend));
  }
  config.insecure |= flags.insecure;
  config.socket_user_only |= flags.socket_user_only;
  RETURN_IF_ERROR(validate(config));
  line.port_file = flags.port_file;
  line.ends_with_input = flags.ends_with_input;
  return line;
}

}  // namespace

std::optional<CommandLine> parse_command_line(int argc, const char* const* argv, int& exit_code) {
  CLI::App app("Burnish's server: keeps scans, edits them in sessions, and serves both over gRPC.",
               "burnish-server");
  Flags flags;
  add_flags(app, flags);
  const CLI::App* copy = add_journal_command(app, flags);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exit_code = app.exit(error) == 0 ? 0 : 2;
    return std::nullopt;
  }
  if (!flags.print.empty()) {
    std::cout << (flags.print == "toml" ? config_example() : config_keys_json() + "\n");
    exit_code = 0;
    return std::nullopt;
  }
  auto line = read(flags);
  if (line.is_ok() && copy->parsed()) line->copy = flags.copy;
  if (line.is_ok()) return std::move(*line);
  std::cerr << "burnish-server: " << line.status().message() << "\n";
  exit_code = 2;
  return std::nullopt;
}

}  // namespace burnish
