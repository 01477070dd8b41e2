#include "common/denoise/surface_filter.h"

#include <utility>

namespace burnish {
namespace {

class ProcessorFilter final : public SurfaceFilter {
 public:
  explicit ProcessorFilter(std::shared_ptr<const DenoiseSurface> surface)
      : surface_(std::move(surface)) {}

  Result<FilteredSurface> filter(const EdgeFilter& wanted, const Progress& progress) override {
    FilteredSurface filtered;
    const auto keep_last = [&](int pass, std::span<const NormalAndArea> normals) {
      if (pass < wanted.passes) return;
      filtered.normals.resize(normals.size());
      for (size_t t = 0; t < normals.size(); ++t)
        filtered.normals[t] = normal_of(normals[t]).cast<float>();
    };
    ASSIGN_OR_RETURN(filtered.layer, denoise_layer(*surface_, wanted, {}, progress, keep_last));
    return filtered;
  }

  uint64_t byte_count() const override { return 0; }

 private:
  const std::shared_ptr<const DenoiseSurface> surface_;
};

}  // namespace

std::unique_ptr<SurfaceFilter> make_processor_filter(
    std::shared_ptr<const DenoiseSurface> surface) {
  return std::make_unique<ProcessorFilter>(std::move(surface));
}

}  // namespace burnish
