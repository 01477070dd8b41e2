#include "server/solver/cuda/device/branch.h"

namespace burnish::cuda {

static void put_after(Stream& later, Stream& earlier, cudaEvent_t event) {
  if (!later.is_ok() || !earlier.is_ok()) return;
  earlier.check(cudaEventRecord(event, earlier.get()), "marking a stream");
  later.check(cudaStreamWaitEvent(later.get(), event), "waiting for a stream");
}

Branch::Branch(Stream& trunk) : trunk_(trunk), stream_(trunk.device(), Stream::Urgency::kBeside) {
  for (cudaEvent_t* event : {&forked_, &joined_})
    stream_.check(cudaEventCreateWithFlags(event, cudaEventDisableTiming), "creating an event");
  trunk_.check(stream_.status());
}

Branch::~Branch() {
  for (const cudaEvent_t event : {forked_, joined_})
    if (event != nullptr) cudaEventDestroy(event);
}

void Branch::fork() {
  stream_.share_memory(trunk_.shared_percent());
  put_after(stream_, trunk_, forked_);
}

void Branch::join() {
  put_after(trunk_, stream_, joined_);
  trunk_.check(stream_.status());
}

}  // namespace burnish::cuda
