#include "common/wire/status_wire.h"

#include <array>
#include <utility>

namespace burnish {

static constexpr std::array<std::pair<StatusCode, int>, 14> kCodes = {{
    {StatusCode::kOk, 0},
    {StatusCode::kCancelled, 1},
    {StatusCode::kInvalidArgument, 3},
    {StatusCode::kDeadlineExceeded, 4},
    {StatusCode::kNotFound, 5},
    {StatusCode::kAlreadyExists, 6},
    {StatusCode::kPermissionDenied, 7},
    {StatusCode::kResourceExhausted, 8},
    {StatusCode::kFailedPrecondition, 9},
    {StatusCode::kUnimplemented, 12},
    {StatusCode::kInternal, 13},
    {StatusCode::kUnavailable, 14},
    {StatusCode::kDataLoss, 15},
    {StatusCode::kUnauthenticated, 16},
}};

int status_code_to_wire(StatusCode code) {
  for (const auto& [ours, theirs] : kCodes)
    if (ours == code) return theirs;
  return status_code_to_wire(StatusCode::kInternal);
}

StatusCode status_code_from_wire(int code) {
  for (const auto& [ours, theirs] : kCodes)
    if (theirs == code) return ours;
  return StatusCode::kInternal;
}

}  // namespace burnish
