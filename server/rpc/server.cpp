#include "server/rpc/server.h"

#include <thread>

#include <grpc/grpc.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>

#include "server/rpc/admission/admission.h"
#include "server/rpc/admission/credentials.h"
#include "server/rpc/admission/cut_off_calls.h"
#include "server/rpc/calls/editing_service.h"
#include "server/rpc/calls/library_service.h"
#include "server/rpc/transport/to_grpc.h"
#include "server/trust/role.h"
#include "server/trust/secret.h"
#include "server/web/web_gateway.h"

namespace burnish {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

static constexpr int kReceiveBytesMax = 16 << 20;
static constexpr size_t kTransportBytesMax = size_t{512} << 20;  // buffers of all connections
static constexpr int kStreamsPerConnectionMax = 64;
static constexpr int kReflectionThreadsMax = 8;  // gRPC's own; each stream of any client holds one
static constexpr int kHandshakeTimeMsMax = 10'000;
static constexpr int kConnectionIdleMsMax = 300'000;  // without a call; clients reconnect
static constexpr int kKeepaliveTimeMs = 30'000;
static constexpr int kKeepaliveTimeoutMs = 10'000;
static constexpr int kPingIntervalMsMin = 10'000;
static constexpr auto kDrainPoll = milliseconds(10);

struct Server::State {
  State(const ServerOptions& options, MeshStore& store, SessionManager& sessions,
        LiveSessions& live_sessions, Pools& pools)
      : guard(std::make_shared<Guard>(options.users)),
        call_guard(*guard, options.streams_per_user),
        live(live_sessions),
        calls{store, sessions, live, CallExecutor(pools), call_guard, options.upload_silence_max},
        library(calls),
        editing(calls),
        acceptor(options.connections) {}

  const std::shared_ptr<Guard> guard;
  CallGuard call_guard;
  std::shared_ptr<CallCounts> counts = std::make_shared<CallCounts>();
  CutOffCalls cut_off;
  LiveSessions& live;
  const CallContext calls;
  LibraryService library;
  EditingService editing;
  std::unique_ptr<grpc::Server> server;
  std::unique_ptr<WebGateway> web;  // after the server: its channel goes first
  ConnectionAcceptor acceptor;
  std::string web_address;
  std::string address;
  int port = 0;
};

static void set_limits(grpc::ServerBuilder& builder) {
  grpc::ResourceQuota quota("burnish");
  quota.Resize(kTransportBytesMax);
  quota.SetMaxThreads(kReflectionThreadsMax);
  // gRPC unpacks a message before it checks its size: 3 MB on the wire would be 3 GB in memory.
  // Burnish's clients do not compress.
  for (const auto packed : {GRPC_COMPRESS_DEFLATE, GRPC_COMPRESS_GZIP})
    builder.SetCompressionAlgorithmSupportStatus(packed, false);
  builder.SetResourceQuota(quota);
  builder.SetMaxReceiveMessageSize(kReceiveBytesMax);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, kStreamsPerConnectionMax);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONNECTION_IDLE_MS, kConnectionIdleMsMax);
  builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, kHandshakeTimeMsMax);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, kKeepaliveTimeMs);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMs);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS,
                             kPingIntervalMsMin);
}

static void observe_calls(grpc::ServerBuilder& builder, const std::shared_ptr<CallCounts>& counts,
                          const std::string& gateway_secret, ConnectionAcceptor& acceptor) {
  std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> observers;
  observers.push_back(std::make_unique<CallObserverFactory>(
      counts, gateway_secret, [&acceptor](const std::string& peer) { acceptor.note_call(peer); }));
  builder.experimental().SetInterceptorCreators(std::move(observers));
}

// Keeps gRPC alive. gRPC 1.51 shuts down with its last object, and may then wait ten seconds for an
// endpoint that it takes for a living one, long after the last call. The process ends anyway.
static void keep_grpc() {
  [[maybe_unused]] static const bool kept = (grpc_init(), true);
}

/// The web gateway's calls stay in the process, and so do its limits: gRPC's own client has none
/// here.
static std::shared_ptr<grpc::Channel> in_process_channel(grpc::Server& server) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);
  arguments.SetMaxSendMessageSize(-1);
  return server.InProcessChannel(arguments);
}

static auto admission_of_gateway(std::shared_ptr<const Admission> admission,
                                 ConnectionAcceptor& acceptor) {
  return [admission = std::move(admission), &acceptor](
             const std::string& method, const Proof& proof, const std::string& peer) {
    const Status admitted = admission->admit(method, proof, peer);
    if (admitted.is_ok() && !is_open_to_all(method)) acceptor.note_call(peer);
    return to_grpc(admitted);
  };
}

