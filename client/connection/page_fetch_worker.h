#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/library.grpc.pb.h"
#include "client/connection/fetch_queue.h"
#include "client/connection/link_meter.h"
#include "client/connection/page_fetcher.h"

namespace burnish {

/// The threads behind a PageFetcher. Each takes some of what waits, looks on the disk, and fetches
/// the rest by one call.
class PageFetcher::Worker {
 public:
  Worker(std::string server, ConnectionTrust trust, std::string scan, std::function<void()> on_news,
         std::shared_ptr<PageDisk> disk);
  ~Worker();

  void ask(std::span<const PageItem> items);
  void cancel(std::span<const PageItem> items);
  std::vector<Arrival> take();
  LinkSpeed speed() const;

 private:
  using Time = LinkMeter::Time;
  using Stub = v1::Library::Stub;

  struct Call {
    std::vector<PageItem> items;
    size_t coming = 0;  // of the items
    grpc::ClientContext context;
    Time began = {};
    bool has_begun = false;  // a part has come
    bool is_cancelled = false;
  };

  void run();
  std::vector<PageItem> next_batch();  // empty: the end
  std::vector<PageItem> look_on_disk(const std::vector<PageItem>& batch);
  void fetch(std::vector<PageItem> items);
  Status listen(Call& call);
  bool on_part(Call& call, PageItem item, std::vector<uint8_t> bytes);
  void end(Call& call, const Status& why);
  bool is_useful(const Call& call) const;  // needs the lock
  void tell() const;
  Result<std::shared_ptr<Stub>> stub();

  const std::string server_;
  const ConnectionTrust trust_;
  const std::string scan_;
  const std::function<void()> on_news_;
  const std::shared_ptr<PageDisk> disk_;

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  FetchQueue queue_;
  LinkMeter meter_;
  std::vector<Call*> calls_;
  std::vector<Arrival> arrivals_;
  std::shared_ptr<Stub> stub_;  // null: another channel is to be made
  bool is_stopping_ = false;

  std::vector<std::thread> threads_;  // last: they use all of the above
};

}  // namespace burnish
