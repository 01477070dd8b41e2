#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace burnish {

/// Objects that must be gone when nobody uses the server any more.
enum class LiveKind { kCall, kMesh, kSession, kUpload, kExport, kLiveSession, kStream };

inline constexpr std::array kLiveKinds = {
    LiveKind::kCall,   LiveKind::kMesh,        LiveKind::kSession, LiveKind::kUpload,
    LiveKind::kExport, LiveKind::kLiveSession, LiveKind::kStream};

/// Returns "call", "mesh", ...
std::string_view live_kind_name(LiveKind kind);

/// Returns how many objects of this kind live in the process.
int64_t live_count(LiveKind kind);

/// Goes into each counted object as a member.
class LiveObject {
 public:
  explicit LiveObject(LiveKind kind);
  ~LiveObject();
  LiveObject(const LiveObject&) = delete;
  LiveObject& operator=(const LiveObject&) = delete;

 private:
  const LiveKind kind_;
};

}  // namespace burnish
