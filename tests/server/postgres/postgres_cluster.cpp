#include "tests/server/postgres/postgres_cluster.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <unistd.h>
#include <vector>

#include "common/base/check.h"
#include "server/postgres/pg_connection.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

/// Returns the folder of the newest PostgreSQL's programs.
std::string programs() {
  std::string found;
  for (const auto& version : fs::directory_iterator("/usr/lib/postgresql"))
    if (fs::exists(version.path() / "bin/initdb")) found = (version.path() / "bin").string();
  BURNISH_CHECK(!found.empty(), "PostgreSQL is missing; deploy/setup installs it");
  return found;
}

}  // namespace

PostgresCluster::PostgresCluster(const std::string& settings) {
  for (size_t begin = 0; begin < settings.size();) {
    const size_t end = std::min(settings.find(' ', begin), settings.size());
    settings_ += " -c " + settings.substr(begin, end - begin);
    begin = end + 1;
  }
  make_folder();
  as_owner(programs() + "/initdb -D " + folder_.string() +
           "/data -A trust -U burnish -E UTF8 --locale=C --no-sync");
  watch();
  start();
}

PostgresCluster::PostgresCluster(PostgresCluster& primary) : settings_(primary.settings_) {
  make_folder();
  as_owner(programs() + "/pg_basebackup -D " + folder_.string() + "/data -R -h " +
           primary.folder_.string() + " -U burnish -X stream -c fast --no-sync");
  watch();
  start();
}

void PostgresCluster::make_folder() {
  std::string name = "/tmp/burnish-pg-XXXXXX";
  BURNISH_CHECK(::mkdtemp(name.data()) != nullptr, "no temporary folder for PostgreSQL");
  folder_ = name;
  if (::geteuid() == 0)
    BURNISH_CHECK(std::system(("chown postgres " + name).c_str()) == 0, "no user postgres");
}

/// Outlives this program for a moment, to stop the server and to remove the folder.
void PostgresCluster::watch() const {
  const std::string name = folder_.string();
  const std::string watcher = "(setsid sh -c 'tail --pid=" + std::to_string(::getpid()) +
                              " -f /dev/null; kill -9 $(head -1 " + name +
                              "/data/postmaster.pid); sleep 0.2; rm -rf " + name +
                              "' </dev/null >/dev/null 2>&1 &)";
  BURNISH_CHECK(std::system(watcher.c_str()) == 0, watcher);
}

void PostgresCluster::promote() const {
  as_owner(programs() + "/pg_ctl -w -D " + folder_.string() + "/data promote");
}

PostgresCluster& PostgresCluster::shared() {
  static PostgresCluster cluster("fsync=off");
  return cluster;
}

void PostgresCluster::as_owner(const std::string& command) const {
  const std::string user = ::geteuid() == 0 ? "runuser -u postgres -- " : "";
  const std::string line = "cd / && " + user + command + " >" + folder_.string() + ".log 2>&1";
  BURNISH_CHECK(std::system(line.c_str()) == 0, line);
  fs::remove(folder_.string() + ".log");
}

void PostgresCluster::start() {
  const std::string folder = folder_.string();
  as_owner(programs() + "/pg_ctl -w -D " + folder + "/data -l " + folder + "/log -o \"-k " +
           folder + " -c listen_addresses=" + settings_ + "\" start");
}

std::string PostgresCluster::uri(const std::string& database) const {
  return "postgresql://burnish@/" + database + "?host=" + folder_.string();
}

std::string PostgresCluster::make_database() {
  const std::string name = "test" + std::to_string(databases_++);
  auto connection = PgConnection::open(PgAddress::parse(uri("postgres")).value(),
                                       {std::chrono::seconds(60), std::chrono::seconds(60)}, "test")
                        .value();
  const Status made = connection.run({"CREATE DATABASE " + name, {}}).status();
  BURNISH_CHECK(made.is_ok(), made.message());
  return uri(name);
}

int PostgresCluster::first_process() const {
  int process = 0;
  std::ifstream(folder_ / "data/postmaster.pid") >> process;
  BURNISH_CHECK(process > 1, "PostgreSQL does not run");
  return process;
}

void PostgresCluster::kill() {
  const int process = first_process();
  signal_all(SIGKILL);
  while (::kill(process, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

// Its processes belong to one session each, and to one parent.
void PostgresCluster::signal_all(int number) const {
  const std::string parent = std::to_string(first_process());
  const std::string sign = std::to_string(number);
  // A child may end between the two commands.
  const std::string line = "children=$(ps -o pid= --ppid " + parent + "); kill -" + sign + " " +
                           parent + " && { kill -" + sign + " $children 2>/dev/null || true; }";
  BURNISH_CHECK(std::system(line.c_str()) == 0, line);
}

}  // namespace burnish
