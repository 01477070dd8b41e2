#include "tests/bench/device_trace.h"

#include <algorithm>

#ifdef BURNISH_CUPTI
#include <cstdlib>
#include <cupti.h>
#endif

namespace burnish {

#ifdef BURNISH_CUPTI

static constexpr size_t kRoom = 1 << 20;  // bytes of records that CUPTI hands over at once

static std::vector<TracedKernel>& traced() {
  static std::vector<TracedKernel> kernels;
  return kernels;
}

static void CUPTIAPI give_room(uint8_t** room, size_t* bytes, size_t* records_max) {
  *room = static_cast<uint8_t*>(std::aligned_alloc(8, kRoom));
  *bytes = kRoom;
  *records_max = 0;  // as many as there is room for
}

static void CUPTIAPI take_records(CUcontext, uint32_t, uint8_t* room, size_t, size_t bytes) {
  CUpti_Activity* record = nullptr;
  while (cuptiActivityGetNextRecord(room, bytes, &record) == CUPTI_SUCCESS) {
    const auto* kernel = reinterpret_cast<const CUpti_ActivityKernel10*>(record);
    traced().push_back({kernel->name, kernel->start, kernel->end});
  }
  std::free(room);
}

std::vector<TracedKernel> trace_kernels(const std::function<void()>& work) {
  static const bool is_ready =
      cuptiActivityRegisterCallbacks(give_room, take_records) == CUPTI_SUCCESS;
  if (!is_ready) return {};
  cuptiActivityEnable(CUPTI_ACTIVITY_KIND_CONCURRENT_KERNEL);
  work();
  cuptiActivityFlushAll(CUPTI_ACTIVITY_FLAG_FLUSH_FORCED);
  cuptiActivityDisable(CUPTI_ACTIVITY_KIND_CONCURRENT_KERNEL);
  std::vector<TracedKernel> kernels;
  kernels.swap(traced());
  std::ranges::sort(kernels, {}, &TracedKernel::start);
  return kernels;
}

#else

std::vector<TracedKernel> trace_kernels(const std::function<void()>& work) {
  work();
  return {};
}

#endif

double microseconds_of(const std::vector<TracedKernel>& kernels) {
  if (kernels.empty()) return 0;
  uint64_t end = 0;
  for (const TracedKernel& kernel : kernels) end = std::max(end, kernel.end);
  return 1e-3 * static_cast<double>(end - kernels.front().start);
}

}  // namespace burnish
