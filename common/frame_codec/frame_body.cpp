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

}  // namespace

void FrameBodyWriter::add_tile(int tile, std::span<const uint32_t> residuals) {
  sent_[tile] = 1;
  ++sent_tiles_;
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) groups_.add_axis(residuals.subspan(axis * size, size));
}

size_t FrameBodyWriter::byte_count() const {
  return sent_.size() + groups_.byte_count();
}

std::vector<uint8_t> FrameBodyWriter::bytes() const {
  std::vector<uint8_t> bytes = sent_;
  groups_.append_to(bytes);
  return bytes;
}

Result<FrameBodyReader> FrameBodyReader::open(const FrameLayout& layout, uint32_t sent_tiles,
                                              std::span<const uint8_t> bytes) {
  FrameBodyReader reader;
  ASSIGN_OR_RETURN(reader.sent_, take_stream(bytes, layout.tile_count()));
  RETURN_IF_ERROR(check_sent_tiles(reader.sent_, sent_tiles));
  size_t all_width_bytes = 0;
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    if (reader.is_sent(tile)) all_width_bytes += width_bytes_of_tile(layout, tile);
  ASSIGN_OR_RETURN(reader.groups_, GroupUnpacker::open(all_width_bytes, bytes));
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
