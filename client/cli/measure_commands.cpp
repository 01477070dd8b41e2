#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "client/report/length_text.h"
#include "client/report/moves_text.h"
#include "client/report/section_file.h"

namespace burnish {

namespace {

struct MeasureOptions {
  ServerOption server;
  std::string session;
  std::string out;
  std::array<double, 3> point = {0, 0, 0}, normal = {0, 0, 1};
};

struct UnitOptions {
  ServerOption server;
  std::string scan, unit;
};

Result<ScanInfo> scan_of(Connection& connection, const std::string& session) {
  ASSIGN_OR_RETURN(const SessionState state, connection.state(session));
  const SessionInfo& info = state.session;
  ASSIGN_OR_RETURN(const ScanDescription scan,
                   connection.describe_scan(info.scan_id, info.key.depth));
  return scan.scan;
}

void print(const SessionDeviation& measured, const ScanInfo& scan) {
  const Deviation& deviation = measured.deviation;
  const auto row = [&](const char* name, double length) {
    std::printf("%-14s %s\n", name, length_text(length, scan.unit, kDeviationDigits).c_str());
  };
  row("largest", deviation.max);
  row("mean", deviation.mean);
  row("rms", deviation.rms);
  row("outwards", deviation.outward_max);
  row("inwards", deviation.inward_max);
  for (size_t axis = 0; deviation.axes && axis < 3; ++axis)
    std::printf("along %-8c %s\n", "xyz"[axis],
                moves_text((*deviation.axes)[axis], scan.unit).c_str());
  if (scan.statistics.is_closed())
    std::printf("%-14s %+.4f %%\n", "volume",
                100 * (deviation.volume_after / deviation.volume_before - 1));
  if (!measured.settled) std::printf("the surface has not settled; an export moves it further\n");
}

Status run_deviation(const MeasureOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const SessionDeviation measured, connection.deviation(options.session));
  if (options.server.json) {
    print_json(to_json(measured));
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const ScanInfo scan, scan_of(connection, options.session));
  print(measured, scan);
  return Status::ok();
}

Status run_section(const MeasureOptions& options) {
  const auto vector = [](const std::array<double, 3>& v) { return Vec3d(v[0], v[1], v[2]); };
  ASSIGN_OR_RETURN(const Plane plane, make_plane(vector(options.point), vector(options.normal)));
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const ScanInfo scan, scan_of(connection, options.session));
  ASSIGN_OR_RETURN(const Section section, connection.section({options.session, plane}));
  if (section.original.empty())
    return failed_precondition("the plane does not meet scan " + scan.name);
  RETURN_IF_ERROR(write_section(section, scan.unit, options.out));
  std::printf("%s: lines before the edits: %zu, after: %zu\n", options.out.c_str(),
              section.original.size(), section.edited.size());
  return Status::ok();
}

Status run_unit(const UnitOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const ScanInfo scan, connection.set_scan_unit(options.scan, options.unit));
  if (options.server.json) {
    print_json(to_json(scan));
  } else {
    std::printf("%s: %s\n", scan.name.c_str(),
                scan.unit.empty() ? "the unit is not named" : scan.unit.c_str());
  }
  return Status::ok();
}

}  // namespace

void add_deviation_command(CommandTable& table) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = table.add("deviation", "Say how far a session's edits moved the surface",
                                [options] { return run_deviation(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  add_server_options(*command, options->server);
}

void add_section_command(CommandTable& table) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command =
      table.add("section", "Cut a session's surface, before its edits and after them",
                [options] { return run_section(*options); });
  command->add_option("SESSION", options->session, "Name or id")->required();
  command->add_option("OUT", options->out, "Drawing (.svg) or table of points (.csv)")
      ->required()
      ->check([](const std::string& file) { return usage_message(check_section_name(file)); });
  command->add_option("--point", options->point, "A point of the plane, in the scan's units")
      ->required()
      ->type_name("X Y Z");
  command
      ->add_option("--normal", options->normal, "The direction across the plane: 0 0 1 if absent")
      ->type_name("X Y Z");
  add_server_options(*command, options->server);
}

void add_unit_command(CommandTable& table) {
  auto options = std::make_shared<UnitOptions>();
  CLI::App* command = table.add("unit", "Name the unit of a scan's coordinates",
                                [options] { return run_unit(*options); });
  command->add_option("SCAN", options->scan, "Name, id, or the beginning of an id")->required();
  command->add_option("UNIT", options->unit, "For example mm; \"\" for none")
      ->required()
      ->check([](const std::string& unit) { return usage_message(check_unit(unit)); });
  add_server_options(*command, options->server);
}

}  // namespace burnish
