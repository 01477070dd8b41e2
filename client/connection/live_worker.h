#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "client/connection/live_stream.h"
#include "client/connection/session_link.h"
#include "client/live/live_conversation.h"

namespace burnish {

/// The thread behind a SessionLink. It carries the messages of a conversation over gRPC.
class SessionLink::Worker {
 public:
  /// `starter` may be empty.
  Worker(const std::shared_ptr<ServerRoute>& route, const ConnectionTrust& trust,
         const std::string& user, Connection::Starter starter, LiveOptions options);
  ~Worker();

  LiveConversation& conversation() { return conversation_; }
  /// The conversation may have something to say.
  void wake() { wakeup_->wake(); }
  bool wait_until_acknowledged(std::chrono::milliseconds patience);

 private:
  void run();
  Status start_server();
  Status converse();
  void speak_and_listen(LiveStream& stream);
  void wait_before_retry(std::chrono::milliseconds time);
  void tell_user();
  bool is_stopping();

  const std::shared_ptr<ServerRoute> route_;
  const ConnectionTrust trust_;
  const std::string user_;
  const Connection::Starter starter_;
  const Clock clock_;
  const std::function<void()> on_news_;
  const std::shared_ptr<Wakeup> wakeup_ = std::make_shared<Wakeup>();
  LiveConversation conversation_;

  std::mutex mutex_;  // of what follows
  std::condition_variable heard_;
  bool stopping_ = false;

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace burnish
