#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "common/frame_codec/frame_encoder.h"
#include "common/view/view.h"

namespace burnish {

/// Editing.Edit as the contract has it, over the small scan, in this process: real frames by the
/// real encoder, and faults at a test's word. Edits survive stop() and start(), as on a disk.
class FakeEditing final : public v1::Editing::Service {
 public:
  /// What goes wrong; each is under the test's control at any time.
  struct Faults {
    bool answer_no_edits = false;  ///< they are kept, and nobody hears of it
    bool silent = false;           ///< nothing is answered at all
    int corrupt_frames = 0;        ///< so many to come
    int lost_frames = 0;           ///< so many are not sent, though the encoder thinks they were
    int late_frames = 0;           ///< so many are sent a second time
    grpc::StatusCode refuse_edits = grpc::StatusCode::OK;
    grpc::StatusCode refuse_greeting = grpc::StatusCode::OK;
    uint64_t fingerprint_change = 0;
  };
  /// What a test may ask about.
  struct Seen {
    std::vector<std::string> applied;  ///< ids in their order, each once
    int repeated = 0;                  ///< edits that were there already
    int greetings = 0;
    int key_frame_requests = 0;
    int refused_frames = 0;
    int frames = 0;
    int heartbeats = 0;
    std::vector<v1::Preview> previews;
    std::vector<v1::MoveBrush> rings;
  };

  FakeEditing();
  ~FakeEditing() override;

  void start();  ///< on the port of the first time
  void stop();   ///< as a kill does it
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  void set_faults(const Faults& faults);
  Seen seen() const;

  /// A new surface for all clients.
  void show(double phase);
  /// Ends the streams with a farewell.
  void go_away(const std::string& reason, bool come_back);

  /// What a client should hold in the end.
  std::vector<int32_t> steps() const;

  using Stream = grpc::ServerReaderWriter<v1::ServerMessage, v1::ClientMessage>;
  grpc::Status Edit(grpc::ServerContext* context, Stream* stream) override;

 private:
  struct Client;
  void take(Client& client, const v1::ClientMessage& message);
  void take_edits(Client& client, const v1::ApplyEdits& apply);
  bool make_frame(Client& client);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const FrameLayout> layout_;
  FrameSample sample_;
  uint64_t version_ = 1;  // of the sample
  Faults faults_;
  Seen seen_;
  std::vector<grpc::ServerContext*> contexts_;
  v1::GoAway farewell_;
  uint64_t farewells_ = 0;
  bool stopping_ = false;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

/// What clients of the fake draw.
std::shared_ptr<const View> fake_view();

}  // namespace burnish
