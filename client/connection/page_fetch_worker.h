#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/page_fetcher.h"
#include "client/live/server_route.h"
#include "client/pages/page_delivery.h"

namespace burnish {

/// The threads behind a PageFetcher. Each takes some of what waits, looks on the disk, and fetches
/// the rest by one call.
class PageFetcher::Worker {
 public:
  Worker(std::shared_ptr<ServerRoute> route, ConnectionTrust trust, std::string scan,
         std::function<void()> on_news, std::shared_ptr<PageDisk> disk);
  ~Worker();

  void ask(std::span<const PageItem> items);
  void cancel(std::span<const PageItem> items);
  std::vector<Arrival> take();
  LinkSpeed speed() const;

 private:
  using Call = PageDelivery::Call;
  /// A server, and the way there.
  struct Reached {
    ServerPlace server;
    std::unique_ptr<v1::Library::Stub> library;
  };

  void run();
  std::vector<PageItem> next_batch();  // empty: the end
  std::vector<PageItem> look_on_disk(const std::vector<PageItem>& batch);
  void fetch(const std::vector<PageItem>& items);
  Status listen(Call call, const std::vector<PageItem>& items, grpc::ClientContext& context);
  Status listen_for_pages(Call call, const std::vector<PageItem>& items,
                          grpc::ClientContext& context, Reached& reached);
  Status listen_for_sheets(Call call, const std::vector<PageItem>& items,
                           grpc::ClientContext& context, Reached& reached);
  bool on_part(Call call, PageItem item, std::vector<uint8_t> bytes);
  void end(Call call, const Status& why);
  void tell() const;
  Result<std::shared_ptr<Reached>> reach();

  const std::shared_ptr<ServerRoute> route_;
  const ConnectionTrust trust_;
  const std::string scan_;
  const std::function<void()> on_news_;
  const std::shared_ptr<PageDisk> disk_;

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  PageDelivery delivery_;
  std::map<Call, grpc::ClientContext*> contexts_;  // of the calls under way
  std::shared_ptr<Reached> reached_;               // null: another channel is to be made
  bool is_stopping_ = false;

  std::vector<std::thread> threads_;  // last: they use all of the above
};

}  // namespace burnish
