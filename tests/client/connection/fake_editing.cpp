#include "tests/client/connection/fake_editing.h"

#include <algorithm>
#include <thread>

#include "common/page_frames/page_frame_encoder.h"
#include "tests/client/connection/fake_server.h"
#include "tests/client/live/small_surface.h"

namespace burnish {

/// One stream.
struct FakeEditing::Client {
  explicit Client(PageFrameKind of_kind) : kind(of_kind), encoder(of_kind) {}

  PageFrameKind kind;
  PageFrameEncoder encoder;
  ShownPages shown;
  uint32_t sent_revision = 0;
  std::deque<v1::ServerMessage> outgoing;
  uint32_t credits = 0;
  uint64_t shown_version = 0;
  uint64_t client_time_us = 0;
  uint64_t previews = 0;
  uint64_t go_aways = 0;
  bool silenced = false;  // it met a silent server: what it said was lost
  bool gone = false;
};

FakeEditing::FakeEditing() {
  show(0);
  start();
}

FakeEditing::~FakeEditing() {
  stop();
}

void FakeEditing::start() {
  stopping_ = false;
  server_ = serve_fake(*this, port_);
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
  field_ = wavy_field(2, phase);
  sampler_.sample(field_);
  ++version_;
  changed_.notify_all();
}

void FakeEditing::send(PageFrameKind kind) {
  const std::lock_guard lock(mutex_);
  sampler_ = PageSampler(kind);
  sampler_.sample(field_);
  ++version_;
  changed_.notify_all();
}

void FakeEditing::go_away(const std::string& reason, bool come_back, v1::GoAwayCode code) {
  const std::lock_guard lock(mutex_);
  go_away_.set_code(code);
  go_away_.set_reason(reason);
  go_away_.set_come_back(come_back);
  ++go_aways_;
  changed_.notify_all();
}

bool FakeEditing::is_shown_by(const SurfaceFrame& frame, const std::vector<PageId>& pages) const {
  const std::lock_guard lock(mutex_);
  return shows(frame, sampler_, pages);
}

void FakeEditing::take_pages(Client& client, const v1::ShowPages& message) {
  seen_.changes.push_back(message);
  if (client.kind != sampler_.kind()) change_kind(client, sampler_);
  PageChange change =
      sampler_.adding(message.revision(), {message.added().begin(), message.added().end()});
  change.removed.assign(message.removed().begin(), message.removed().end());
  const Status wrong = client.shown.check(change, sampler_.page_count());
  BURNISH_CHECK(wrong.is_ok(), wrong.message());
  client.shown = client.shown.changed(change);
}

void FakeEditing::take_credit(Client& client, const v1::Credit& credit) {
  if (client.shown.revision() == 0) ++seen_.credits_before_pages;
  client.credits = std::min(8u, client.credits + credit.frames());
  for (const uint64_t frame : credit.decoded()) client.encoder.acknowledge(frame);
  for (const uint64_t frame : credit.refused()) client.encoder.refuse(frame);
  seen_.refused_frames += credit.refused_size();
  if (credit.refused_size() > 0 || credit.key_frame()) client.shown_version = 0;
  if (!credit.key_frame()) return;
  ++seen_.key_frame_requests;
  client.encoder.request_key_frame();
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
  if (client.silenced |= faults_.silent) return;
  switch (message.message_case()) {
    case v1::ClientMessage::kGreeting: {
      ++seen_.greetings;
      v1::ServerMessage answer;
      v1::Welcome& welcome = *answer.mutable_welcome();
      welcome.mutable_session()->set_name(message.greeting().session());
      welcome.mutable_session()->set_depth(small_depth());
      welcome.set_connection(7);
      welcome.set_role(v1::ROLE_EDITOR);
      welcome.set_pages_fingerprint(kFakeFingerprint + faults_.fingerprint_change);
      client.outgoing.push_back(std::move(answer));
      break;
    }
    case v1::ClientMessage::kCredit:
      take_credit(client, message.credit());
      break;
    case v1::ClientMessage::kShowPages:
      take_pages(client, message.show_pages());
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

void FakeEditing::change_kind(Client& client, const PageSampler& sampler) {
  std::vector<ShownPage> relaid;
  for (const ShownPage& page : client.shown.pages()) relaid.push_back(sampler.shown(page.page));
  client.shown = client.shown.with_layouts(std::move(relaid));
  client.kind = sampler.kind();
  client.encoder = PageFrameEncoder(sampler.kind());
}

// Returns true if there was a reason and a credit for a frame.
bool FakeEditing::make_frame(Client& client) {
  const bool has_news =
      client.shown_version != version_ || client.sent_revision != client.shown.revision();
  if (client.silenced || faults_.silent || faults_.make_no_frames || client.credits == 0 ||
      !has_news)
    return false;
  client.shown_version = version_;
  client.sent_revision = client.shown.revision();
  if (client.kind != sampler_.kind()) change_kind(client, sampler_);
  --client.credits;
  ++seen_.frames;
  const std::vector<WantedPage> wanted = sampler_.wanted(client.shown);
  EncodedPageFrame frame = client.encoder.encode({client.shown, wanted, 2}, kStillSteps);
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
  Client client(sampler_.kind());
  client.go_aways = go_aways_;
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
  bool said_go_away = false;
  while (!client.gone && !stopping_ && !said_go_away) {
    if (client.go_aways != go_aways_) {
      client.outgoing.emplace_back();
      *client.outgoing.back().mutable_go_away() = go_away_;
      said_go_away = true;
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

}  // namespace burnish
