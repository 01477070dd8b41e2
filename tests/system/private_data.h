#pragma once

#include <sys/types.h>

#include "client/model/local_server/private_server.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

/// The data folder of a private server, in a folder that all users can enter. The destructor kills
/// the server.
class PrivateData {
 public:
  PrivateData();
  ~PrivateData();

  /// Returns the process that listens on the socket; 0: none.
  pid_t server() const;
  /// Sends SIGKILL and waits until no process listens.
  void kill_server() const;

  TemporaryFolder folder;
  PrivateServerOptions options{.data = folder / "data"};
};

}  // namespace burnish
