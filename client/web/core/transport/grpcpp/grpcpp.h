#pragma once

// The part of gRPC's interface that client/connection uses, over the worker's calls. Calls wait:
// they run on stacks of their own.

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/web/core/host/calls.h"

namespace grpc {

enum StatusCode { OK = 0, INTERNAL = 13, UNAVAILABLE = 14 };

class Status {
 public:
  Status() = default;
  Status(int code, std::string message, std::string details = {})
      : code_(code), message_(std::move(message)), details_(std::move(details)) {}

  bool ok() const { return code_ == OK; }
  int error_code() const { return code_; }
  const std::string& error_message() const { return message_; }
  const std::string& error_details() const { return details_; }

 private:
  int code_ = OK;
  std::string message_, details_;
};

/// The way to the page's server. There is one.
class Channel {};

class ClientContext {
 public:
  /// The worker adds user and token itself.
  void AddMetadata(const std::string& name, const std::string& value) {
    if (name == "x-burnish-node") node_ = value;
  }
  void set_deadline(std::chrono::system_clock::time_point deadline) {
    const auto left = deadline - std::chrono::system_clock::now();
    deadline_ = std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(left);
  }
  void TryCancel() {
    if (call_) call_->cancel();
  }

  // For the stubs.
  burnish::HostCall& begin(std::string_view method) {
    call_.emplace(method, node_);
    if (deadline_) call_->set_deadline(*deadline_);
    return *call_;
  }

 private:
  std::string node_;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::optional<burnish::HostCall> call_;
};

// Shared by all streams. Shapes of messages: protobuf's.

template <typename Message>
bool read_message(burnish::HostCall& call, Message* message) {
  const auto bytes = call.wait_for_message();
  if (!bytes) return false;
  if (message->ParseFromArray(bytes->data(), static_cast<int>(bytes->size()))) return true;
  call.cancel();
  return false;
}

inline Status finish(burnish::HostCall& call) {
  burnish::CallEnd end = call.wait_for_end();
  return {end.code, std::move(end.message), std::move(end.details)};
}

/// Limit of what a writer leaves to the link before it waits.
inline constexpr size_t kUnsentBytesMax = 4 << 20;

template <typename Message>
bool write_message(burnish::HostCall& call, const Message& message) {
  if (!call.wait_for_room(kUnsentBytesMax)) return false;
  call.send(message.SerializeAsString());
  return true;
}

template <typename Answer>
class ClientReader {
 public:
  explicit ClientReader(burnish::HostCall& call) : call_(call) {}
  bool Read(Answer* message) { return read_message(call_, message); }
  Status Finish() { return finish(call_); }

 private:
  burnish::HostCall& call_;
};

template <typename Question, typename Answer>
class ClientReaderWriter {
 public:
  explicit ClientReaderWriter(burnish::HostCall& call) : call_(call) {}
  bool Write(const Question& message) { return write_message(call_, message); }
  bool WritesDone() {
    call_.end_sending();
    return true;
  }
  bool Read(Answer* message) { return read_message(call_, message); }
  Status Finish() { return finish(call_); }

 private:
  burnish::HostCall& call_;
};

/// A call of several messages and one answer, whose place is known when it begins.
template <typename Question, typename Answer>
class AnsweredWriter {
 public:
  AnsweredWriter(burnish::HostCall& call, Answer* answer) : call_(call), answer_(answer) {}
  bool Write(const Question& message) { return write_message(call_, message); }
  bool WritesDone() {
    call_.end_sending();
    return true;
  }
  Status Finish() {
    read_message(call_, answer_);
    return finish(call_);
  }

 private:
  burnish::HostCall& call_;
  Answer* answer_;
};

// The kinds of calls.

template <typename Question, typename Answer>
Status call_once(std::string_view method, ClientContext* context, const Question& question,
                 Answer* answer) {
  burnish::HostCall& call = context->begin(method);
  call.send(question.SerializeAsString());
  call.end_sending();
  const bool has_answer = read_message(call, answer);
  const Status ended = finish(call);
  if (ended.ok() && !has_answer) return {INTERNAL, "the call ended without an answer"};
  return ended;
}

template <typename Answer, typename Question>
std::unique_ptr<ClientReader<Answer>> call_for_many(std::string_view method, ClientContext* context,
                                                    const Question& question) {
  burnish::HostCall& call = context->begin(method);
  call.send(question.SerializeAsString());
  call.end_sending();
  return std::make_unique<ClientReader<Answer>>(call);
}

}  // namespace grpc
