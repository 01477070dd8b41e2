#include "server/rpc/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>

#include "server/rpc/editing_service.h"
#include "server/rpc/library_service.h"

namespace burnish {

static constexpr int kReceiveBytesMax = 16 << 20;
static constexpr size_t kTransportBytesMax = size_t{512} << 20;  // buffers of all connections
static constexpr int kStreamsPerConnectionMax = 64;
static constexpr int kKeepaliveTimeMs = 30'000;
static constexpr int kKeepaliveTimeoutMs = 10'000;
static constexpr int kPingIntervalMsMin = 10'000;

struct Server::State {
  explicit State(const CallContext& calls) : library(calls), editing(calls) {}

  LibraryService library;
  EditingService editing;
  std::unique_ptr<grpc::Server> server;
  std::string address;
  int port = 0;
};

static void set_limits(grpc::ServerBuilder& builder) {
  grpc::ResourceQuota quota("burnish");
  quota.Resize(kTransportBytesMax);
  builder.SetResourceQuota(quota);
  builder.SetMaxReceiveMessageSize(kReceiveBytesMax);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, kStreamsPerConnectionMax);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, kKeepaliveTimeMs);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMs);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS,
                             kPingIntervalMsMin);
  // A second server on the same port must fail, not share it.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
}

static void set_serving(grpc::Server& server, bool serving) {
  grpc::HealthCheckServiceInterface* health = server.GetHealthCheckService();
  for (const char* service : {v1::Library::service_full_name(), v1::Editing::service_full_name()})
    health->SetServingStatus(service, serving);
  health->SetServingStatus(serving);
}

Result<std::unique_ptr<Server>> Server::start(const std::string& listen, MeshStore& store,
                                              SessionManager& sessions, Executor& executor) {
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  auto state = std::make_unique<State>(CallContext{store, sessions, executor});
  grpc::ServerBuilder builder;
  set_limits(builder);
  builder.AddListeningPort(listen, grpc::InsecureServerCredentials(), &state->port);
  builder.RegisterService(&state->library);
  builder.RegisterService(&state->editing);
  state->server = builder.BuildAndStart();
  if (!state->server || state->port == 0)
    return unavailable("cannot listen on " + listen + ": the address is in use or not ours");
  state->address = listen.substr(0, listen.rfind(':') + 1) + std::to_string(state->port);
  set_serving(*state->server, true);
  return std::unique_ptr<Server>(new Server(std::move(state)));
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() {
  if (state_) drain(std::chrono::milliseconds(0));
}

const std::string& Server::address() const {
  return state_->address;
}
int Server::port() const {
  return state_->port;
}

void Server::drain(std::chrono::milliseconds time) {
  set_serving(*state_->server, false);
  state_->server->Shutdown(std::chrono::system_clock::now() + time);
  state_->server->Wait();
}

}  // namespace burnish
