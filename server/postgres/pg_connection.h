#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/postgres/pg_address.h"
#include "server/postgres/pg_reply.h"
#include "server/postgres/pg_statement.h"

struct pg_conn;

namespace burnish {

/// How long a connection waits before it gives its server up.
struct PgPatience {
  std::chrono::milliseconds connect{5000};  ///< for each host
  std::chrono::milliseconds reply{5000};    ///< since the server was last heard
};

/// How a transaction ended.
struct PgOutcome {
  enum class End {
    kCommitted,
    kRefused,  ///< the server said no: nothing was changed
    kUnknown,  ///< the connection broke, or the server warned that it could not keep its promise
  };
  End end = End::kCommitted;
  Status why;
  std::vector<PgReply> replies;  ///< of each statement, if it was committed
};

/// A connection to PostgreSQL. No call waits longer than the patience for a sign of the server. It
/// never cancels a statement: PostgreSQL answers a cancelled wait for its standby with success. A
/// connection that was waited for in vain is closed. For one thread at a time.
class PgConnection {
 public:
  /// Tries the hosts in turn. `application` shows in the server's list of connections. Commits wait
  /// for the disk even where the server's settings say otherwise. Fails: unavailable.
  static Result<PgConnection> open(const PgAddress& address, const PgPatience& patience,
                                   const std::string& application);
  PgConnection(PgConnection&&) noexcept;
  PgConnection& operator=(PgConnection&&) noexcept;
  ~PgConnection();

  /// If false, every call fails.
  bool is_open() const { return connection_ != nullptr; }

  /// Does all statements or none, in one round trip.
  PgOutcome transact(std::span<const PgStatement> statements);

  /// Does one statement. Fails: as the server says; unavailable (the connection broke, so nobody
  /// knows whether a change was made).
  Result<PgReply> run(const PgStatement& statement);

  /// Does several commands without values.
  Status script(const char* sql);

 private:
  struct Heard;
  struct Finish {
    void operator()(pg_conn* connection) const;
  };
  PgConnection(pg_conn* connection, const PgPatience& patience);

  bool send(const PgStatement& statement);
  Status wait_for_result();
  Result<PgReply> next_result();
  Status failure_of(const pg_result* result);
  Status give_up(const std::string& why);
  std::string last_words() const;
  PgOutcome hear_transaction(size_t statements);

  std::unique_ptr<Heard> heard_;  // outlives the connection
  std::unique_ptr<pg_conn, Finish> connection_;
  PgPatience patience_;
};

}  // namespace burnish
