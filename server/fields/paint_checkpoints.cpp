#include "server/fields/paint_checkpoints.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <xxhash.h>

namespace burnish {

// Part of the hash. A program that paints differently takes another number and finds no checkpoint.
static constexpr uint64_t kPaintVersion = 1;
static constexpr size_t kCheckpointsMax = 64;

uint64_t begin_series(const PreparedMesh& prepared) {
  return XXH3_64bits_withSeed(prepared.cells.data(), prepared.cells.size_bytes(), kPaintVersion);
}

uint64_t extend_series(uint64_t series, uint64_t stroke_hash) {
  return XXH3_64bits_withSeed(&stroke_hash, sizeof stroke_hash, series);
}

uint64_t hash_of(const Stroke& stroke) {
  // β is layer 0, so strokes of β keep the hashes that they had before there were layers.
  // So do strokes that paint through walls, as all did once.
  static constexpr size_t kFallOffs = 4, kConnected = 1 << 16;
  const size_t kind = static_cast<size_t>(stroke.brush.fall_off) +
                      kFallOffs * layer_of(stroke.brush) +
                      (stroke.brush.connected ? kConnected : 0);
  const double brush[] = {stroke.brush.radius, stroke.brush.strength, stroke.brush.beta,
                          static_cast<double>(kind)};
  return XXH3_64bits_withSeed(stroke.path.data(), stroke.path.size() * sizeof(Vec3d),
                              XXH3_64bits(brush, sizeof brush));
}

uint64_t hash_of(const SetCellFields& cells) {
  uint64_t hash = layer_of(cells.target).value();
  for (const SetCellFields::Cell& cell : cells.cells) {
    const double values[] = {double(cell.cell.x()), double(cell.cell.y()), double(cell.cell.z()),
                             cell.beta};
    hash = XXH3_64bits_withSeed(values, sizeof values, hash);
  }
  return hash;
}

bool PaintCheckpoints::is_worth_keeping(uint64_t strokes, uint64_t newest) {
  const uint64_t distance = strokes < newest ? newest - strokes : strokes - newest;
  return strokes % std::max(uint64_t{1}, std::bit_floor(distance) / 2) == 0;
}

void PaintCheckpoints::add(PaintCheckpoint checkpoint) {
  std::erase_if(checkpoints_, [&](const PaintCheckpoint& other) {
    return other.series == checkpoint.series ||
           !is_worth_keeping(other.strokes, checkpoint.strokes);
  });
  if (checkpoints_.size() == kCheckpointsMax) checkpoints_.erase(checkpoints_.begin());
  checkpoints_.push_back(std::move(checkpoint));
}

const PaintCheckpoint* PaintCheckpoints::find(std::span<const uint64_t> series,
                                              size_t strokes_min) const {
  const PaintCheckpoint* best = nullptr;
  for (const PaintCheckpoint& checkpoint : checkpoints_) {
    const uint64_t strokes = checkpoint.strokes;
    if (strokes <= strokes_min || strokes >= series.size()) continue;
    if (series[strokes] != checkpoint.series) continue;
    if (!best || strokes > best->strokes) best = &checkpoint;
  }
  return best;
}

uint64_t PaintCheckpoints::byte_count() const {
  uint64_t bytes = 0;
  for (const PaintCheckpoint& checkpoint : checkpoints_)
    bytes += checkpoint.painted.cells.size() * (sizeof(int32_t) + 2 * sizeof(float));
  return bytes;
}

// The bytes: a hash of the rest, then the cells, their values, weights and perhaps layers.

template <typename T>
static void append(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <typename T>
static std::vector<T> take(std::string_view& bytes, size_t count) {
  std::vector<T> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

// Paint of β alone has no layers, as journals of earlier versions have it.
static constexpr XXH64_hash_t kSeedOfLayers = 1;

std::string painted_to_bytes(const PaintedCells& painted) {
  std::string body;
  append(body, painted.cells);
  append(body, painted.value);
  append(body, painted.weight);
  append(body, painted.layer);
  const uint64_t hash =
      XXH3_64bits_withSeed(body.data(), body.size(), painted.layer.empty() ? 0 : kSeedOfLayers);
  return std::string(reinterpret_cast<const char*>(&hash), sizeof hash) + body;
}

static Status check_painted(const PaintedCells& painted, size_t cell_count) {
  for (const int32_t cell : painted.cells)
    if (cell < 0 || static_cast<size_t>(cell) >= cell_count)
      return data_loss("stored paint names cell " + std::to_string(cell) + " of " +
                       std::to_string(cell_count));
  for (const uint8_t layer : painted.layer)
    if (layer >= kPaintLayers)
      return data_loss("stored paint is of kind " + std::to_string(layer) + " of " +
                       std::to_string(kPaintLayers));
  return Status::ok();
}

Result<PaintedCells> painted_from_bytes(std::string_view bytes, size_t cell_count) {
  uint64_t hash = 0;
  if (bytes.size() < sizeof hash)
    return data_loss("stored paint of " + std::to_string(bytes.size()) + " bytes is cut off");
  std::memcpy(&hash, bytes.data(), sizeof hash);
  bytes.remove_prefix(sizeof hash);
  const bool has_layers = XXH3_64bits_withSeed(bytes.data(), bytes.size(), kSeedOfLayers) == hash;
  if (!has_layers && XXH3_64bits(bytes.data(), bytes.size()) != hash)
    return data_loss("stored paint is damaged");
  const size_t bytes_per_cell = sizeof(int32_t) + 2 * sizeof(float) + (has_layers ? 1 : 0);
  if (bytes.size() % bytes_per_cell != 0)
    return data_loss("stored paint of " + std::to_string(bytes.size()) + " bytes is cut off");
  const size_t count = bytes.size() / bytes_per_cell;
  PaintedCells painted;
  painted.cells = take<int32_t>(bytes, count);
  painted.value = take<float>(bytes, count);
  painted.weight = take<float>(bytes, count);
  if (has_layers) painted.layer = take<uint8_t>(bytes, count);
  RETURN_IF_ERROR(check_painted(painted, cell_count));
  return painted;
}

}  // namespace burnish
