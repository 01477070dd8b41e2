#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/library.grpc.pb.h"
#include "client/pages/page_item.h"

namespace burnish {

/// Serves Library.FetchPages and FetchSheets in this process, with made pages and made-up blocks
/// and sheets.
class FakeLibrary final : public v1::Library::Service {
 public:
  /// Faults. A test may change them at any time.
  struct Faults {
    bool holds = false;  ///< calls wait before their first part until this ends
    int parts_max = -1;  ///< of a call; then it ends, with `ends_with`
    grpc::StatusCode ends_with = grpc::StatusCode::OK;
    std::set<uint32_t> left_out;  ///< pages that are not sent
    bool turns_around = false;    ///< sends the last part of a call first
  };
  /// Facts that a test may ask for.
  struct Seen {
    std::vector<std::vector<PageItem>> calls;
    size_t calls_at_once_max = 0;
    size_t cancelled = 0;  ///< calls, before their end
    std::string scan;
  };

  FakeLibrary();
  ~FakeLibrary() override;

  void start();  ///< on the port of the first start
  void stop();   ///< like a kill
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  void set_faults(const Faults& faults);
  Seen seen() const;

  /// Returns what the server has.
  static std::vector<uint8_t> bytes_of(PageItem item);

  using Writer = grpc::ServerWriter<v1::FetchPagesEvent>;
  grpc::Status FetchPages(grpc::ServerContext* context, const v1::FetchPagesRequest* request,
                          Writer* writer) override;
  using SheetWriter = grpc::ServerWriter<v1::FetchSheetsEvent>;
  grpc::Status FetchSheets(grpc::ServerContext* context, const v1::FetchSheetsRequest* request,
                           SheetWriter* writer) override;
  grpc::Status ListScans(grpc::ServerContext* context, const v1::ListScansRequest* request,
                         v1::ListScansResponse* response) override;

 private:
  template <typename Event>
  grpc::Status send(grpc::ServerContext& context, const std::string& scan,
                    std::vector<PageItem> items, grpc::ServerWriter<Event>& writer);
  bool wait_while_held(grpc::ServerContext& context);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Faults faults_;
  Seen seen_;
  size_t calls_now_ = 0;
  bool stopping_ = false;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace burnish
