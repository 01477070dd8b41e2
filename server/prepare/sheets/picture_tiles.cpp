#include "server/prepare/sheets/picture_tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/sheets/catmull_rom.h"

namespace burnish {

namespace {

constexpr Rgba8 kWhite = {255, 255, 255, 255};

PictureTiles::Place place_of(const PictureSize& size, uint64_t begin) {
  return {begin, size.width, size.height};
}

uint64_t bytes_of(const PictureTiles::Place& place) {
  const uint64_t bands = (place.height + place.tile_rows() - 1) / place.tile_rows();
  return bands * place.band_bytes();
}

std::span<uint8_t> as_bytes(std::span<Rgba8> texels) {
  return {reinterpret_cast<uint8_t*>(texels.data()), texels.size_bytes()};
}

/// Puts the rows of a picture into its tiles. Keeps one row of tiles in memory.
class BandWriter {
 public:
  BandWriter(const ScratchFile& file, const PictureTiles::Place& place)
      : file_(file), place_(place), texels_(place.band_bytes() / sizeof(Rgba8)) {}

  Status put(const PixelRun& run) {
    if (const uint32_t band = run.y / place_.tile_rows(); band != band_)
      RETURN_IF_ERROR(go_to(band));
    const size_t tile_texels = place_.tile_bytes() / sizeof(Rgba8);
    Rgba8* row = texels_.data() + size_t{run.y % place_.tile_rows()} * PictureTiles::kTileSide;
    uint32_t x = run.first;
    for (const Rgba8& pixel : run.pixels) {
      row[x / PictureTiles::kTileSide * tile_texels + x % PictureTiles::kTileSide] = pixel;
      x += run.step;
    }
    return Status::ok();
  }

  Status flush() {
    if (!band_) return Status::ok();
    last_ = std::max(last_, int64_t{*band_});
    return file_.write(offset(), as_bytes(texels_));
  }

 private:
  uint64_t offset() const { return place_.begin + *band_ * place_.band_bytes(); }

  // An interlaced picture comes back to a band.
  Status go_to(uint32_t band) {
    RETURN_IF_ERROR(flush());
    band_ = band;
    if (band <= last_) return file_.read(offset(), as_bytes(texels_));
    std::ranges::fill(texels_, Rgba8{});
    return Status::ok();
  }

  const ScratchFile& file_;
  const PictureTiles::Place& place_;
  std::vector<Rgba8> texels_;
  std::optional<uint32_t> band_;
  int64_t last_ = -1;  // that was written
};

double wrapped(double i, uint32_t size, TextureWrap wrap) {
  if (wrap == TextureWrap::kClamp) return std::clamp(i, 0.0, size - 1.0);
  const double period = wrap == TextureWrap::kMirror ? 2.0 * size : size;
  const double rest = i - period * std::floor(i / period);
  return rest < size ? rest : period - 1 - rest;
}

/// Returns the texels that four taps take along one axis.
std::array<uint32_t, 4> taps_of(double first, uint32_t size, TextureWrap wrap) {
  std::array<uint32_t, 4> taps;
  for (int k = 0; k < 4; ++k) {
    const double i = first + k;
    const bool is_inside = i >= 0 && i < size;
    taps[k] = static_cast<uint32_t>(is_inside ? i : wrapped(i, size, wrap));
  }
  return taps;
}

}  // namespace

Result<PictureTiles> PictureTiles::create(const std::filesystem::path& folder, size_t pictures) {
  ASSIGN_OR_RETURN(ScratchFile file, ScratchFile::create(folder));
  return PictureTiles(std::move(file), pictures);
}

uint64_t PictureTiles::scratch_bytes(const PictureSize& size) {
  return bytes_of(place_of(size, 0));
}

uint64_t PictureTiles::memory_bytes(const PictureSize& size) {
  return size.decoding_bytes + place_of(size, 0).band_bytes();
}

Status PictureTiles::decode(uint32_t picture, std::span<const uint8_t> file,
                            const std::string& name,
                            const std::function<Status(const PictureSize&)>& admit,
                            const std::function<bool()>& goes_on) {
  Place& place = places_[picture];
  std::optional<BandWriter> writer;
  Status written;
  const auto begin = [&](const PictureSize& size) {
    RETURN_IF_ERROR(admit(size));
    const Place wanted = place_of(size, bytes_);
    RETURN_IF_ERROR(file_.reserve(bytes_ + bytes_of(wanted)));
    bytes_ += bytes_of(wanted);
    place = wanted;
    writer.emplace(file_, place);
    return Status::ok();
  };
  const auto take = [&](const PixelRun& run) {
    if (written.is_ok()) written = writer->put(run);
  };
  const Status status =
      read_picture_rows(file, name, {begin, take, [&] { return written.is_ok() && goes_on(); }});
  if (written.is_ok() && writer) written = writer->flush();
  if (!written.is_ok()) return resource_exhausted(written.message()).with_context(name);
  if (!status.is_ok() && status.code() != StatusCode::kCancelled && !place.is_empty())
    RETURN_IF_ERROR(fill_gaps(place));
  return status;
}

// White leaves the factor of a material as it is.
Status PictureTiles::fill_gaps(const Place& place) const {
  std::vector<Rgba8> band(place.band_bytes() / sizeof(Rgba8));
  for (uint64_t at = place.begin; at < place.begin + bytes_of(place); at += place.band_bytes()) {
    RETURN_IF_ERROR(file_.read(at, as_bytes(band)));
    std::ranges::replace(band, Rgba8{}, kWhite);
    RETURN_IF_ERROR(file_.write(at, as_bytes(band)));
  }
  return Status::ok();
}

Status PictureTiles::read_tile(uint32_t picture, uint32_t column, uint32_t row,
                               std::span<uint8_t> bytes) const {
  const Place& place = places_[picture];
  return file_.read(place.begin + row * place.band_bytes() + column * place.tile_bytes(), bytes);
}

const Rgba8* PictureSampler::tile(uint32_t picture, uint32_t column, uint32_t row) {
  const size_t index = (column % kSlotColumns + row * kSlotColumns + picture * 97) % kSlots;
  Slot& slot = slots_[index];
  if (slot.picture == picture && slot.column == column && slot.row == row)
    return slot.texels.data();
  slot = {picture, column, row, std::move(slot.texels)};
  slot.texels.resize(tiles_.place(picture).tile_bytes() / sizeof(Rgba8));
  const Status read = tiles_.read_tile(picture, column, row, as_bytes(slot.texels));
  if (!read.is_ok() && status_.is_ok()) status_ = read;
  return slot.texels.data();
}

Rgba8 PictureSampler::texel(uint32_t picture, uint32_t x, uint32_t y) {
  constexpr uint32_t kSide = PictureTiles::kTileSide;
  const uint32_t rows = tiles_.place(picture).tile_rows();
  return tile(picture, x / kSide, y / rows)[size_t{y % rows} * kSide + x % kSide];
}

Texel PictureSampler::sample(uint32_t picture, double x, double y, const TextureWraps& wraps) {
  const PictureTiles::Place& place = tiles_.place(picture);
  const double left = std::floor(x - 0.5);
  const double top = std::floor(y - 0.5);
  const auto columns = taps_of(left - 1, place.width, wraps.u);
  const auto rows = taps_of(top - 1, place.height, wraps.v);
  return filtered_by_catmull_rom(x - 0.5 - left, y - 0.5 - top, [&](int row, int column) {
    return texel(picture, columns[column], rows[row]);
  });
}

}  // namespace burnish
