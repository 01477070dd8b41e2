#include "client/connection/page_calls.h"

#include <optional>

#include "client/connection/connection_state.h"
#include "common/wire/pages_wire.h"

namespace burnish {

Result<PagesDescription> Connection::describe_pages(const std::string& scan,
                                                    const Progress& progress) {
  grpc::ClientContext context;
  v1::DescribePagesRequest request;
  request.set_scan(scan);
  const auto reader = state_->library->DescribePages(&context, request);
  v1::DescribePagesEvent event;
  std::optional<PagesDescription> description;
  bool is_cancelled = false;
  while (reader->Read(&event)) {
    if (event.has_done()) description = from_wire(event.done());
    if (is_cancelled || !event.has_progress()) continue;
    is_cancelled = !report(progress, event.progress().phase(), event.progress().fraction());
    if (is_cancelled) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (is_cancelled) return cancelled("describing the pages was cancelled");
  RETURN_IF_ERROR(call_status(server(), there));
  if (!description) return data_loss("server " + server() + " sent no description of pages");
  return std::move(*description);
}

Status fetch_parts(const std::string& server, v1::Library::Stub& library,
                   grpc::ClientContext& context, const PagesWish& wish,
                   const Connection::PageTaker& take) {
  const auto reader = library.FetchPages(&context, to_wire(wish));
  v1::FetchPagesEvent event;
  bool is_wanted = true;
  while (reader->Read(&event)) {
    if (!is_wanted) continue;
    if (event.has_block()) is_wanted = take.block(from_wire(event.block()));
    if (event.has_page()) is_wanted = take.page(from_wire(event.page()));
    if (!is_wanted) context.TryCancel();
  }
  const grpc::Status there = reader->Finish();
  if (!is_wanted) return cancelled("fetching pages was cancelled");
  return call_status(server, there);
}

Status Connection::fetch_pages(const PagesWish& wish, const PageTaker& take) {
  grpc::ClientContext context;
  return fetch_parts(server(), *state_->library, context, wish, take);
}

}  // namespace burnish
