#include "client/web/core/host/calls.h"

#include <map>
#include <utility>

#include "client/web/core/host/imports.h"
#include "client/web/core/host/stacks.h"

namespace burnish {

namespace {

constexpr int kCancelled = 1;
constexpr int kDeadlineExceeded = 4;
constexpr std::chrono::milliseconds kRoomPoll{10};

/// Calls that have not ended, by number.
std::map<int, HostCall*>& open_calls() {
  static auto* const the = new std::map<int, HostCall*>();  // lives as long as the page
  return *the;
}

}  // namespace

HostCall::HostCall(std::string_view method, std::string_view node, std::function<void()> on_event)
    : number_(host_call_open(method.data(), method.size(), node.data(), node.size())),
      on_event_(std::move(on_event)) {
  open_calls().emplace(number_, this);
}

HostCall::~HostCall() {
  on_event_ = nullptr;
  cancel();
  open_calls().erase(number_);
}

void HostCall::send(std::string_view message) {
  if (!end_)
    host_call_send(number_, reinterpret_cast<const uint8_t*>(message.data()), message.size());
}

void HostCall::end_sending() {
  if (!end_) host_call_end(number_);
}

void HostCall::cancel() {
  if (!end_) host_call_cancel(number_);
}

size_t HostCall::buffered() const {
  return end_ ? 0 : host_call_buffered(number_);
}

std::optional<std::vector<uint8_t>> HostCall::take() {
  if (heard_.empty()) return std::nullopt;
  std::vector<uint8_t> message = std::move(heard_.front());
  heard_.pop_front();
  if (!end_) host_call_pull(number_);
  return message;
}

void HostCall::wait() {
  waiting_ = this_stack();
  wait_on_stack();
  waiting_ = 0;
}

std::optional<std::vector<uint8_t>> HostCall::wait_for_message() {
  while (heard_.empty() && !end_) wait();
  return take();
}

CallEnd HostCall::wait_for_end() {
  while (!end_) {
    while (take()) {
    }
    wait();
  }
  heard_.clear();
  return *end_;
}

bool HostCall::wait_for_room(size_t bytes) {
  waits_for_room_ = true;
  while (!end_ && buffered() > bytes) {
    host_wake();
    wait();
  }
  waits_for_room_ = false;
  return !end_;
}

void HostCall::tell() {
  resume_stack(waiting_);
  if (on_event_) on_event_();
}

void HostCall::on_message(int call, std::vector<uint8_t> message) {
  const auto found = open_calls().find(call);
  if (found == open_calls().end()) return;  // its owner has left
  found->second->heard_.push_back(std::move(message));
  found->second->tell();
}

void HostCall::on_end(int call, CallEnd end) {
  const auto found = open_calls().find(call);
  if (found == open_calls().end()) return;
  HostCall* const ended = found->second;
  open_calls().erase(found);
  const bool is_late = end.code == kCancelled && ended->deadline_ == Time::min();
  ended->end_ = is_late ? CallEnd{kDeadlineExceeded, "no answer in time", {}} : std::move(end);
  ended->tell();
}

HostCall::Time HostCall::look_at_all(Time now) {
  Time next = Time::max();
  for (const auto& [number, call] : open_calls()) {
    if (call->waits_for_room_) {
      resume_stack(call->waiting_);
      next = std::min(next, now + kRoomPoll);
    }
    if (!call->deadline_ || *call->deadline_ == Time::min()) continue;
    if (now < *call->deadline_) {
      next = std::min(next, *call->deadline_);
      continue;
    }
    call->deadline_ = Time::min();  // its end will say so
    call->cancel();
  }
  return next;
}

}  // namespace burnish
