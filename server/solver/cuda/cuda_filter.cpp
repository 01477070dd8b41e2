#include "server/solver/cuda/cuda_filter.h"

#include <mutex>
#include <optional>
#include <utility>

#include "common/base/heard_loop.h"
#include "common/denoise/filter_constants.h"
#include "common/denoise/normal_layer.h"
#include "common/denoise/ring_nearness.h"
#include "common/denoise/ring_sums.h"
#include "common/denoise/triangle_normals.h"
#include "common/denoise/unless_left.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/denoise/device_surface.h"
#include "server/solver/cuda/denoise/layer_passes.h"
#include "server/solver/cuda/denoise/ring_passes.h"
#include "server/solver/cuda/device/placement.h"

namespace burnish {

namespace cuda {

namespace {

constexpr int kUpdates = LayerOptions{}.updates;

class CudaFilter final : public SurfaceFilter {
 public:
  CudaFilter(int device, std::shared_ptr<const DenoiseSurface> surface)
      : surface_(std::move(surface)),
        stream_(device, Stream::Urgency::kBeside),
        device_surface_(stream_, *surface_),
        first_(stream_, triangles()),
        now_(stream_, triangles()),
        next_(stream_, triangles()),
        guides_(stream_, triangles()),
        measured_(stream_, triangles()),
        normals_(stream_, triangles()),
        offsets_(stream_, surface_->welded.incidence_count()),
        moves_(stream_, vertices()),
        layer_(stream_, vertices()),
        turned_(stream_, triangles()) {
    const auto normals = triangle_normals(surface_->welded);
    upload(stream_, first_.data(),
           std::span(reinterpret_cast<const float4*>(normals.data()), normals.size()));
    stream_.synchronize();
  }

  const Status& status() const { return stream_.status(); }

  Result<FilteredSurface> filter(const EdgeFilter& wanted, const Progress& progress) override {
    RETURN_IF_ERROR(check_edge_filter(wanted));
    const std::lock_guard lock(mutex_);
    ASSIGN_OR_RETURN(FilteredSurface filtered,
                     unless_left([&] { return filtered_here(wanted, progress); }));
    RETURN_IF_ERROR(stream_.status());
    return filtered;
  }

  uint64_t byte_count() const override {
    return device_surface_.byte_count() + first_.byte_count() + now_.byte_count() +
           next_.byte_count() + guides_.byte_count() + measured_.byte_count() +
           normals_.byte_count() + offsets_.byte_count() + moves_.byte_count() +
           layer_.byte_count() + turned_.byte_count();
  }

 private:
  size_t triangles() const { return surface_->welded.triangle_count(); }
  size_t vertices() const { return surface_->welded.vertex_count(); }

  FilteredSurface filtered_here(const EdgeFilter& wanted, const Progress& progress) {
    const LoopPart normals = {progress, "normals"}, layer = {progress, "layer"};
    weigh(wanted.kind, normals.of(0, 0.1));
    filter_normals(wanted, normals.of(0.1, 1));
    return make_layer(layer);
  }

  /// Makes the weights of places, on the processors, unless they are of this kind.
  void weigh(NormalFilterKind kind, const LoopPart& part) {
    if (weighed_ == kind) return;
    const auto normals = triangle_normals(surface_->welded, {}, part.of(0, 0.2));
    const auto nearness =
        ring_nearness(surface_->welded, surface_->rings, {normals.data(), normals.size()},
                      reach_of(kind), {}, part.of(0.2, 1));
    weighed_.reset();
    device_surface_.set_nearness(stream_, {nearness.data(), nearness.size()});
    if (stream_.synchronize()) weighed_ = kind;
  }

  // Waits after each pass: work that is left ends soon.
  void filter_normals(const EdgeFilter& wanted, const LoopPart& part) {
    copy(first_, now_);
    LoopProgress loop(part.progress, part.phase, part.begin, part.end);
    for (int pass = 0; pass < wanted.passes; ++pass) {
      if (!loop.goes_on(static_cast<double>(pass) / wanted.passes)) leave_cancelled_work();
      filter_once(wanted);
      stream_.synchronize();
    }
  }

  void filter_once(const EdgeFilter& wanted) {
    const Rings rings = device_surface_.rings();
    const bool is_guided = wanted.kind == NormalFilterKind::kEdges;
    if (is_guided) {
      measure_rings(stream_, rings, now_.data(), measured_.data());
      pick_rings(stream_, rings, measured_.data(), kGuideSharpness, guides_.data());
    }
    sum_rings(stream_, rings, now_.data(), is_guided ? guides_.data() : now_.data(),
              steepness_of(wanted.sigma()), next_.data());
    std::swap(now_, next_);
  }

  FilteredSurface make_layer(const LoopPart& part) {
    LoopProgress loop(part.progress, part.phase, part.begin, part.end);
    ask_before(loop);
    const Places places = device_surface_.places();
    const LayerArrays arrays = {offsets_.data(), guides_.data(), moves_.data(), layer_.data(),
                                turned_.data()};
    begin_layer(stream_, places, now_.data(), arrays);
    for (int update = 0; update < kUpdates; ++update) update_layer(stream_, places, arrays);
    end_layer(stream_, places, arrays);
    take_normals(stream_, static_cast<int64_t>(triangles()), now_.data(), normals_.data());
    FilteredSurface filtered;
    filtered.normals = on_host(normals_);
    filtered.layer = on_host(layer_);
    return filtered;
  }

  std::vector<Vec3f> on_host(const DeviceArray<Float3>& array) {
    static_assert(sizeof(Vec3f) == sizeof(Float3));
    std::vector<Vec3f> host(array.size());
    array.download(stream_, std::span(reinterpret_cast<Float3*>(host.data()), host.size()));
    return host;
  }

  void copy(const DeviceArray<float4>& from, const DeviceArray<float4>& to) {
    if (stream_.is_ok() && from.size() > 0)
      stream_.check(cudaMemcpyAsync(to.data(), from.data(), from.byte_count(),
                                    cudaMemcpyDeviceToDevice, stream_.get()),
                    "copying on the device");
  }

  const std::shared_ptr<const DenoiseSurface> surface_;
  std::mutex mutex_;  // of all below
  Stream stream_;
  DeviceSurface device_surface_;
  DeviceArray<float4> first_, now_, next_, guides_, measured_;  // the layer's planes in guides_
  DeviceArray<Float3> normals_;
  DeviceArray<float> offsets_;
  DeviceArray<float4> moves_;
  DeviceArray<Float3> layer_;
  DeviceArray<uint8_t> turned_;
  std::optional<NormalFilterKind> weighed_;
};

}  // namespace

}  // namespace cuda

Result<std::unique_ptr<SurfaceFilter>> make_cuda_filter(
    std::shared_ptr<const DenoiseSurface> surface) {
  RETURN_IF_ERROR(cuda_device().status());
  ASSIGN_OR_RETURN(auto filter, unless_left([&] {
                     const int device = least_loaded(cuda_memory_by_device());
                     return std::make_unique<cuda::CudaFilter>(device, std::move(surface));
                   }));
  RETURN_IF_ERROR(filter->status());
  return std::unique_ptr<SurfaceFilter>(std::move(filter));
}

}  // namespace burnish
