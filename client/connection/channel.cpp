#include "client/connection/channel.h"

#include <cerrno>
#include <climits>
#include <fstream>
#include <sstream>

#include <grpc/support/log.h>
#include <grpcpp/support/client_interceptor.h>

namespace burnish {
namespace {

using grpc::experimental::InterceptionHookPoints;

constexpr int kReceiveBytesMax = 64 << 20;  // a key frame of a very large scan
constexpr int kKeepaliveTimeMs = 20'000;
constexpr int kKeepaliveTimeoutMs = 10'000;

/// Adds the token to a call's headers. gRPC's own call credentials refuse plaintext, where a token
/// is right on loopback and on Unix sockets.
class TokenSender final : public grpc::experimental::Interceptor {
 public:
  explicit TokenSender(const std::string& header) : header_(header) {}

  void Intercept(grpc::experimental::InterceptorBatchMethods* batch) override {
    if (batch->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_INITIAL_METADATA))
      batch->GetSendInitialMetadata()->emplace("authorization", header_);
    batch->Proceed();
  }

 private:
  const std::string& header_;
};

class TokenSenderFactory final : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit TokenSenderFactory(const std::string& token) : header_("Bearer " + token) {}

  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo*) override {
    return new TokenSender(header_);
  }

 private:
  const std::string header_;
};

Result<std::string> read_pem(const std::filesystem::path& path) {
  if (path.empty()) return std::string();
  std::ifstream file(path);
  if (!file) return errno_status("cannot read " + path.string(), errno);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool uses_tls(const ConnectionTrust& trust) {
  return trust.tls || !trust.ca.empty() || !trust.certificate.empty();
}

bool is_of_this_machine(const std::string& server) {
  return server.starts_with("unix:") || server.starts_with("localhost:") ||
         server.starts_with("127.") || server.starts_with("[::1]:");
}

Status check(const std::string& server, const ConnectionTrust& trust) {
  if (trust.certificate.empty() != trust.key.empty())
    return invalid_argument("a client's certificate and its key go together: give both or neither");
  if (trust.token.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                    "-._~+/=") != std::string::npos)
    return invalid_argument("the token has characters other than letters, digits and -._~+/=");
  if (trust.token.empty() || trust.insecure || uses_tls(trust) || is_of_this_machine(server))
    return Status::ok();
  return failed_precondition("the token would travel to " + server +
                             " in plain text; use TLS, or say --insecure if that is meant");
}

Result<std::shared_ptr<grpc::ChannelCredentials>> make_credentials(const ConnectionTrust& trust) {
  if (!uses_tls(trust)) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions options;
  ASSIGN_OR_RETURN(options.pem_root_certs, read_pem(trust.ca));
  ASSIGN_OR_RETURN(options.pem_cert_chain, read_pem(trust.certificate));
  ASSIGN_OR_RETURN(options.pem_private_key, read_pem(trust.key));
  return grpc::SslCredentials(options);
}

grpc::ChannelArguments channel_arguments(Sharing sharing) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(kReceiveBytesMax);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, kKeepaliveTimeMs);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMs);
  arguments.SetInt(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
  // A web proxy of the environment knows nothing of this server.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  // A server that ends without users must see that we are there.
  arguments.SetInt(GRPC_ARG_CLIENT_IDLE_TIMEOUT_MS, INT_MAX);
  if (sharing == Sharing::kOwn) arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return arguments;
}

}  // namespace

std::string grpc_target(const std::string& server) {
  static constexpr std::string_view kScheme = "unix:", kHex = "0123456789ABCDEF";
  static constexpr std::string_view kAsTheyAre =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  if (!server.starts_with(kScheme)) return server;
  std::string target(kScheme);
  for (const char c : std::string_view(server).substr(kScheme.size())) {
    const auto byte = static_cast<unsigned char>(c);
    if (kAsTheyAre.find(c) != std::string_view::npos) {
      target += c;
    } else {
      target += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return target;
}

bool wait_until_ready(grpc::Channel& channel, std::chrono::milliseconds timeout) {
  const auto deadline = std::chrono::system_clock::now() + timeout;
  for (;;) {
    const grpc_connectivity_state state = channel.GetState(true);
    if (state == GRPC_CHANNEL_READY) return true;
    if (state == GRPC_CHANNEL_TRANSIENT_FAILURE || state == GRPC_CHANNEL_SHUTDOWN) return false;
    if (!channel.WaitForStateChange(state, deadline)) return false;
  }
}

void connect_again(grpc::Channel& channel, std::chrono::milliseconds timeout) {
  grpc::experimental::ChannelResetConnectionBackoff(&channel);
  channel.WaitForConnected(std::chrono::system_clock::now() + timeout);
}

Result<std::shared_ptr<grpc::Channel>> make_channel(const std::string& server,
                                                    const ConnectionTrust& trust, Sharing sharing) {
  gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR);
  gpr_set_log_function([](gpr_log_func_args*) {});  // what fails comes back as a Status
  RETURN_IF_ERROR(check(server, trust));
  ASSIGN_OR_RETURN(const auto credentials, make_credentials(trust));
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> senders;
  if (!trust.token.empty()) senders.push_back(std::make_unique<TokenSenderFactory>(trust.token));
  return grpc::experimental::CreateCustomChannelWithInterceptors(
      grpc_target(server), credentials, channel_arguments(sharing), std::move(senders));
}

}  // namespace burnish
