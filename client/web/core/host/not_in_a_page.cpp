// Says that a page lacks two things: a server of its own, and files that are shown before a server
// has them.

#include "client/model/local_server/private_server.h"
#include "client/model/workspace/workspace.h"

namespace burnish {

Result<std::string> find_private_server(const PrivateServerOptions&, const Progress&) {
  return failed_precondition(
      "a page has the server that it comes from, and is not connected to it");
}

uint64_t private_server_memory_bytes() {
  return 0;
}

bool can_be_raw(const std::filesystem::path&) {
  return false;
}

void Workspace::show_raw_and_import(const std::filesystem::path&, Opening) {}

bool Workspace::begins_again() {
  return false;
}

}  // namespace burnish
