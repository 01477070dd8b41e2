#pragma once

#include <atomic>

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/self_owned.h"
#include "server/rpc/reactor/silence_limit.h"

namespace burnish {

/// Editing.UploadCellFields: gathers the parts of one large edit, then applies it.
class UploadCellFieldsCall final : public grpc::ServerReadReactor<grpc::ByteBuffer>,
                                   public SelfOwned<UploadCellFieldsCall> {
 public:
  UploadCellFieldsCall(const CallContext& calls, grpc::ByteBuffer& response)
      : calls_(calls), response_(response), silence_(calls.upload_silence_max) {}

  void begin();

  void OnReadDone(bool ok) override;
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override {
    silence_.stop();
    release();
  }

 private:
  void read_next();
  void end(const Status& status) { Finish(to_grpc(status)); }
  Status take_request();
  Status take_header(const v1::CellFieldsHeader& header);
  Status check_cell_count(const v1::CellFieldsHeader& header);
  Status apply();

  const CallContext calls_;
  grpc::ByteBuffer& response_;
  std::atomic<bool> cancelled_{false};
  SilenceLimit silence_;
  grpc::ByteBuffer received_;
  v1::UploadCellFieldsRequest request_;  // received message
  bool has_header_ = false;
  uint64_t announced_cells_ = 0;
  std::string session_;
  std::string edit_id_;
  SetCellFields change_;
};

}  // namespace burnish
