#include "common/frame_codec/frame_body.h"

namespace burnish {

namespace {

size_t width_bytes_of_tile(const FrameLayout& layout, int tile) {
  return size_t{3} * width_bytes(layout.tile_size(tile));
}

Status check_sent_tiles(std::span<const uint8_t> sent, uint32_t sent_tiles) {
  uint32_t count = 0;
  for (const uint8_t flag : sent) {
    if (flag > 1) return data_loss("a tile is marked " + std::to_string(flag) + ", not 0 or 1");
    count += flag;
  }
  if (count == sent_tiles) return Status::ok();
  return data_loss(std::to_string(count) + " tiles are marked as sent, the header says " +
                   std::to_string(sent_tiles));
}

Result<std::array<size_t, kGroupStreams>> stream_sizes(std::span<const uint8_t> widths) {
  std::array<size_t, 16> groups_of_width = {};
  for (const uint8_t pair : widths) {
    ++groups_of_width[pair & 15];
    ++groups_of_width[pair >> 4];
  }
  std::array<size_t, kGroupStreams> sizes = {};
  for (int width = 0; width < 16; ++width) {
    if (groups_of_width[width] == 0) continue;
    if (width > kGroupWidthMax)
      return data_loss("a group has width " + std::to_string(width) + ", the largest is 6");
    const auto bytes = bytes_of_group(width);
    for (int s = 0; s < kGroupStreams; ++s) sizes[s] += groups_of_width[width] * bytes[s];
  }
  return sizes;
}

}  // namespace

void FrameBodyWriter::add_tile(int tile, std::span<const uint32_t> residuals) {
  sent_[tile] = 1;
  ++sent_tiles_;
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) groups_.add_axis(residuals.subspan(axis * size, size));
}

size_t FrameBodyWriter::byte_count() const {
  size_t count = sent_.size() + groups_.widths.size();
  for (const auto& stream : groups_.streams) count += stream.size();
  return count;
}

std::vector<uint8_t> FrameBodyWriter::bytes() const {
  std::vector<uint8_t> bytes = sent_;
  bytes.insert(bytes.end(), groups_.widths.begin(), groups_.widths.end());
  for (const auto& stream : groups_.streams)
    bytes.insert(bytes.end(), stream.begin(), stream.end());
  return bytes;
}

Result<FrameBodyReader> FrameBodyReader::open(const FrameLayout& layout, uint32_t sent_tiles,
                                              std::span<const uint8_t> bytes) {
  const auto take = [&bytes](size_t count) -> Result<std::span<const uint8_t>> {
    if (count > bytes.size())
      return data_loss("a stream has " + std::to_string(count) + " bytes, but only " +
                       std::to_string(bytes.size()) + " are left");
    const auto taken = bytes.first(count);
    bytes = bytes.subspan(count);
    return taken;
  };
  FrameBodyReader reader;
  ASSIGN_OR_RETURN(reader.sent_, take(layout.tile_count()));
  RETURN_IF_ERROR(check_sent_tiles(reader.sent_, sent_tiles));
  size_t all_width_bytes = 0;
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    if (reader.is_sent(tile)) all_width_bytes += width_bytes_of_tile(layout, tile);
  ASSIGN_OR_RETURN(reader.groups_.widths, take(all_width_bytes));
  ASSIGN_OR_RETURN(const auto sizes, stream_sizes(reader.groups_.widths));
  for (int s = 0; s < kGroupStreams; ++s) {
    ASSIGN_OR_RETURN(reader.groups_.streams[s], take(sizes[s]));
  }
  if (!bytes.empty())
    return data_loss(std::to_string(bytes.size()) + " bytes follow the last stream");
  return reader;
}

void FrameBodyReader::read_tile(std::span<uint32_t> residuals) {
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) groups_.read_axis(residuals.subspan(axis * size, size));
}

uint64_t body_bytes_max(const FrameLayout& layout) {
  uint64_t bytes = layout.tile_count();
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    bytes += width_bytes_of_tile(layout, tile) * (1 + 2 * kGroupValues * sizeof(uint32_t));
  return bytes;
}

}  // namespace burnish
