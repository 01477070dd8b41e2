#pragma once

#include <memory>
#include <string>

#include <grpcpp/grpcpp.h>

#include "common/base/check.h"

namespace burnish {

/// Serves on a port of this machine; 0 takes any free one. Sets the port.
inline std::unique_ptr<grpc::Server> serve_fake(grpc::Service& service, int& port) {
  grpc::ServerBuilder builder;
  int taken = 0;
  builder.AddListeningPort("127.0.0.1:" + std::to_string(port), grpc::InsecureServerCredentials(),
                           &taken);
  builder.RegisterService(&service);
  auto server = builder.BuildAndStart();
  BURNISH_CHECK(server && taken > 0, "the fake has its port");
  port = taken;
  return server;
}

}  // namespace burnish
