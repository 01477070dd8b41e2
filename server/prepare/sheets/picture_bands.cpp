#include "server/prepare/sheets/picture_bands.h"

#include <algorithm>

namespace burnish {

TextureBand::TextureBand(const ScratchFile& file, const TiledLevel& level)
    : file_(file), level_(level), texels_(level.band_bytes() / sizeof(Rgba8)) {}

Status TextureBand::read(int64_t band) {
  number_ = band;
  return file_.read(offset(), as_bytes(texels_));
}

Status TextureBand::write() const {
  return file_.write(
      offset(), {reinterpret_cast<const uint8_t*>(texels_.data()), texels_.size() * sizeof(Rgba8)});
}

void TextureBand::clear(int64_t band) {
  number_ = band;
  std::ranges::fill(texels_, Rgba8{});
}

Status BandWriter::put(const PixelRun& run) {
  if (band_.number_of(run.y) != band_.number()) RETURN_IF_ERROR(go_to(band_.number_of(run.y)));
  uint32_t x = run.first;
  for (const Rgba8& pixel : run.pixels) {
    band_.at(x, run.y) = pixel;
    x += run.step;
  }
  return Status::ok();
}

Status BandWriter::flush() {
  if (band_.number() < 0) return Status::ok();
  last_ = std::max(last_, band_.number());
  return band_.write();
}

// An interlaced picture comes back to a band.
Status BandWriter::go_to(int64_t number) {
  RETURN_IF_ERROR(flush());
  if (number <= last_) return band_.read(number);
  band_.clear(number);
  return Status::ok();
}

}  // namespace burnish
