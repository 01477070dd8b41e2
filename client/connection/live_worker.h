#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "client/connection/credit_pacer.h"
#include "client/connection/frame_budget.h"
#include "client/connection/frame_receiver.h"
#include "client/connection/live_outbox.h"
#include "client/connection/live_stream.h"
#include "client/connection/rate_meter.h"
#include "client/connection/session_link.h"
#include "client/connection/shown_edits.h"

namespace burnish {

/// The thread behind a SessionLink. It alone talks to the stream and decodes frames; callers leave
/// what they want under the lock, and take what is new from there.
class SessionLink::Worker {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `starter` may be empty.
  Worker(const std::string& server, const ConnectionTrust& trust, const std::string& user,
         Connection::Starter starter, LiveOptions options);
  ~Worker();

  Status apply(std::vector<Edit> edits);
  void preview(const std::string& edit_id, PreviewChange change);
  void drop_preview(const std::string& edit_id);
  void move_brush(const std::optional<BrushRing>& ring);
  Status show_pages(const std::vector<std::shared_ptr<const Page>>& added,
                    const std::vector<PageId>& removed);
  LiveNews take();
  bool wait_until_acknowledged(std::chrono::milliseconds patience);

 private:
  void run();
  Status start_server();
  Status converse();
  Status speak_and_listen(LiveStream& stream);
  bool must_leave(Time now);
  void wait_before_retry(int failures);
  void set_link(LinkState state, const std::string& reason);

  // What is said.
  std::optional<ClientMessage> next_message(Time now);
  Status prepare_to_say(const ClientMessage& message);
  Heartbeat heartbeat(Time now);
  Time next_deadline();

  // What is heard (live_worker_messages.cpp). An error ends the session.
  Status hear(v1::ServerMessage message);
  Status hear(ProgressReport& report);
  Status hear(Welcome& welcome);
  Status hear(const LiveFrame& frame);
  Status hear(EditsAcknowledged& answer);
  Status hear(EditsRefused& answer);
  Status hear(HistoryState& history);
  Status hear(SessionPeople& people);
  Status hear(const Heartbeat& echo);
  Status hear(const Farewell& farewell);

  void tell(LiveEvent event);  // needs the lock
  void tell_shown();           // needs the lock
  void wake_user();

  const std::string server_;
  const ConnectionTrust trust_;
  const std::string user_;
  const Connection::Starter starter_;
  const LiveOptions options_;
  const std::shared_ptr<Wakeup> wakeup_ = std::make_shared<Wakeup>();

  // Of the thread alone.
  FrameReceiver receiver_;
  std::vector<std::shared_ptr<const Page>> added_pages_;  // of the next message, if it adds pages
  Time last_heard_;
  Time next_heartbeat_;
  bool leaving_ = false;  // the stream is to end: it is silent, or has said farewell
  std::string farewell_;
  bool beat_for_credit_ = false;

  std::mutex mutex_;  // of what follows
  std::condition_variable acknowledged_;
  LiveOutbox outbox_;
  CreditPacer pacer_;
  FrameBudget budget_;
  ShownEdits shown_;
  RateMeter rate_;
  LiveNews news_;
  Time last_decoded_;
  bool has_new_frame_ = false;
  bool stopping_ = false;

  std::thread thread_;  // last: it uses all of the above
};

}  // namespace burnish
