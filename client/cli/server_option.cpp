#include "client/cli/server_option.h"

#include "common/base/limits.h"

namespace burnish {

Result<Connection> ServerOption::connect() const {
  ASSIGN_OR_RETURN(
      Connection connection,
      Connection::open(server, std::chrono::milliseconds(int64_t(timeout_seconds * 1000))));
  connection.set_user(user);
  return connection;
}

void add_server_options(CLI::App& command, ServerOption& option) {
  command.add_option("--server", option.server, "The server's address")
      ->type_name("HOST:PORT")
      ->envname("BURNISH_SERVER")
      ->capture_default_str();
  command
      .add_option("--timeout", option.timeout_seconds,
                  "Seconds to wait for the connection and for short answers")
      ->check(CLI::Range(0.001, 86400.0))
      ->capture_default_str();
  command.add_flag("--json", option.json, "Print the result as JSON");
  command
      .add_option("--user", option.user,
                  "Who you are: your edits' author, whose undo is yours alone")
      ->envname("BURNISH_USER");
}

void add_prepared_options(CLI::App& command, PreparedKey& key) {
  command.add_option("--depth", key.depth, "Depth of the grid; left out: the server chooses")
      ->check(CLI::Range(kDepthMin, kDepthMax));
  command
      .add_option("--curvature-radius", key.curvature_radius,
                  "Average curvature over this radius, as a fraction of sqrt(area)")
      ->check(CLI::Range(0.0, 1.0));
}

}  // namespace burnish
