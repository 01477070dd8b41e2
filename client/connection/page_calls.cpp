#include "client/connection/page_calls.h"

#include "client/connection/event_stream.h"
#include "common/wire/pages_wire.h"

namespace burnish {

Result<PagesDescription> Connection::describe_pages(const std::string& scan,
                                                    const Progress& progress) {
  grpc::ClientContext context;
  v1::DescribePagesRequest request;
  request.set_scan(scan);
  const auto reader = state_->library->DescribePages(&context, request);
  ASSIGN_OR_RETURN(const auto done,
                   read_until_done<v1::DescribePagesEvent>(server(), context, *reader, progress,
                                                           "describing the pages"));
  return from_wire(done);
}

Status fetch_parts(const std::string& server, v1::Library::Stub& library,
                   grpc::ClientContext& context, const PagesWish& wish,
                   const Connection::PageTaker& take) {
  const auto reader = library.FetchPages(&context, to_wire(wish));
  return read_while_wanted<v1::FetchPagesEvent>(server, context, *reader, "fetching pages",
                                                [&](const v1::FetchPagesEvent& event) {
                                                  if (event.has_block())
                                                    return take.block(from_wire(event.block()));
                                                  if (event.has_page())
                                                    return take.page(from_wire(event.page()));
                                                  return true;
                                                });
}

Status Connection::fetch_pages(const PagesWish& wish, const PageTaker& take) {
  grpc::ClientContext context;
  return fetch_parts(server(), *state_->library, context, wish, take);
}

}  // namespace burnish
