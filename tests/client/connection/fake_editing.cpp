#include "tests/client/connection/fake_editing.h"

#include <algorithm>
#include <thread>

#include "common/frame_codec/frame_encoder.h"
#include "tests/common/view/small_view.h"

namespace burnish {

/// One stream.
struct FakeEditing::Client {
  explicit Client(const std::shared_ptr<const FrameLayout>& layout) : encoder(layout) {}

  FrameEncoder encoder;
  std::deque<v1::ServerMessage> outgoing;
  uint32_t credits = 0;
  uint64_t shown_version = 0;
  uint64_t client_time_us = 0;
  uint64_t previews = 0;
  uint64_t farewells = 0;
  bool gone = false;
};

FakeEditing::FakeEditing() : layout_(small_layout(FrameContent::kCoefficients)) {
  show(0);
  start();
}

FakeEditing::~FakeEditing() {
  stop();
}

void FakeEditing::start() {
  stopping_ = false;
  grpc::ServerBuilder builder;
  int port = 0;
  builder.AddListeningPort("127.0.0.1:" + std::to_string(port_), grpc::InsecureServerCredentials(),
                           &port);
  builder.RegisterService(this);
  server_ = builder.BuildAndStart();
  BURNISH_CHECK(server_ && port > 0, "the fake has its port");
  port_ = port;
}

void FakeEditing::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (grpc::ServerContext* context : contexts_) context->TryCancel();
    changed_.notify_all();
  }
  if (server_) server_->Shutdown(std::chrono::system_clock::now());
  server_.reset();
}

void FakeEditing::set_faults(const Faults& faults) {
  const std::lock_guard lock(mutex_);
  faults_ = faults;
  changed_.notify_all();
}

FakeEditing::Seen FakeEditing::seen() const {
  const std::lock_guard lock(mutex_);
  return seen_;
}

void FakeEditing::show(double phase) {
  const std::lock_guard lock(mutex_);
  sample_ = sample_of(*layout_, wavy_displacement(small_scan().grid, 2, phase));
  ++version_;
  changed_.notify_all();
}

void FakeEditing::go_away(const std::string& reason, bool come_back) {
  const std::lock_guard lock(mutex_);
  farewell_.set_reason(reason);
  farewell_.set_come_back(come_back);
  ++farewells_;
  changed_.notify_all();
}

std::vector<int32_t> FakeEditing::steps() const {
  const std::lock_guard lock(mutex_);
  return sample_.steps;
}

void FakeEditing::take_edits(Client& client, const v1::ApplyEdits& apply) {
  v1::ServerMessage answer;
  if (faults_.refuse_edits != grpc::StatusCode::OK) {
    for (const v1::Edit& edit : apply.edits()) answer.mutable_refused()->add_edit_ids(edit.id());
    answer.mutable_refused()->set_code(faults_.refuse_edits);
    answer.mutable_refused()->set_message("not today");
  } else {
    for (const v1::Edit& edit : apply.edits()) {
      answer.mutable_acknowledged()->add_edit_ids(edit.id());
      if (std::ranges::count(seen_.applied, edit.id()) > 0) {
        ++seen_.repeated;
      } else {
        seen_.applied.push_back(edit.id());
      }
    }
    answer.mutable_acknowledged()->mutable_outcome()->set_edits(seen_.applied.size());
    ++version_;
  }
  if (!faults_.answer_no_edits) client.outgoing.push_back(std::move(answer));
}