Result<std::unique_ptr<Server>> Server::start(const ServerOptions& options, MeshStore& store,
                                              SessionManager& sessions, LiveSessions& live,
                                              Pools& pools) {
  adopt_grpc_log();
  keep_grpc();
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  auto state = std::make_unique<State>(options, store, sessions, live, pools);
  const auto admission = std::make_shared<const Admission>(state->guard, state->counts);
  grpc::ServerBuilder builder;
  const auto open_way_in = [&](ListeningSocket socket,
                               std::shared_ptr<grpc::ServerCredentials> how) {
    if (state->address.empty()) state->address = socket.address();
    state->port = std::max(state->port, socket.port());
    std::shared_ptr receiver = builder.experimental().AddExternalConnectionAcceptor(
        grpc::ServerBuilder::experimental_type::ExternalConnectionType::FROM_FD, std::move(how));
    state->acceptor.add(std::move(socket), [receiver = std::move(receiver)](
                                               int listening_fd, int fd, const std::string&) {
      grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters connection;
      connection.listener_fd = listening_fd;
      connection.fd = fd;
      receiver->HandleNewConnection(&connection);
    });
  };
  if (!options.listen.empty()) {
    ASSIGN_OR_RETURN(ListeningSocket socket, ListeningSocket::tcp(options.listen));
    open_way_in(
        std::move(socket),
        options.certificates
            ? tls_credentials(*options.certificates, options.client_certificate_required, admission)
            : plaintext_credentials(admission));
  }
  if (!options.socket.empty()) {
    ASSIGN_OR_RETURN(
        ListeningSocket socket,
        ListeningSocket::unix_domain(
            options.socket, options.socket_user_only ? SocketAccess::kUser : SocketAccess::kGroup));
    open_way_in(std::move(socket), plaintext_credentials(admission));
  }
  set_limits(builder);
  const std::string gateway_secret = make_secret();
  observe_calls(builder, state->counts, gateway_secret, state->acceptor);
  builder.RegisterService(&state->library);
  builder.RegisterService(&state->editing);
  state->server = builder.BuildAndStart();
  if (!state->server) return internal_error("gRPC cannot start a server; its log says why");
  std::unique_ptr<Server> server(new Server(std::move(state)));
  if (!options.web.empty()) {
    RETURN_IF_ERROR(server->open_web(
        options, {in_process_channel(*server->state_->server),
                  admission_of_gateway(admission, server->state_->acceptor), gateway_secret}));
  }
  server->set_serving(true);
  server->state_->acceptor.start();
  return server;
}

Status Server::open_web(const ServerOptions& options, WebCalls calls) {
  ASSIGN_OR_RETURN(ListeningSocket socket, ListeningSocket::tcp(options.web));
  state_->web_address = (options.certificates ? "https://" : "http://") + socket.address();
  WebGatewayOptions web{options.web_hosts, options.certificates,
                        options.client_certificate_required};
  web.hosts.push_back(options.web.substr(0, options.web.rfind(':')));
  state_->web = std::make_unique<WebGateway>(std::move(web), std::move(calls));
  state_->acceptor.add(
      std::move(socket),
      [&gateway = *state_->web](int, int fd, const std::string& peer) { gateway.take(fd, peer); },
      ConnectionAcceptor::Silence::kReceiver);
  return Status::ok();
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() {
  drain(milliseconds(0));
}

const std::string& Server::address() const {
  return state_->address;
}
int Server::port() const {
  return state_->port;
}
const std::string& Server::web_address() const {
  return state_->web_address;
}

size_t Server::web_connections() const {
  return state_->web ? state_->web->connections() : 0;
}

void Server::set_serving(bool serving) {
  grpc::HealthCheckServiceInterface* health = state_->server->GetHealthCheckService();
  for (const char* service : {v1::Library::service_full_name(), v1::Editing::service_full_name()})
    health->SetServingStatus(service, serving);
  health->SetServingStatus(serving);
}

int64_t Server::running_calls() const {
  return state_->counts->running;
}

bool Server::is_in_use() const {
  return running_calls() > 0 || state_->acceptor.open_connections() > 0;
}

uint64_t Server::take_cut_off_calls() {
  const uint64_t started = state_->counts->started;  // read first: it never overtakes the other
  return state_->cut_off.add(state_->counts->arrived - started);
}

void Server::drain(milliseconds time, Successors successors) {
  set_serving(false);
  state_->guard->close();
  state_->live.drain(std::move(successors));
  if (state_->web) state_->web->leave();
  // Probes still get an answer meanwhile: NOT_SERVING.
  const auto deadline = steady_clock::now() + time;
  while (running_calls() > 0 && steady_clock::now() < deadline)
    std::this_thread::sleep_for(kDrainPoll);
  state_->acceptor.stop();
  state_->server->Shutdown(std::chrono::system_clock::now());
  state_->server->Wait();
  if (state_->web) state_->web->close();
}

}  // namespace burnish
