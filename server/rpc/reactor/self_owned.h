#pragma once

#include <memory>
#include <utility>

namespace burnish {

/// A call that lives until gRPC has reported its end *and* its last work on the executor has let go
/// of it. Each piece of work holds self().
template <typename Call>
class SelfOwned : public std::enable_shared_from_this<Call> {
 public:
  template <typename... Arguments>
  static Call* start(Arguments&&... arguments) {
    auto call = std::make_shared<Call>(std::forward<Arguments>(arguments)...);
    call->self_ = call;
    call->begin();
    return call.get();
  }

 protected:
  /// Callable from gRPC's reactions before release(), or by a holder, even while the call ends.
  std::shared_ptr<Call> self() { return this->shared_from_this(); }

  /// Call last in OnDone.
  void release() { const std::shared_ptr<Call> last = std::move(self_); }

 private:
  std::shared_ptr<Call> self_;  // until gRPC reports the end
};

}  // namespace burnish
