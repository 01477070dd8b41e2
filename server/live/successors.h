#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/base/server_place.h"

namespace burnish {

/// The servers that take the sessions of a server that ends. Each session goes to the one that has
/// the most memory left when the earlier ones are there.
class Successors {
 public:
  struct Server {
    ServerPlace place;
    uint64_t bytes_free = 0;
  };

  Successors() = default;
  explicit Successors(std::vector<Server> servers) : servers_(std::move(servers)) {}

  /// Returns the server for a session of so many bytes; nothing if there is no server at all. One
  /// without memory for it names another one itself.
  std::optional<ServerPlace> next(uint64_t bytes);

 private:
  std::vector<Server> servers_;
};

}  // namespace burnish
