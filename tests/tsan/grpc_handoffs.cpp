// Linked into every program of a ThreadSanitizer build that uses gRPC. Debian's gRPC is not
// instrumented: the tool sees neither how a batch gets from the thread that starts it to the thread
// that runs its callback, nor how a reaction gets to the executor that runs it, and would call
// whatever both threads touch a race. Here the tool is told of these hand-offs, and of nothing
// else: two threads that only meet in gRPC's locks stay unordered, and our own races in callbacks
// stay visible. The functions below take the place of gRPC's own of the same names.

#include <dlfcn.h>
#include <thread>

#include <grpcpp/grpcpp.h>
#include <grpcpp/support/client_callback.h>
#include <grpcpp/support/server_callback.h>
#include <sanitizer/tsan_interface.h>

// What happened before a batch was started ...
extern "C" grpc_call_error grpc_call_start_batch(grpc_call* call, const grpc_op* ops, size_t count,
                                                 void* tag, void* reserved) {
  static const auto real =
      reinterpret_cast<decltype(&grpc_call_start_batch)>(dlsym(RTLD_NEXT, "grpc_call_start_batch"));
  __tsan_release(tag);
  return real(call, ops, count, tag, reserved);
}

// ... happened before its callback. The headers define these two in their classes, as weak symbols.
void run_success_tag(grpc_completion_queue_functor* tag, int ok) __asm__(
    "_ZN4grpc8internal22CallbackWithSuccessTag9StaticRunEP29grpc_completion_queue_functori");
void run_success_tag(grpc_completion_queue_functor* tag, int ok) {
  __tsan_acquire(tag);
  static_cast<grpc::internal::CallbackWithSuccessTag*>(tag)->force_run(ok != 0);
}

void run_status_tag(grpc_completion_queue_functor* tag, int ok) __asm__(
    "_ZN4grpc8internal21CallbackWithStatusTag9StaticRunEP29grpc_completion_queue_functori");
void run_status_tag(grpc_completion_queue_functor* tag, int /*ok: the status says it*/) {
  __tsan_acquire(tag);
  static_cast<grpc::internal::CallbackWithStatusTag*>(tag)->force_run(grpc::Status());
}

// Instead of gRPC's executor, a thread: the tool sees what happened before its start.
template <typename Reaction>
static void run_on_a_thread(Reaction reaction) {
  std::thread(std::move(reaction)).detach();
}

namespace grpc::internal {

void ServerCallbackCall::ScheduleOnDone(bool inline_ondone) {
  if (inline_ondone) {
    CallOnDone();
  } else {
    run_on_a_thread([this] { CallOnDone(); });
  }
}

void ServerCallbackCall::CallOnCancel(ServerReactor* reactor) {
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
