#pragma once

#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Shows sessions to clients. Calls come while sessions' locks are held: they must be short, and
/// must not touch a session.
class SessionListener {
 public:
  virtual ~SessionListener() = default;

  /// Edits were applied or must be forgotten, or somebody got another role.
  virtual void on_session_changed(const std::string& id) = 0;

  /// An owner closed or deleted the session: everybody in it must leave, and is told why.
  virtual void on_session_left(const std::string& id, const Status& why) = 0;

  /// The session has left memory, and nobody knows whether its last edits are on disk: everybody
  /// must come back, and send again what is not answered.
  virtual void on_session_lost(const std::string& id, const Status& why) = 0;

  /// Another server may have the session: everybody must leave at once, and send there what is not
  /// answered. `why` names the server if it is known.
  virtual void on_session_moved(const std::string& id, const Status& why) = 0;

  /// Returns the bytes held for the session's clients.
  virtual uint64_t client_bytes(const std::string& id) const = 0;
};

/// Keeps the listener while there is one. It outlives its callers: the journal may report a commit
/// when sessions are gone. Thread-safe.
class ListenerSlot {
 public:
  /// Null removes the listener. After the return nobody calls the old one.
  void set(SessionListener* listener) {
    const std::unique_lock lock(mutex_);
    listener_ = listener;
  }

  template <typename Tell>
  void tell(const Tell& tell) const {
    const std::shared_lock lock(mutex_);
    if (listener_) tell(*listener_);
  }

 private:
  mutable std::shared_mutex mutex_;
  SessionListener* listener_ = nullptr;
};

}  // namespace burnish
