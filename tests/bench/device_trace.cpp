#include "tests/bench/device_trace.h"

#include <algorithm>

#ifdef BURNISH_CUPTI
#include <cstdlib>
#include <cupti.h>
#endif

namespace burnish {

#ifdef BURNISH_CUPTI

static constexpr CUpti_ActivityKind kKinds[] = {CUPTI_ACTIVITY_KIND_CONCURRENT_KERNEL,
                                                CUPTI_ACTIVITY_KIND_MEMCPY};
static constexpr size_t kRoom = 1 << 20;  // bytes of records per delivery of CUPTI

static std::vector<TracedWork>& traced() {
  static std::vector<TracedWork> works;
  return works;
}

static void CUPTIAPI give_room(uint8_t** room, size_t* bytes, size_t* records_max) {
  *room = static_cast<uint8_t*>(std::aligned_alloc(8, kRoom));
  *bytes = kRoom;
  *records_max = 0;  // as many as fit
}

static void CUPTIAPI take_records(CUcontext, uint32_t, uint8_t* room, size_t, size_t bytes) {
  CUpti_Activity* record = nullptr;
  while (cuptiActivityGetNextRecord(room, bytes, &record) == CUPTI_SUCCESS) {
    if (record->kind == CUPTI_ACTIVITY_KIND_MEMCPY) {
      const auto* copy = reinterpret_cast<const CUpti_ActivityMemcpy6*>(record);
      traced().push_back({"copy", copy->start, copy->end});
    } else {
      const auto* kernel = reinterpret_cast<const CUpti_ActivityKernel10*>(record);
      traced().push_back({kernel->name, kernel->start, kernel->end});
    }
  }
  std::free(room);
}

std::vector<TracedWork> trace_device(const std::function<void()>& work) {
  static const bool is_ready =
      cuptiActivityRegisterCallbacks(give_room, take_records) == CUPTI_SUCCESS;
  if (!is_ready) return {};
  for (const CUpti_ActivityKind kind : kKinds) cuptiActivityEnable(kind);
  work();
  cuptiActivityFlushAll(CUPTI_ACTIVITY_FLAG_FLUSH_FORCED);
  for (const CUpti_ActivityKind kind : kKinds) cuptiActivityDisable(kind);
  std::vector<TracedWork> works;
  works.swap(traced());
  std::ranges::sort(works, {}, &TracedWork::start);
  return works;
}

#else

std::vector<TracedWork> trace_device(const std::function<void()>& work) {
  work();
  return {};
}

#endif

double microseconds_of(const std::vector<TracedWork>& works) {
  uint64_t busy = 0, end = 0;
  for (const TracedWork& work : works) {
    if (work.end > end) busy += work.end - std::max(work.start, end);
    end = std::max(work.end, end);
  }
  return 1e-3 * static_cast<double>(busy);
}

}  // namespace burnish
