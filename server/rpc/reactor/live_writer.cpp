#include "server/rpc/reactor/live_writer.h"

#include "common/wire/live_wire.h"
#include "server/process/hidden_folder.h"
#include "server/rpc/reactor/call_context.h"

namespace burnish {

void LiveWriter::report_progress(std::string_view phase, double fraction) {
  const std::lock_guard lock(mutex_);
  first_ = ProgressReport{std::string(phase), fraction};
  advance();
}

void LiveWriter::begin(const LiveClient& client) {
  const std::lock_guard lock(mutex_);
  first_ = client.welcome;
  subscriber_ = client.subscriber;
  advance();
}

void LiveWriter::end(const Status& status) {
  const std::lock_guard lock(mutex_);
  if (!end_) end_ = to_grpc(status);
  advance();
}

void LiveWriter::pump() {
  const std::lock_guard lock(mutex_);
  advance();
}

void LiveWriter::on_write_done(bool ok) {
  const std::lock_guard lock(mutex_);
  writing_ = false;
  if (!ok && !end_) end_ = to_grpc(cancelled("the client has gone"));
  advance();
}

void LiveWriter::unless_finished(const std::function<void()>& start) {
  const std::lock_guard lock(mutex_);
  if (!finished_ && !end_) start();
}

static void hide_paths(ServerMessage& message) {
  if (auto* go_away = std::get_if<GoAway>(&message))
    go_away->reason = text_for_client(go_away->reason);
  if (auto* answer = std::get_if<EditsRefused>(&message))
    answer->status = {answer->status.code(), text_for_client(answer->status.message())};
}

bool LiveWriter::take_next() {
  std::optional<ServerMessage> next = std::exchange(first_, std::nullopt);
  if (!next && subscriber_) next = subscriber_->take();
  if (!next) return false;
  hide_paths(*next);
  current_ = to_wire(std::move(*next));
  return true;
}

void LiveWriter::advance() {
  if (writing_ || finished_) return;
  if (!end_ && take_next()) {
    writing_ = true;
    return start_write_(&current_);
  }
  if (!end_ && subscriber_ && subscriber_->is_finished()) end_ = grpc::Status::OK;
  if (!end_) return;
  finished_ = true;
  finish_(*end_);
}

}  // namespace burnish
