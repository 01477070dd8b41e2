#pragma once

#include <cstdint>
#include <mutex>
#include <shared_mutex>
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

/// Where a listener is found for as long as it is there. It outlives those that speak to it: the
/// journal may tell of a commit when sessions are gone. Thread-safe.
class ListenerSlot {
 public:
  /// Null takes the last one out; when this returns, nobody speaks to that one any more.
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
