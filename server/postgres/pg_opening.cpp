#include "server/postgres/pg_opening.h"

#include <memory>
#include <poll.h>

#include <libpq-fe.h>

#include "server/postgres/pg_status.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

struct FinishOpening {
  void operator()(PGconn* connection) const { PQfinish(connection); }
};
using Opening = std::unique_ptr<PGconn, FinishOpening>;

/// Starts to connect to one of the hosts. The URI's own parameters count more than the first ones
/// here, and less than the last ones.
Opening start_opening(const PgAddress& address, const PgAddress::Host& host,
                      const std::string& application) {
  // A cut cable is noticed after this time, where the system can do that.
  const char* keywords[] = {
      "tcp_user_timeout", "dbname", "application_name", "host", "port", nullptr};
  const char* values[] = {"5000",
                          address.uri().c_str(),
                          application.c_str(),
                          host.name.empty() ? nullptr : host.name.c_str(),
                          host.port.empty() ? nullptr : host.port.c_str(),
                          nullptr};
  return Opening(PQconnectStartParams(keywords, values, 1));
}

/// Returns whether the connection is made in time.
bool finish_opening(PGconn* connection, milliseconds time, std::string& why) {
  const auto deadline = steady_clock::now() + time;
  PostgresPollingStatusType wish = PGRES_POLLING_WRITING;
  while (wish != PGRES_POLLING_OK) {
    if (wish == PGRES_POLLING_FAILED || PQstatus(connection) == CONNECTION_BAD) {
      why = trimmed_words(PQerrorMessage(connection));
      return false;
    }
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd socket{PQsocket(connection),
                  static_cast<short>(wish == PGRES_POLLING_READING ? POLLIN : POLLOUT), 0};
    if (left.count() <= 0 || ::poll(&socket, 1, static_cast<int>(left.count())) == 0) {
      why = "no answer for " + std::to_string(time.count()) + " ms";
      return false;
    }
    wish = PQconnectPoll(connection);
  }
  return true;
}

}  // namespace

Result<pg_conn*> open_pg(const PgAddress& address, milliseconds time,
                         const std::string& application) {
  std::string reasons;
  for (const PgAddress::Host& host : address.hosts()) {
    Opening opening = start_opening(address, host, application);
    std::string why = "out of memory";
    if (opening && finish_opening(opening.get(), time, why)) {
      PQsetnonblocking(opening.get(), 1);
      return opening.release();
    }
    reasons += (reasons.empty() ? "" : "; ") + (host.name.empty() ? "" : host.name + ": ") + why;
  }
  return unavailable("no database of the journal answers: " + reasons);
}

}  // namespace burnish
