#include "server/solver/cuda/device_depth.h"

#include "server/solver/cuda/device/read_bits.h"

namespace burnish::cuda {

DeviceDepth::DeviceDepth(Stream& stream, const Topology& topology, Digits digits)
    : packed_(stream, topology.entry_count),
      rest_(stream, digits >= Digits::kOfAFloat ? topology.entry_count : 0),
      remainder_(stream, digits >= Digits::kOfADouble ? topology.entry_count : 0),
      long_entries_(stream, topology.rows.long_rows.entry_count),
      diagonal_(stream, topology.corner_count),
      inverse_diagonal_(stream, topology.corner_count),
      x_(stream, topology.corner_count),
      f_(stream, topology.corner_count),
      r_(stream, topology.corner_count),
      view_{
          topology,          {packed_.data(), diagonal_.data(), long_entries_.data(), rest_.data()},
          remainder_.data(), inverse_diagonal_.data(),
          x_.data(),         f_.data(),
          r_.data()} {}

void DeviceDepth::read(Stream& stream, const std::string& name, std::vector<NamedBits>& to) const {
  read_bits(stream, name + ": S", packed_, to);
  read_bits(stream, name + ": rests of S", rest_, to);
  read_bits(stream, name + ": remainders of S", remainder_, to);
  read_bits(stream, name + ": long rows of S", long_entries_, to);
  read_bits(stream, name + ": diagonal of S", diagonal_, to);
  read_bits(stream, name + ": inverse diagonal", inverse_diagonal_, to);
}

uint64_t DeviceDepth::byte_count() const {
  return packed_.byte_count() + rest_.byte_count() + remainder_.byte_count() +
         long_entries_.byte_count() + diagonal_.byte_count() + inverse_diagonal_.byte_count() +
         x_.byte_count() + f_.byte_count() + r_.byte_count();
}

}  // namespace burnish::cuda
