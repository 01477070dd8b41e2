#include <algorithm>
#include <iterator>

#include "client/connection/connection_state.h"
#include "common/wire/page_values_wire.h"

namespace burnish {

namespace {

/// Checks that the values of the wanted pages come, in their order.
class ArrivingValues {
 public:
  explicit ArrivingValues(std::span<const PageId> wanted) : wanted_(wanted) {}

  Status take(const v1::PageValues& message, std::vector<PageValues>& all) {
    ASSIGN_OR_RETURN(PageValues values, from_wire(message));
    if (wanted_.empty() || values.page != wanted_.front())
      return data_loss("the values of page " + std::to_string(values.page) + " came unasked");
    wanted_ = wanted_.subspan(1);
    all.push_back(std::move(values));
    return Status::ok();
  }

  Status check_end() const {
    if (wanted_.empty()) return Status::ok();
    return data_loss("the values of page " + std::to_string(wanted_.front()) + " did not come");
  }

 private:
  std::span<const PageId> wanted_;  // that are still to come
};

}  // namespace

/// The values of some pages, and what went wrong on this side.
struct Fetched {
  std::vector<PageValues> values;
  Status here;
};

static grpc::Status fetch_values(v1::Editing::Stub& owner, grpc::ClientContext& context,
                                 const PageValuesWish& wish, Fetched& fetched) {
  auto& [values, here] = fetched = {};  // nothing stays of a call that another server goes on with
  const auto reader = owner.GetPageValues(&context, to_wire(wish));
  ArrivingValues arriving(wish.pages);
  v1::PageValues message;
  while (reader->Read(&message)) {
    if (!here.is_ok()) continue;
    here = arriving.take(message, values);
    if (!here.is_ok()) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (here.is_ok() && there.ok()) here = arriving.check_end();
  return there;
}

Result<std::vector<PageValues>> Connection::page_values(const std::string& session, CellValue value,
                                                        std::span<const PageId> pages) {
  std::vector<PageValues> all;
  for (; !pages.empty(); pages = pages.subspan(std::min(pages.size(), kValuedPagesMax))) {
    const auto some = pages.first(std::min(pages.size(), kValuedPagesMax));
    const PageValuesWish wish{session, value, {some.begin(), some.end()}};
    Fetched fetched;
    const Status there =
        state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
          return fetch_values(owner, context, wish, fetched);
        });
    RETURN_IF_ERROR(fetched.here.with_context("server " + server()));
    RETURN_IF_ERROR(there);
    std::ranges::move(fetched.values, std::back_inserter(all));
  }
  return all;
}

}  // namespace burnish
