#include "server/solver/cuda/device/graphs.h"

namespace burnish::cuda {

Graphs::~Graphs() {
  for (const auto& [key, graph] : graphs_)
    if (graph != nullptr) cudaGraphExecDestroy(graph);
}

void Graphs::run(int key, const std::function<void()>& work) {
  if (!stream_.is_ok()) return;
  const auto [entry, is_first] = graphs_.try_emplace(key, nullptr);
  if (is_first) return work();
  if (entry->second == nullptr) entry->second = record(work);
  if (stream_.is_ok())
    stream_.check(cudaGraphLaunch(entry->second, stream_.get()), "starting a graph");
}

cudaGraphExec_t Graphs::record(const std::function<void()>& work) {
  cudaGraph_t graph = nullptr;
  cudaGraphExec_t executable = nullptr;
  if (!stream_.check(cudaStreamBeginCapture(stream_.get(), cudaStreamCaptureModeThreadLocal),
                     "recording a graph"))
    return nullptr;
  work();
  if (stream_.check(cudaStreamEndCapture(stream_.get(), &graph), "ending a graph"))
    stream_.check(cudaGraphInstantiate(&executable, graph, cudaGraphInstantiateFlagUseNodePriority),
                  "making a graph");
  if (graph != nullptr) cudaGraphDestroy(graph);
  return executable;
}

}  // namespace burnish::cuda
