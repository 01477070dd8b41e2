#include "client/connection/links.h"

#include "client/web/core/transport/page_calls_link.h"
#include "client/web/core/transport/socket_link.h"

namespace burnish {

std::unique_ptr<LiveLink> make_live_link(const Connection& connection, LiveOptions options) {
  return std::make_unique<SocketLink>(connection.route(), std::move(options));
}

std::unique_ptr<PageSource> make_page_source(const Connection& connection, FetchedPages pages) {
  return std::make_unique<PageCallsLink>(connection.route(), std::move(pages));
}

}  // namespace burnish
