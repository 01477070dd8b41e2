#pragma once

namespace burnish {

/// A generated service with each call as one of its WithCallbackMethod_ or, where the call takes
/// bytes (see message_bytes.h), its WithRawCallbackMethod_ templates says.
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
