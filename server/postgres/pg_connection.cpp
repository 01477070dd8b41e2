#include "server/postgres/pg_connection.h"

#include <bit>
#include <cstring>
#include <optional>
#include <poll.h>

#include <libpq-fe.h>

#include "server/postgres/pg_opening.h"
#include "server/postgres/pg_status.h"

namespace burnish {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// The last message of the server.
struct PgConnection::Heard {
  std::string warning;   // since the transaction began
  std::string sqlstate;  // of the last error
};

static void hear_notice(void* heard, const PGresult* notice) {
  const char* severity = PQresultErrorField(notice, PG_DIAG_SEVERITY_NONLOCALIZED);
  if (severity && std::strcmp(severity, "WARNING") == 0)
    *static_cast<std::string*>(heard) = PQresultErrorMessage(notice);
}

void PgConnection::Finish::operator()(pg_conn* connection) const {
  PQfinish(connection);
}

PgConnection::PgConnection(pg_conn* connection, const PgPatience& patience)
    : heard_(std::make_unique<Heard>()), connection_(connection), patience_(patience) {
  PQsetNoticeReceiver(connection, hear_notice, &heard_->warning);
}

PgConnection::PgConnection(PgConnection&&) noexcept = default;
PgConnection& PgConnection::operator=(PgConnection&&) noexcept = default;
PgConnection::~PgConnection() = default;

Result<PgConnection> PgConnection::open(const PgAddress& address, const PgPatience& patience,
                                        const std::string& application) {
  ASSIGN_OR_RETURN(pg_conn * opened, open_pg(address, patience.connect, application));
  PgConnection connection(opened, patience);
  RETURN_IF_ERROR(connection.script(
      "SET search_path = burnish; SET default_transaction_isolation = 'read committed';"
      "SELECT set_config('synchronous_commit', 'on', false)"
      " WHERE current_setting('synchronous_commit') = 'off'"));
  return connection;
}

std::string PgConnection::last_words() const {
  return trimmed_words(PQerrorMessage(connection_.get()));
}

Status PgConnection::give_up(const std::string& why) {
  connection_.reset();
  return unavailable("journal: " + why);
}

namespace {

constexpr Oid kBytea = 17, kBigint = 20, kText = 25, kDouble = 701;

std::string network_order(uint64_t bits) {
  std::string bytes(sizeof bits, '\0');
  for (size_t i = bytes.size(); i-- > 0; bits >>= 8) bytes[i] = static_cast<char>(bits & 0xff);
  return bytes;
}

/// A statement's values as libpq takes them.
struct Encoded {
  explicit Encoded(const std::vector<PgValue>& values) {
    for (const PgValue& value : values) std::visit([this](const auto& v) { add(v); }, value);
    for (const std::string& value : bytes) {
      pointers.push_back(value.data());
      lengths.push_back(static_cast<int>(value.size()));
    }
    formats.assign(bytes.size(), 1);
  }

  void add(Oid type, std::string value) {
    types.push_back(type);
    bytes.push_back(std::move(value));
  }
  void add(const std::string& value) { add(kBytea, value); }
  void add(int64_t value) { add(kBigint, network_order(static_cast<uint64_t>(value))); }
  void add(double value) { add(kDouble, network_order(std::bit_cast<uint64_t>(value))); }
  void add(const PgText& value) { add(kText, value.text); }

