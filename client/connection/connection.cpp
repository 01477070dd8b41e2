#include "client/connection/connection.h"

#include "client/connection/channel.h"
#include "client/connection/event_stream.h"
#include "common/base/text.h"
#include "common/wire/library_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

/// Why the channel cannot connect: only a call that fails for it is told.
static std::string reason_of_failure(v1::Library::Stub& library) {
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(1));
  v1::ListScansResponse response;
  return library.ListScans(&context, v1::ListScansRequest(), &response).error_message();
}

Result<Connection> Connection::open(const std::string& server, std::chrono::milliseconds timeout,
                                    const ConnectionTrust& trust) {
  ASSIGN_OR_RETURN(auto channel, make_channel(server, trust));
  auto state = std::make_unique<State>();
  state->library = v1::Library::NewStub(channel);
  const auto begin = std::chrono::steady_clock::now();
  if (!wait_until_ready(*channel, timeout)) {
    const bool is_silent = std::chrono::steady_clock::now() - begin >= timeout;
    return unavailable("cannot reach server " + server +
                       (is_silent ? " within " + seconds_text(timeout) : "") + ": " +
                       no_link_words(reason_of_failure(*state->library)));
  }
  state->server = server;
  state->route = std::make_shared<ServerRoute>(server);
  state->trust = trust;
  state->timeout = timeout;
  state->editing = v1::Editing::NewStub(channel);
  state->channel = std::move(channel);
  return Connection(std::move(state));
}

Connection::Connection(std::unique_ptr<State> state) : state_(std::move(state)) {}
Connection::Connection(Connection&&) noexcept = default;
Connection::~Connection() = default;

const std::string& Connection::server() const {
  return state_->server;
}

const std::shared_ptr<ServerRoute>& Connection::route() const {
  return state_->route;
}

void Connection::set_user(std::string user) {
  state_->user = std::move(user);
}

const std::string& Connection::user() const {
  return state_->user;
}

// The first server's channel serves sessions too, as long as they are there.
Result<std::shared_ptr<const ReachedServer>> Connection::State::reach() {
  const ServerPlace place = route->place();
  const std::lock_guard lock(mutex);
  if (reached && reached->place == place) return reached;
  auto way = channel;
  if (place.address != server) {
    ASSIGN_OR_RETURN(way, make_channel(place.address, trust));
  }
  reached = std::make_shared<ReachedServer>(
      ReachedServer{place, way, v1::Editing::NewStub(way), v1::Library::NewStub(way)});
  return reached;
}

// The first server says who has the session. As long as the lease of a killed server lives, that is
// the killed one.
bool Connection::State::awaits_takeover(const ReachedServer& owner, const grpc::Status& ended,
                                        std::chrono::steady_clock::time_point until) {
  static constexpr std::chrono::seconds kStep{1};
  const bool has_left = ended.error_code() != grpc::StatusCode::UNAVAILABLE ||
                        ended.error_message().find("failed to connect") == std::string::npos;
  const bool is_first = owner.place.address == server;
  if (has_left || is_first || std::chrono::steady_clock::now() >= until) return false;
  connect_again(*owner.channel, kStep);
  route->move_to({server, {}});
  return true;
}

void set_node(grpc::ClientContext& context, const std::string& node) {
  if (!node.empty()) context.AddMetadata("x-burnish-node", node);
}

void Connection::set_starter(Starter starter) {
  state_->starter = std::move(starter);
}

void Connection::bring_back(const Progress& progress) {
  if (!state_->starter || !state_->starter(progress).is_ok()) return;
  // gRPC may not have seen yet that the last server's socket has no other end: a call tells it.
  static constexpr int kTriesMax = 3;
  for (int tries = 0; tries < kTriesMax; ++tries) {
    connect_again(*state_->channel, state_->timeout);
    if (list_sessions().status().code() != StatusCode::kUnavailable) return;
  }
}

Result<std::vector<ScanInfo>> Connection::list_scans() {
  grpc::ClientContext context;
  state_->set_deadline(context);
  v1::ListScansResponse response;
  RETURN_IF_ERROR(call_status(
      server(), state_->library->ListScans(&context, v1::ListScansRequest(), &response)));
  std::vector<ScanInfo> scans;
  for (const v1::ScanInfo& message : response.scans()) {
    ASSIGN_OR_RETURN(ScanInfo scan, from_wire(message));
    scans.push_back(std::move(scan));
  }
  return scans;
}

Result<ScanDescription> Connection::describe_scan(const std::string& scan, int depth) {
  grpc::ClientContext context;
  state_->set_deadline(context);
  v1::DescribeScanRequest request;
  request.set_scan(scan);
  request.set_depth(depth);
  v1::ScanDescription response;
  RETURN_IF_ERROR(
      call_status(server(), state_->library->DescribeScan(&context, request, &response)));
  return from_wire(response);
}

Result<ScanInfo> Connection::prepare_scan(const std::string& scan, const PreparedKey& key,
                                          const Progress& progress) {
  grpc::ClientContext context;
  v1::PrepareScanRequest request;
  request.set_scan(scan);
  request.set_depth(key.depth);
  request.set_curvature_radius(key.curvature_radius);
  const auto reader = state_->library->PrepareScan(&context, request);
  ASSIGN_OR_RETURN(const auto done,
                   read_until_done<v1::PrepareEvent>(server(), context, *reader, progress,
                                                     "preparing the scan"));
  return from_wire(done);
}

Result<std::string> Connection::delete_scan(const std::string& scan) {
  grpc::ClientContext context;
  state_->set_deadline(context);
  v1::DeleteScanRequest request;
  request.set_scan(scan);
  v1::DeleteScanResponse response;
  RETURN_IF_ERROR(call_status(server(), state_->library->DeleteScan(&context, request, &response)));
  return response.id();
}

Result<std::vector<SessionInfo>> Connection::list_sessions() {
  grpc::ClientContext context;
  state_->set_deadline(context);
  v1::ListSessionsResponse response;
  RETURN_IF_ERROR(call_status(
      server(), state_->editing->ListSessions(&context, v1::ListSessionsRequest(), &response)));
  std::vector<SessionInfo> sessions;
  for (const v1::SessionInfo& message : response.sessions()) {
    ASSIGN_OR_RETURN(SessionInfo session, from_wire(message));
    sessions.push_back(std::move(session));
  }
  return sessions;
}

Status Connection::close_session(const std::string& session) {
  v1::CloseSessionRequest request;
  request.set_session(session);
  v1::CloseSessionResponse response;
  return state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    state_->set_deadline(context);
    return owner.CloseSession(&context, request, &response);
  });
}

Status Connection::delete_session(const std::string& session) {
  v1::DeleteSessionRequest request;
  request.set_session(session);
  v1::DeleteSessionResponse response;
  return state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    state_->set_deadline(context);
    return owner.DeleteSession(&context, request, &response);
  });
}

}  // namespace burnish
