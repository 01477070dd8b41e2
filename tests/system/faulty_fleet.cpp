#include "tests/system/faulty_fleet.h"

#include <csignal>

#include "client/connection/connection.h"
#include "common/base/check.h"
#include "server/postgres/pg_connection.h"
#include "tests/system/fleet_config.h"

namespace burnish {

using std::chrono::milliseconds;

FaultyFleet::FaultyFleet(uint32_t seed) : random_(seed) {
  const std::string scan = write_sphere(folder_);
  for (const char* name : {"one", "two"}) {
    auto& server = servers_.emplace_back(std::make_unique<ServerProcess>(fleet_flags(
        folder_, {.name = name, .journal = uri_, .lease_ms = 1000, .heartbeat_ms = 200})));
    server->listen = server->address;
    EXPECT_EQ(server->burnish({"import", scan, "--depth", "4", "--name", "ball"}).exit_code, 0);
  }
  // A busy machine may put a heartbeat off for so long that the server stops for a moment.
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (servers_[0]->burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code != 0)
    BURNISH_CHECK(std::chrono::steady_clock::now() < end, "no session in time");
  for (int i = 0; i < 3; ++i)
    clients_.emplace_back([this, i](const std::stop_token& stop) { edit(i, stop); });
}

void FaultyFleet::fault() {
  std::this_thread::sleep_for(milliseconds(random_() % 1000));
  ServerProcess& server = *servers_[random_() % servers_.size()];
  switch (random_() % 4) {
    case 0:
      server.kill();
      server.start();
      break;
    case 1:
      server.process->signal(SIGSTOP);
      std::this_thread::sleep_for(milliseconds(500 + random_() % 2000));
      server.process->signal(SIGCONT);
      break;
    case 2:
      cluster_.kill();
      cluster_.start();
      break;
    default:
      free_session();
  }
}

void FaultyFleet::free_session() const {
  PgConnection database = PgConnection::open(address_, {}, "test").value();
  EXPECT_TRUE(database.script("UPDATE sessions SET owner = NULL").is_ok());
}

void FaultyFleet::stop_clients() {
  for (std::jthread& client : clients_) client.request_stop();
  clients_.clear();
}

void FaultyFleet::edit(int client, const std::stop_token& stop) {
  std::minstd_rand random(static_cast<uint32_t>(client + 1));
  for (int number = 0; !stop.stop_requested(); ++number) {
    const Edit edit{std::to_string(client) + "-" + std::to_string(number),
                    SetGradientScale{0.01 * (number % 100)}};
    history_.sent(edit.id);
    while (!apply(*servers_[random() % servers_.size()], edit).is_ok())
      std::this_thread::sleep_for(milliseconds(20));
    history_.acknowledged(edit.id);
  }
}

Status FaultyFleet::apply(const ServerProcess& server, const Edit& edit) {
  auto connection = Connection::open(server.listen, std::chrono::seconds(2));
  return connection.is_ok() ? connection->apply("work", {&edit, 1}).status() : connection.status();
}

}  // namespace burnish
