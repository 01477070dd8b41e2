#include <algorithm>

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

static Status fetch_values(const std::string& server, v1::Editing::Stub& editing,
                           const PageValuesWish& wish, std::vector<PageValues>& all) {
  grpc::ClientContext context;
  const auto reader = editing.GetPageValues(&context, to_wire(wish));
  ArrivingValues arriving(wish.pages);
  v1::PageValues message;
  Status here;  // what went wrong on this side
  while (reader->Read(&message)) {
    if (!here.is_ok()) continue;
    here = arriving.take(message, all);
    if (!here.is_ok()) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (here.is_ok()) RETURN_IF_ERROR(call_status(server, there));
  if (here.is_ok()) here = arriving.check_end();
  return here.with_context("server " + server);
}

Result<std::vector<PageValues>> Connection::page_values(const std::string& session, CellValue value,
                                                        std::span<const PageId> pages) {
  std::vector<PageValues> all;
  for (; !pages.empty(); pages = pages.subspan(std::min(pages.size(), kValuedPagesMax))) {
    const auto some = pages.first(std::min(pages.size(), kValuedPagesMax));
    RETURN_IF_ERROR(fetch_values(server(), *state_->editing,
                                 {session, value, {some.begin(), some.end()}}, all));
  }
  return all;
}

}  // namespace burnish
