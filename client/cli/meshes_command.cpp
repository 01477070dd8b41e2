#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"

namespace burnish {

namespace {

void print_line(const ScanInfo& scan) {
  std::string depths;
  for (const PreparedInfo& prepared : scan.prepared)
    depths += (depths.empty() ? "" : ",") + std::to_string(prepared.key.depth);
  std::printf("%s  %10llu  %10llu  %-8s  %s\n", short_id(scan.id).c_str(),
              static_cast<unsigned long long>(scan.statistics.vertices),
              static_cast<unsigned long long>(scan.statistics.triangles), depths.c_str(),
              scan.name.c_str());
}

Status run(const ServerOption& option) {
  ASSIGN_OR_RETURN(Connection connection, option.connect());
  ASSIGN_OR_RETURN(const auto scans, connection.list_scans());
  if (option.json) {
    auto json = nlohmann::ordered_json::array();
    for (const ScanInfo& scan : scans) json.push_back(to_json(scan));
    print_json(json);
    return Status::ok();
  }
  std::printf("%-12s  %10s  %10s  %-8s  %s\n", "id", "vertices", "triangles", "depths", "name");
  for (const ScanInfo& scan : scans) print_line(scan);
  return Status::ok();
}

}  // namespace

void add_meshes_command(CommandTable& table) {
  auto option = std::make_shared<ServerOption>();
  CLI::App* command =
      table.add("meshes", "List the server's scans", [option] { return run(*option); });
  add_server_options(*command, *option);
}

}  // namespace burnish
