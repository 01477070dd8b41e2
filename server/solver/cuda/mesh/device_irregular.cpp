#include "server/solver/cuda/mesh/device_irregular.h"

#include "server/solver/cuda/mesh/long_rows.h"

namespace burnish::cuda {

static std::vector<int32_t> places_of(const std::vector<int32_t>& sources, int32_t cells) {
  std::vector<int32_t> places(sources.size());
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < sources.size(); ++k) places[k] = place_of_number(sources[k], cells);
  return places;
}

DeviceIrregular::DeviceIrregular(Stream& stream, const Stencil& stencil, int32_t cells) {
  if (stencil.irregular.count() == 0) return;
  const LongRowTails tails = long_row_tails(stencil);
  corner_ = {stream, stencil.irregular.corner};
  sum_start_ = {stream, stencil.irregular.sum_start};
  source_start_ = {stream, stencil.irregular.source_start};
  source_ = {stream, places_of(stencil.irregular.source, cells)};
  cell_ = {stream, stencil.irregular_cells.cell};
  entry_ = DeviceArray<PairEntries>::copy_of(stream, stencil.irregular_cells.entry);
  long_start_ = {stream, tails.start};
  long_column_ = {stream, tails.column};
}

Irregular DeviceIrregular::view() const {
  return {static_cast<int32_t>(corner_.size()),
          corner_.data(),
          sum_start_.data(),
          source_start_.data(),
          source_.data(),
          static_cast<int32_t>(cell_.size()),
          cell_.data(),
          entry_.data()};
}

LongRows DeviceIrregular::long_rows() const {
  return {long_start_.data(), long_column_.data(), static_cast<int32_t>(long_column_.size())};
}

uint64_t DeviceIrregular::byte_count() const {
  return corner_.byte_count() + source_.byte_count() + cell_.byte_count() +
         long_start_.byte_count() + long_column_.byte_count() + sum_start_.byte_count() +
         source_start_.byte_count() + entry_.byte_count();
}

}  // namespace burnish::cuda
