// Linked into every program of a ThreadSanitizer build that uses gRPC. Debian's gRPC is not
// instrumented: the tool sees neither its locks nor how its work goes from thread to thread. It
// would report all shared data as races. This file tells the tool of these orders, and of nothing
// else, so that races in Burnish's callbacks stay visible. The functions below replace those of the
// same names in the libraries, and call them.

#include <dlfcn.h>
#include <thread>

#include <absl/synchronization/mutex.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/support/client_callback.h>
#include <grpcpp/support/server_callback.h>
#include <sanitizer/tsan_interface.h>

/// Returns the library's own function of a (mangled) name.
template <typename Function>
static Function* library(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// gRPC's locks.

namespace absl {

void Mutex::Lock() {
  static const auto real = library<void(Mutex*)>("_ZN4absl7debian35Mutex4LockEv");
  real(this);
  __tsan_acquire(this);
}

bool Mutex::TryLock() {
  static const auto real = library<bool(Mutex*)>("_ZN4absl7debian35Mutex7TryLockEv");
  const bool is_locked = real(this);
  if (is_locked) __tsan_acquire(this);
  return is_locked;
}

void Mutex::Unlock() {
  static const auto real = library<void(Mutex*)>("_ZN4absl7debian35Mutex6UnlockEv");
  __tsan_release(this);
  real(this);
}

void CondVar::Wait(Mutex* mutex) {
  static const auto real =
      library<void(CondVar*, Mutex*)>("_ZN4absl7debian37CondVar4WaitEPNS0_5MutexE");
  __tsan_release(mutex);
  real(this, mutex);
  __tsan_acquire(mutex);
}

bool CondVar::WaitWithTimeout(Mutex* mutex, Duration timeout) {
  static const auto real = library<bool(CondVar*, Mutex*, Duration)>(
      "_ZN4absl7debian37CondVar15WaitWithTimeoutEPNS0_5MutexENS0_8DurationE");
  __tsan_release(mutex);
  const bool is_over = real(this, mutex, timeout);
  __tsan_acquire(mutex);
  return is_over;
}

}  // namespace absl

// From the thread that starts a batch, and from the thread that ends it, ...

extern "C" grpc_call_error grpc_call_start_batch(grpc_call* call, const grpc_op* ops, size_t count,
                                                 void* tag, void* reserved) {
  static const auto real = library<decltype(grpc_call_start_batch)>("grpc_call_start_batch");
  __tsan_release(tag);
  return real(call, ops, count, tag, reserved);
}

#define END_OP                                                         \
  "_Z14grpc_cq_end_opP21grpc_completion_queuePvN4absl7debian36StatusE" \
  "PFvS1_P18grpc_cq_completionES1_S6_b"
using EndOp = void(grpc_completion_queue* queue, void* tag, void* error, void (*done)(void*, void*),
                   void* done_of, void* storage, bool internal);
EndOp end_op __asm__(END_OP);
void end_op(grpc_completion_queue* queue, void* tag, void* error, void (*done)(void*, void*),
            void* done_of, void* storage, bool internal) {
  static const auto real = library<EndOp>(END_OP);
  __tsan_release(tag);
  real(queue, tag, error, done, done_of, storage, internal);
}

// ... to its callback.

using RunTag = void(grpc_completion_queue_functor* tag, int ok);

RunTag run_success_tag __asm__(
    "_ZN4grpc8internal22CallbackWithSuccessTag9StaticRunEP29grpc_completion_queue_functori");
void run_success_tag(grpc_completion_queue_functor* tag, int ok) {
  __tsan_acquire(tag);
  static_cast<grpc::internal::CallbackWithSuccessTag*>(tag)->force_run(ok != 0);
}

RunTag run_status_tag __asm__(
    "_ZN4grpc8internal21CallbackWithStatusTag9StaticRunEP29grpc_completion_queue_functori");
void run_status_tag(grpc_completion_queue_functor* tag, int /*ok: the status says it*/) {
  __tsan_acquire(tag);
  static_cast<grpc::internal::CallbackWithStatusTag*>(tag)->force_run(grpc::Status());
}

#define RUN_NEW_CALL(context)                    \
  "_ZN4grpc6Server15CallbackRequestINS_" context \
  "EE15CallbackCallTag9StaticRun"                \
  "EP29grpc_completion_queue_functori"

#define NEW_CALL RUN_NEW_CALL("21CallbackServerContext")
RunTag run_new_call __asm__(NEW_CALL);
void run_new_call(grpc_completion_queue_functor* tag, int ok) {
  static const auto real = library<RunTag>(NEW_CALL);
  __tsan_acquire(tag);
  real(tag, ok);
}

#define NEW_UNKNOWN_CALL RUN_NEW_CALL("28GenericCallbackServerContext")
RunTag run_new_unknown_call __asm__(NEW_UNKNOWN_CALL);
void run_new_unknown_call(grpc_completion_queue_functor* tag, int ok) {
  static const auto real = library<RunTag>(NEW_UNKNOWN_CALL);
  __tsan_acquire(tag);
  real(tag, ok);
}

// From the end of each call to the thread that waits for the server's end.

void grpc::Server::UnrefWithPossibleNotify() {
  static const auto real = library<void(Server*)>("_ZN4grpc6Server23UnrefWithPossibleNotifyEv");
  __tsan_release(this);
  real(this);
}

void grpc::Server::Wait() {
  static const auto real = library<void(Server*)>("_ZN4grpc6Server4WaitEv");
  real(this);
  __tsan_acquire(this);
}

// To the last reactions of a call: on a thread instead of gRPC's executor, because the tool sees
// what happened before a thread's start. The library's count-down to them is invisible. The loads
// order them after the count-downs in the headers.

template <typename Reaction>
static void run_on_a_thread(Reaction reaction) {
  std::thread(std::move(reaction)).detach();
}

namespace grpc::internal {

void ServerCallbackCall::ScheduleOnDone(bool inline_ondone) {
  callbacks_outstanding_.load(std::memory_order_acquire);
  if (inline_ondone) {
    CallOnDone();
  } else {
    run_on_a_thread([this] { CallOnDone(); });
  }
}

void ServerCallbackCall::CallOnCancel(ServerReactor* reactor) {
  on_cancel_conditions_remaining_.load(std::memory_order_acquire);
  if (reactor->InternalInlineable()) {
    reactor->OnCancel();
    return;
  }
  Ref();  // the call outlives its reaction
  run_on_a_thread([this, reactor] {
    reactor->OnCancel();
    MaybeDone();
  });
}

void ClientReactor::InternalScheduleOnDone(grpc::Status status) {
  run_on_a_thread([this, status = std::move(status)] { OnDone(status); });
}

}  // namespace grpc::internal