  std::vector<Oid> types;
  std::vector<std::string> bytes;
  std::vector<const char*> pointers;
  std::vector<int> lengths, formats;
};

}  // namespace

bool PgConnection::send(const PgStatement& statement) {
  const Encoded values(statement.values);
  return PQsendQueryParams(connection_.get(), statement.sql.c_str(),
                           static_cast<int>(values.bytes.size()), values.types.data(),
                           values.pointers.data(), values.lengths.data(), values.formats.data(),
                           1) == 1;
}

/// Sends what waits, and returns when a result can be taken without waiting.
Status PgConnection::wait_for_result() {
  auto deadline = steady_clock::now() + patience_.reply;
  for (;;) {
    const int unsent = PQflush(connection_.get());
    if (unsent < 0) return give_up(last_words());
    if (!PQisBusy(connection_.get())) return Status::ok();
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd socket{PQsocket(connection_.get()), POLLIN, 0};
    if (unsent > 0) socket.events |= POLLOUT;
    if (left.count() <= 0 || ::poll(&socket, 1, static_cast<int>(left.count())) == 0)
      return give_up("no answer of the database for " + std::to_string(patience_.reply.count()) +
                     " ms");
    if ((socket.revents & POLLIN) == 0) continue;
    if (!PQconsumeInput(connection_.get())) return give_up(last_words());
    deadline = steady_clock::now() + patience_.reply;
  }
}

/// Takes a statement's result, and the mark of its end where there is one.
Result<PgReply> PgConnection::next_result() {
  RETURN_IF_ERROR(wait_for_result());
  PGresult* result = PQgetResult(connection_.get());
  if (!result) return give_up("the database sent less than was asked for");
  PgReply reply(result);
  const ExecStatusType status = PQresultStatus(result);
  if (status == PGRES_PIPELINE_SYNC) return reply;
  RETURN_IF_ERROR(wait_for_result());
  PQclear(PQgetResult(connection_.get()));  // null
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK) return reply;
  if (PQstatus(connection_.get()) == CONNECTION_BAD) return give_up(last_words());
  return failure_of(result);
}

Status PgConnection::failure_of(const pg_result* result) {
  const char* sqlstate = PQresultErrorField(result, PG_DIAG_SQLSTATE);
  heard_->sqlstate = sqlstate ? sqlstate : "";
  return pg_status(heard_->sqlstate, PQresultErrorMessage(result));
}

static Status is_closed() {
  return unavailable("journal: the connection to the database is closed");
}

Result<PgReply> PgConnection::run(const PgStatement& statement) {
  if (!is_open()) return is_closed();
  if (!send(statement)) return give_up(last_words());
  return next_result();
}

Status PgConnection::script(const char* sql) {
  if (!is_open()) return is_closed();
  if (!PQsendQuery(connection_.get(), sql)) return give_up(last_words());
  Status first;
  for (;;) {
    RETURN_IF_ERROR(wait_for_result());
    PGresult* result = PQgetResult(connection_.get());
    if (!result) return first;
    const PgReply reply(result);
    if (PQresultStatus(result) == PGRES_FATAL_ERROR && first.is_ok()) first = failure_of(result);
  }
}

PgOutcome PgConnection::transact(std::span<const PgStatement> statements) {
  if (!is_open()) return {PgOutcome::End::kRefused, is_closed(), {}};
  heard_->warning.clear();
  bool is_sent = PQenterPipelineMode(connection_.get()) && send({"BEGIN", {}});
  for (const PgStatement& statement : statements) is_sent = is_sent && send(statement);
  is_sent = is_sent && send({"COMMIT", {}}) && PQpipelineSync(connection_.get());
  if (!is_sent) return {PgOutcome::End::kUnknown, give_up(last_words()), {}};
  PgOutcome outcome = hear_transaction(statements.size());
  if (!is_open()) return outcome;
  PQexitPipelineMode(connection_.get());
  if (outcome.end == PgOutcome::End::kRefused) (void)script("ROLLBACK");
  // It did not wait for its standby.
  if (outcome.end == PgOutcome::End::kCommitted && !heard_->warning.empty())
    return {PgOutcome::End::kUnknown, pg_status("08007", heard_->warning), {}};
  return outcome;
}

/// Takes the results of BEGIN, the statements, COMMIT and the end of the pipeline.
PgOutcome PgConnection::hear_transaction(size_t statements) {
  PgOutcome outcome;
  for (size_t i = 0; i < statements + 3; ++i) {
    auto reply = next_result();
    if (reply.is_ok()) {
      if (i > 0 && i <= statements) outcome.replies.push_back(std::move(*reply));
      continue;
    }
    if (outcome.end == PgOutcome::End::kCommitted) {
      const bool is_sure = is_open() && (i <= statements || is_sure_refusal(heard_->sqlstate));
      outcome = {is_sure ? PgOutcome::End::kRefused : PgOutcome::End::kUnknown, reply.status(), {}};
    }
    if (!is_open()) return outcome;
  }
  return outcome;
}

}  // namespace burnish
