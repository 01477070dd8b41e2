#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Whoever shows sessions to clients. Called while their locks are held: must be short, and must
/// not touch a session.
class SessionListener {
 public:
  virtual ~SessionListener() = default;

  /// Edits were applied, or have to be forgotten, or somebody got another role.
  virtual void on_session_changed(const std::string& id) = 0;

  /// An owner closed the session, or deleted it: whoever is in it is to go, and hears why.
  virtual void on_session_left(const std::string& id, const Status& why) = 0;

  /// What is held for the session's clients.
  virtual uint64_t client_bytes(const std::string& id) const = 0;
};

}  // namespace burnish
