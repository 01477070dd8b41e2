#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/check.h"

namespace burnish {

/// Why an operation failed, in categories that a caller can act on. The names follow gRPC's codes,
/// so the service maps them one to one.
enum class StatusCode {
  kOk,
  kCancelled,
  kInvalidArgument,  ///< the input itself is wrong: a bad file, a value out of its range
  kNotFound,
  kAlreadyExists,
  kPermissionDenied,
  kResourceExhausted,   ///< a limit of memory, disk or count is reached
  kFailedPrecondition,  ///< the input is right, the moment is wrong
  kUnavailable,         ///< another try may succeed: the peer is gone or leaving
  kDataLoss,            ///< stored data is damaged
  kUnimplemented,
  kUnauthenticated,
  kDeadlineExceeded,
  kInternal,
};

/// Returns the code's name for users, e.g. "invalid argument".
const char* status_code_name(StatusCode code);

/// The outcome of an operation that can fail for reasons outside the program.
/// A message names the thing, its value and its limit. Broken contracts are BURNISH_CHECKs instead.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {
    BURNISH_CHECK(code != StatusCode::kOk, "an error needs an error's code");
  }
  static Status ok() { return {}; }
  /// `address`: of the server that has what was asked for; or the text of its ServerPlace.
  static Status moved(std::string address, std::string message);

  bool is_ok() const { return code_ == StatusCode::kOk; }
  StatusCode code() const { return code_; }
  const std::string& message() const { return message_; }
  /// Returns that text of the server to ask instead; empty: no other server is known.
  const std::string& moved_to() const;

  /// "invalid argument: depth 13 is outside 4..12", or "ok".
  std::string to_string() const;

  /// Returns the same failure with "context: " before its message; ok stays ok.
  Status with_context(const std::string& context) const;

  /// Returns the same failure with another name for a thing in its message: a file that the program
  /// made for itself means nothing to the reader.
  Status renamed(std::string_view thing, std::string_view name) const;

 private:
  StatusCode code_ = StatusCode::kOk;
  std::string message_;
  std::shared_ptr<const std::string> moved_to_;  // null: no address. Rare, so it is kept apart
};

Status invalid_argument(std::string message);
Status not_found(std::string message);
Status already_exists(std::string message);
Status resource_exhausted(std::string message);
Status failed_precondition(std::string message);
Status data_loss(std::string message);
Status unavailable(std::string message);
Status cancelled(std::string message);
Status internal_error(std::string message);
Status unimplemented(std::string message);

/// Makes the Status of a failed system call: maps errno (ENOENT, EACCES, ENOSPC, ...) to a code and
/// appends its text: `what` + ": No space left on device".
Status errno_status(const std::string& what, int error_number);

/// A value, or the reason why there is no value.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}         // NOLINT(google-explicit-constructor)
  Result(Status status) : status_(std::move(status)) {  // NOLINT(google-explicit-constructor)
    BURNISH_CHECK(!status_.is_ok(), "a Result without a value needs an error");
  }

  bool is_ok() const { return status_.is_ok(); }
  const Status& status() const { return status_; }

  T& value() & {
    BURNISH_CHECK(value_.has_value(), status_.message());
    return *value_;
  }
  const T& value() const& {
    BURNISH_CHECK(value_.has_value(), status_.message());
    return *value_;
  }
  T&& value() && {
    BURNISH_CHECK(value_.has_value(), status_.message());
    return std::move(*value_);
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  Status status_;
  std::optional<T> value_;
};

}  // namespace burnish

#define BURNISH_CONCAT_INNER(a, b) a##b
#define BURNISH_CONCAT(a, b) BURNISH_CONCAT_INNER(a, b)

/// Returns from the calling function when the expression's Status is an error.
#define RETURN_IF_ERROR(expression)                                   \
  do {                                                                \
    ::burnish::Status status_of_expression_ = (expression);           \
    if (!status_of_expression_.is_ok()) return status_of_expression_; \
  } while (false)

/// ASSIGN_OR_RETURN(auto mesh, read_mesh(path)): binds the value or returns the error.
#define ASSIGN_OR_RETURN(declaration, expression) \
  ASSIGN_OR_RETURN_INNER(BURNISH_CONCAT(result_of_expression_, __LINE__), declaration, expression)
#define ASSIGN_OR_RETURN_INNER(result, declaration, expression) \
  auto result = (expression);                                   \
  if (!result.is_ok()) return result.status();                  \
  declaration = std::move(result).value()
