#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/live/live_sessions.h"
#include "tests/server/live/guest_pages.h"

namespace burnish {

/// A client of a live session in this process. If the sessions have no solver threads, its session
/// works only while the guest waits, by turns that the guest takes.
class LiveGuest {
 public:
  /// `wiring`: all but on_message and on_dead.
  LiveGuest(LiveSessions& sessions, MeshStore& store, const Greeting& greeting,
            const Caller& caller, SubscriberWiring wiring = {});
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

  /// Shows and hides pages from the next frames on.
  void show(const std::vector<PageId>& added, const std::vector<PageId>& removed = {});

  /// Shows all pages of a level; 0 is the scan itself.
  void show_level(int level);

  void edit(std::vector<Edit> edits) { session().edit(connection(), std::move(edits), 0); }

  template <typename Message>
  std::vector<Message> all() const {
    std::vector<Message> found;
    for (const ServerMessage& message : received)
      if (const auto* wanted = std::get_if<Message>(&message)) found.push_back(*wanted);
    return found;
  }

  std::vector<ServerMessage> received;
  std::vector<uint64_t> decoded;         ///< sequence numbers not yet acknowledged
  std::vector<DecodedPageFrame> frames;  ///< those with data
  bool finished = false;

 private:
  struct Bell;
  LiveGuest(LiveSessions& sessions, MeshStore& store, const Greeting& greeting,
            const Caller& caller, SubscriberWiring wiring, std::shared_ptr<Bell> bell);
  LiveSessions& sessions_;
  std::shared_ptr<Bell> bell_;
  LiveClient client_;

 public:
  const Welcome welcome;
  GuestPages pages;
};

}  // namespace burnish
