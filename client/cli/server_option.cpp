#include "client/cli/server_option.h"

#include <cerrno>
#include <fstream>

#include "client/cli/in_range.h"
#include "common/base/limits.h"
#include "common/base/text.h"

namespace burnish {

/// Reads the first word of a file.
static Result<std::string> read_token(const std::string& path) {
  std::ifstream file(path);
  std::string token;
  if (!file) return errno_status("cannot read the token in " + path, errno);
  if (!(file >> token)) return invalid_argument("the token file " + path + " is empty");
  return token;
}

Result<ConnectionTrust> ServerOption::full_trust() const {
  ConnectionTrust all = trust;
  if (!token_file.empty()) {
    ASSIGN_OR_RETURN(all.token, read_token(token_file));
  }
  return all;
}

Result<Connection> ServerOption::connect() const {
  if (!user.empty()) RETURN_IF_ERROR(check_name("the user's name", user));
  ASSIGN_OR_RETURN(const ConnectionTrust all, full_trust());
  const auto timeout = std::chrono::milliseconds(int64_t(timeout_seconds * 1000));
  ASSIGN_OR_RETURN(Connection connection, Connection::open(server, timeout, all));
  connection.set_user(user);
  return connection;
}

static void add_trust_options(CLI::App& command, ServerOption& option) {
  ConnectionTrust& trust = option.trust;
  command.add_flag("--tls", trust.tls, "Connect by TLS, trusting the system's CAs");
  command.add_option("--tls-ca", trust.ca, "Connect by TLS, trusting this CA (PEM)")
      ->envname("BURNISH_TLS_CA");
  command.add_option("--tls-certificate", trust.certificate, "This client's certificate (PEM)")
      ->envname("BURNISH_TLS_CERTIFICATE");
  command.add_option("--tls-key", trust.key, "Its private key (PEM)")->envname("BURNISH_TLS_KEY");
  command
      .add_option("--token-file", option.token_file,
                  "File with the token that identifies this user")
      ->envname("BURNISH_TOKEN_FILE");
  command.add_flag("--insecure", trust.insecure, "Send the token in plain text to another machine");
}

void add_server_options(CLI::App& command, ServerOption& option) {
  command.add_option("--server", option.server, "The server's address")
      ->type_name("HOST:PORT|unix:PATH")
      ->envname("BURNISH_SERVER")
      ->capture_default_str();
  command
      .add_option("--timeout", option.timeout_seconds,
                  "Seconds to wait for the connection and for short answers")
      ->check(in_range(0.001, 86400.0))
      ->capture_default_str();
  command.add_flag("--json", option.json, "Print the result as JSON");
  command
      .add_option("--user", option.user, "Your name: the author of your edits; only you undo them")
      ->envname("BURNISH_USER");
  add_trust_options(command, option);
}

void add_prepared_options(CLI::App& command, PreparedKey& key) {
  command.add_option("--depth", key.depth, "Depth of the grid; left out: the server chooses")
      ->check(in_range(kDepthMin, kDepthMax));
  command
      .add_option("--curvature-radius", key.curvature_radius,
                  "Average curvature over this radius, as a fraction of sqrt(area)")
      ->check(in_range(0.0, kCurvatureRadiusMax));
}

}  // namespace burnish
