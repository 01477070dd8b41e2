#pragma once

namespace burnish {

/// A generated service with one of its WithCallbackMethod_ templates for each call. A call that
/// takes bytes (see message_bytes.h) has one of its WithRawCallbackMethod_ templates instead.
template <typename Service, template <typename> typename... Calls>
struct WithCalls {
  using Type = Service;
};
template <typename Service, template <typename> typename Call,
          template <typename> typename... Calls>
struct WithCalls<Service, Call, Calls...> {
  using Type = typename WithCalls<Call<Service>, Calls...>::Type;
};

}  // namespace burnish
