#pragma once

#include <atomic>
#include <utility>

#include <grpcpp/grpcpp.h>

#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"
#include "server/scheduling/scheduler.h"

namespace burnish {

/// A call that answers one request with events. It runs `Status Call::run()` in its pool and ends
/// with that Status, unless the call has a begin() of its own.
template <typename Call, typename Request, typename Event>
class EventCall : public grpc::ServerWriteReactor<Event>, public SelfOwned<Call> {
 public:
  EventCall(const CallContext& calls, const Request& request)
      : calls_(calls),
        request_(request),
        events_([this](const Event* event) { this->StartWrite(event); },
                [this](grpc::Status status) { this->Finish(std::move(status)); }) {}

  void begin() {
    post([](Call& call) { call.end(call.run()); });
  }

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { this->release(); }

 protected:
  /// Runs `work(call)` in the call's pool, or in the other one.
  template <typename Work>
  void post(Work work) {
    calls_.executor.post([call = this->self(), work] { work(*call); }, failing());
  }
  template <typename Work>
  void post(Pool pool, Work work) {
    calls_.executor.post(
        pool, [call = this->self(), work] { work(*call); }, failing());
  }

  void end(const Status& status) { events_.close(to_grpc(status)); }

  /// Tells the client how far the work is, and lets live sessions go first.
  Progress progress() {
    return give_way_to(calls_.live.scheduler(), [this](std::string_view phase, double fraction) {
      events_.report(phase, fraction);
      return !cancelled_;
    });
  }
  /// Only stops the work when the client is gone.
  Progress silent_progress() {
    return [this](std::string_view, double) { return !cancelled_; };
  }

  const CallContext calls_;
  const Request request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<Event> events_;

 private:
  auto failing() {
    return [call = this->self()](const Status& status) { call->end(status); };
  }
};

}  // namespace burnish