void FakeEditing::take(Client& client, const v1::ClientMessage& message) {
  if (faults_.silent) return;
  switch (message.message_case()) {
    case v1::ClientMessage::kGreeting: {
      ++seen_.greetings;
      v1::ServerMessage answer;
      v1::Welcome& welcome = *answer.mutable_welcome();
      welcome.mutable_session()->set_name(message.greeting().session());
      welcome.mutable_session()->set_depth(6);
      welcome.set_connection(7);
      welcome.set_role(v1::ROLE_EDITOR);
      welcome.set_content(v1::FRAME_CONTENT_COEFFICIENTS);
      welcome.set_layout_fingerprint(layout_->fingerprint + faults_.fingerprint_change);
      client.outgoing.push_back(std::move(answer));
      break;
    }
    case v1::ClientMessage::kCredit:
      client.credits = std::min(8u, client.credits + message.credit().frames());
      for (const uint64_t frame : message.credit().decoded()) client.encoder.acknowledge(frame);
      for (const uint64_t frame : message.credit().refused()) client.encoder.refuse(frame);
      seen_.refused_frames += message.credit().refused_size();
      if (message.credit().refused_size() > 0 || message.credit().key_frame())
        client.shown_version = 0;
      if (message.credit().key_frame()) {
        ++seen_.key_frame_requests;
        client.encoder.request_key_frame();
      }
      break;
    case v1::ClientMessage::kApply:
      take_edits(client, message.apply());
      break;
    case v1::ClientMessage::kPreview:
      seen_.previews.push_back(message.preview());
      ++client.previews;
      ++version_;
      break;
    case v1::ClientMessage::kMoveBrush:
      seen_.rings.push_back(message.move_brush());
      break;
    case v1::ClientMessage::kHeartbeat: {
      ++seen_.heartbeats;
      client.client_time_us = message.heartbeat().client_time_us();
      v1::ServerMessage answer;
      *answer.mutable_heartbeat() = message.heartbeat();
      client.outgoing.push_back(std::move(answer));
      break;
    }
    default:
      break;
  }
}

// Returns true if there was a reason and a credit for a frame.
bool FakeEditing::make_frame(Client& client) {
  if (faults_.silent || client.credits == 0 || client.shown_version == version_) return false;
  client.shown_version = version_;
  --client.credits;
  ++seen_.frames;
  EncodedFrame frame = client.encoder.encode(sample_, FrameStep::kStill);
  if (faults_.lost_frames > 0) {
    --faults_.lost_frames;
    ++client.credits;
    client.encoder.acknowledge(frame.sequence);
    return true;
  }
  if (faults_.corrupt_frames > 0) {
    --faults_.corrupt_frames;
    frame.bytes[frame.bytes.size() / 2] ^= 0x40;
  }
  v1::ServerMessage message;
  message.mutable_frame()->set_data(frame.bytes.data(), frame.bytes.size());
  message.mutable_frame()->set_state(v1::SOLVE_STATE_SETTLED);
  message.mutable_frame()->set_edits(seen_.applied.size());
  message.mutable_frame()->set_client_time_us(client.client_time_us);
  message.mutable_frame()->set_previews(client.previews);
  if (faults_.late_frames > 0) {
    --faults_.late_frames;
    client.outgoing.push_back(message);
  }
  client.outgoing.push_back(std::move(message));
  return true;
}

grpc::Status FakeEditing::Edit(grpc::ServerContext* context, Stream* stream) {
  std::unique_lock lock(mutex_);
  if (faults_.refuse_greeting != grpc::StatusCode::OK)
    return {faults_.refuse_greeting, "go elsewhere"};
  Client client(layout_);
  client.farewells = farewells_;
  contexts_.push_back(context);
  std::thread reader([&] {
    v1::ClientMessage message;
    while (stream->Read(&message)) {
      const std::lock_guard reading(mutex_);
      take(client, message);
      changed_.notify_all();
    }
    const std::lock_guard reading(mutex_);
    client.gone = true;
    changed_.notify_all();
  });
  bool said_farewell = false;
  while (!client.gone && !stopping_ && !said_farewell) {
    if (client.farewells != farewells_) {
      client.outgoing.emplace_back();
      *client.outgoing.back().mutable_go_away() = farewell_;
      said_farewell = true;
    }
    if (client.outgoing.empty() && !make_frame(client)) {
      changed_.wait(lock);
      continue;
    }
    while (!client.outgoing.empty()) {
      const v1::ServerMessage message = std::move(client.outgoing.front());
      client.outgoing.pop_front();
      lock.unlock();
      stream->Write(message);
      lock.lock();
    }
  }
  std::erase(contexts_, context);
  lock.unlock();
  context->TryCancel();  // ends the reader
  reader.join();
  return grpc::Status::OK;
}

std::shared_ptr<const View> fake_view() {
  static const auto view =
      std::make_shared<const View>(read_view(make_view(small_source(), 0).bytes).value());
  return view;
}

}  // namespace burnish
