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
#include "client/live/surface_frame.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {

/// Serves Editing.Edit by its contract over the small pages, in this process. Frames come from the
/// real encoder; a test can switch on faults. Edits survive stop() and start(), as on a disk.
class FakeEditing final : public v1::Editing::Service {
 public:
  /// Faults. A test may change them at any time.
  struct Faults {
    bool answer_no_edits = false;  ///< edits are kept, but not acknowledged
    bool make_no_frames = false;
    bool silent = false;  ///< the server answers nothing, and never again on streams of that time
    int corrupt_frames = 0;  ///< number of next frames to corrupt
    int lost_frames = 0;     ///< frames to drop; the encoder takes them as received
    int late_frames = 0;     ///< frames to send a second time
    grpc::StatusCode refuse_edits = grpc::StatusCode::OK;
    grpc::StatusCode refuse_greeting = grpc::StatusCode::OK;
    uint64_t fingerprint_change = 0;
  };
  /// Facts that a test may ask for.
  struct Seen {
    std::vector<std::string> applied;  ///< ids in order, each once
    int repeated = 0;                  ///< edits that were known
    int greetings = 0;
    int key_frame_requests = 0;
    int refused_frames = 0;
    int frames = 0;
    int heartbeats = 0;
    std::vector<v1::Preview> previews;
    std::vector<v1::MoveBrush> rings;
    std::vector<v1::ShowPages> changes;  ///< of shown pages
    int credits_before_pages = 0;        ///< credits on streams that have shown no page yet
  };

  FakeEditing();
  ~FakeEditing() override;

  void start();  ///< on the port of the first start
  void stop();   ///< like a kill
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  void set_faults(const Faults& faults);
  Seen seen() const;

  /// Makes a new surface for all clients.
  void show(double phase);
  /// Makes frames of this kind for all clients from now on.
  void send(PageFrameKind kind);
  /// Ends the streams with a go_away.
  void go_away(const std::string& reason, bool come_back,
               v1::GoAwayCode code = v1::GO_AWAY_CODE_UNSPECIFIED);

  /// Says whether a client has these pages as it should in the end.
  bool is_shown_by(const SurfaceFrame& frame, const std::vector<PageId>& pages) const;

  using Stream = grpc::ServerReaderWriter<v1::ServerMessage, v1::ClientMessage>;
  grpc::Status Edit(grpc::ServerContext* context, Stream* stream) override;

 private:
  struct Client;
  void take(Client& client, const v1::ClientMessage& message);
  void take_pages(Client& client, const v1::ShowPages& change);
  void take_credit(Client& client, const v1::Credit& credit);
  void take_edits(Client& client, const v1::ApplyEdits& apply);
  static void change_kind(Client& client, const PageSampler& sampler);
  bool make_frame(Client& client);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Vec3f> field_;
  PageSampler sampler_{PageFrameKind::kVertices};
  uint64_t version_ = 1;  // of what the sampler has
  Faults faults_;
  Seen seen_;
  std::vector<grpc::ServerContext*> contexts_;
  v1::GoAway go_away_;
  uint64_t go_aways_ = 0;
  bool stopping_ = false;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

/// The fingerprint of the pages that the fake serves.
inline constexpr uint64_t kFakeFingerprint = 0x1234;

}  // namespace burnish
