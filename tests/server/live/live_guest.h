#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "common/frame_codec/frame_decoder.h"
#include "server/live/live_sessions.h"

namespace burnish {

/// A client of a live session in this process. If the sessions have no solver threads, its session
/// works only while the guest waits, by turns that the guest takes.
class LiveGuest {
 public:
  /// `wiring`: all but on_message and on_dead.
  LiveGuest(LiveSessions& sessions, const Greeting& greeting, const Caller& caller,
            SubscriberWiring wiring = {});
  ~LiveGuest() { leave(); }
  void leave();

  Subscriber& subscriber() { return *client_.subscriber; }
  LiveSession& session() { return *client_.session; }
  uint64_t connection() { return subscriber().connection; }

  /// Takes the waiting messages.
  void take_all();

  /// Takes turns and messages until nothing more comes.
  void run();

  /// Does run(), grants credits and acknowledges every frame, until the surface is settled.
  void settle();

  void edit(std::vector<Edit> edits) { session().edit(connection(), std::move(edits), 0); }

  template <typename Message>
  std::vector<Message> all() const {
    std::vector<Message> found;
    for (const ServerMessage& message : received)
      if (const auto* wanted = std::get_if<Message>(&message)) found.push_back(*wanted);
    return found;
  }

  std::vector<ServerMessage> received;
  std::vector<uint64_t> decoded;  ///< sequence numbers not yet acknowledged
  bool finished = false;

 private:
  struct Bell;
  LiveGuest(LiveSessions& sessions, const Greeting& greeting, const Caller& caller,
            SubscriberWiring wiring, std::shared_ptr<Bell> bell);
  LiveSessions& sessions_;
  std::shared_ptr<Bell> bell_;
  LiveClient client_;

 public:
  const SessionRole role;
  FrameDecoder decoder;
};

}  // namespace burnish
