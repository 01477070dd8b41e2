// client/connection/channel.h where the worker has the only way to the only server.

#include "client/connection/channel.h"

namespace burnish {

Result<std::shared_ptr<grpc::Channel>> make_channel(const std::string&, const ConnectionTrust&,
                                                    Sharing) {
  return std::make_shared<grpc::Channel>();
}

bool wait_until_ready(grpc::Channel&, std::chrono::milliseconds) {
  return true;  // the first call tells
}

void connect_again(grpc::Channel&, std::chrono::milliseconds) {}

}  // namespace burnish
