#include "server/metrics/live_objects.h"

#include <atomic>

namespace burnish {

static std::array<std::atomic<int64_t>, kLiveKinds.size()> counts;

static std::atomic<int64_t>& count_of(LiveKind kind) {
  return counts[static_cast<size_t>(kind)];
}

std::string_view live_kind_name(LiveKind kind) {
  static constexpr std::array<std::string_view, kLiveKinds.size()> kNames = {
      "call", "mesh", "session", "upload", "export", "live_session", "stream"};
  return kNames[static_cast<size_t>(kind)];
}

int64_t live_count(LiveKind kind) {
  return count_of(kind);
}

LiveObject::LiveObject(LiveKind kind) : kind_(kind) {
  ++count_of(kind);
}

LiveObject::~LiveObject() {
  --count_of(kind_);
}

}  // namespace burnish
