#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <sys/types.h>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

/// A burnish-server on a loopback port for this user alone. It ends with the object.
class PrivateServer {
 public:
  /// Starts the burnish-server beside this program on this folder, or takes the one of another
  /// window that uses it.
  /// Fails: not_found (no such program); unavailable (it ended, with what it said last); cancelled.
  static Result<std::unique_ptr<PrivateServer>> start(const std::filesystem::path& data,
                                                      const Progress& progress);
  ~PrivateServer();
  PrivateServer(const PrivateServer&) = delete;
  PrivateServer& operator=(const PrivateServer&) = delete;

  const std::string& address() const { return address_; }

 private:
  PrivateServer(pid_t pid, std::string address) : pid_(pid), address_(std::move(address)) {}

  pid_t pid_;
  std::string address_;
};

}  // namespace burnish
