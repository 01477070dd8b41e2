#pragma once

#include <sys/types.h>

#include "client/model/private_server.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

/// The data folder of a private server, in a folder that everybody can enter. The server is killed
/// with it.
class PrivateData {
 public:
  PrivateData();
  ~PrivateData();

  /// The process that listens on the socket; 0: none.
  pid_t server() const;
  /// SIGKILL, and waits until nobody listens.
  void kill_server() const;

  TemporaryFolder folder;
  PrivateServerOptions options{.data = folder / "data"};
};

}  // namespace burnish
