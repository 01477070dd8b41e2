#include "server/prepare/sheets/picture_tiles.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "server/prepare/sheets/picture_bands.h"

namespace burnish {

namespace {

constexpr Rgba8 kWhite = {255, 255, 255, 255};

/// Returns the levels of a picture, one behind the other.
std::vector<TiledLevel> levels_of(const PictureSize& size, uint64_t begin) {
  std::vector<TiledLevel> levels = {{begin, size.width, size.height}};
  while (levels.back().width > 1 || levels.back().height > 1) {
    const TiledLevel& finer = levels.back();
    levels.push_back({finer.end(), std::max(1U, finer.width / 2), std::max(1U, finer.height / 2)});
  }
  return levels;
}

Rgba8 mean_of(const std::array<Rgba8, 4>& colours) {
  Rgba8 mean;
  for (size_t i = 0; i < mean.size(); ++i)
    mean[i] = static_cast<uint8_t>(
        (colours[0][i] + colours[1][i] + colours[2][i] + colours[3][i] + 2) / 4);
  return mean;
}

}  // namespace

Result<PictureTiles> PictureTiles::create(const std::filesystem::path& folder, size_t pictures) {
  ASSIGN_OR_RETURN(ScratchFile file, ScratchFile::create(folder));
  return PictureTiles(std::move(file), pictures);
}

uint64_t PictureTiles::scratch_bytes(const PictureSize& size) {
  return levels_of(size, 0).back().end();
}

uint64_t PictureTiles::memory_bytes(const PictureSize& size) {
  return size.decoding_bytes + 3 * levels_of(size, 0).front().band_bytes();
}

Status PictureTiles::decode(uint32_t picture, std::span<const uint8_t> file,
                            const std::string& name,
                            const std::function<Status(const PictureSize&)>& admit,
                            const std::function<bool()>& goes_on) {
  std::vector<TiledLevel>& levels = levels_[picture];
  std::optional<BandWriter> writer;
  Status written;
  const auto begin = [&](const PictureSize& size) {
    RETURN_IF_ERROR(admit(size));
    auto wanted = levels_of(size, bytes_);
    RETURN_IF_ERROR(file_.reserve(wanted.back().end()));
    bytes_ = wanted.back().end();
    levels = std::move(wanted);
    writer.emplace(file_, levels.front());
    return Status::ok();
  };
  const auto take = [&](const PixelRun& run) {
    if (written.is_ok()) written = writer->put(run);
  };
  const Status status =
      read_picture_rows(file, name, {begin, take, [&] { return written.is_ok() && goes_on(); }});
  if (written.is_ok() && writer) written = writer->flush();
  if (!written.is_ok()) return resource_exhausted(written.message()).with_context(name);
  if (levels.empty() || status.code() == StatusCode::kCancelled) return status;
  if (!status.is_ok()) RETURN_IF_ERROR(fill_gaps(levels.front()));
  for (size_t level = 1; level < levels.size(); ++level)
    RETURN_IF_ERROR(halve(levels[level - 1], levels[level], goes_on));
  return status;
}

Status PictureTiles::halve(const TiledLevel& finer, const TiledLevel& coarser,
                           const std::function<bool()>& goes_on) const {
  TextureBand band(file_, finer);
  BandWriter writer(file_, coarser);
  std::vector<Rgba8> row(coarser.width);
  for (uint32_t y = 0; y < coarser.height; ++y) {
    if (!goes_on()) return cancelled("halving a picture was cancelled");
    const uint32_t top = 2 * y;  // a row of tiles has both rows: their number is even, or it is one
    const uint32_t bottom = std::min(top + 1, finer.height - 1);
    if (band.number_of(top) != band.number()) RETURN_IF_ERROR(band.read(band.number_of(top)));
    for (uint32_t x = 0; x < coarser.width; ++x) {
      const uint32_t right = std::min(2 * x + 1, finer.width - 1);
      row[x] = mean_of({band.at(2 * x, top), band.at(right, top), band.at(2 * x, bottom),
                        band.at(right, bottom)});
    }
    RETURN_IF_ERROR(writer.put({.y = y, .pixels = row}));
  }
  return writer.flush();
}

// White leaves the factor of a material as it is.
Status PictureTiles::fill_gaps(const TiledLevel& level) const {
  TextureBand band(file_, level);
  for (int64_t number = 0; number <= band.number_of(level.height - 1); ++number) {
    RETURN_IF_ERROR(band.read(number));
    std::ranges::replace(band.texels(), Rgba8{}, kWhite);
    RETURN_IF_ERROR(band.write());
  }
  return Status::ok();
}

Status PictureTiles::read_tile(const TiledLevel& level, uint32_t column, uint32_t row,
                               std::span<uint8_t> bytes) const {
  return file_.read(level.begin + row * level.band_bytes() + column * level.tile_bytes(), bytes);
}

}  // namespace burnish
