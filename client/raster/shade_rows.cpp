#include "client/raster/shade_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "client/raster/fragment.h"
#include "client/raster/shade_math.h"
#include "common/base/limits.h"

namespace burnish {
namespace {

using Rgb = std::array<uint8_t, 3>;

uint8_t byte_of(float part) {
  return static_cast<uint8_t>(part * 255 + 0.5f);
}

Rgb rgb_of(ShadeVector colour) {
  return {byte_of(colour.x), byte_of(colour.y), byte_of(colour.z)};
}

Rgb background_of_row(int row, int height) {
  const float up = (static_cast<float>(height - row) - 0.5f) / static_cast<float>(height);
  return rgb_of(mixed(shade::kBackgroundLow, shade::kBackgroundHigh, up));
}

Rgb under_edges(ShadeVector colour, int edges) {
  for (int i = 0; i < edges; ++i) colour = mixed(colour, shade::kEdge, shade::kEdgeStrength);
  return rgb_of(colour);
}

/// Collects the fragments of a row, lights many of them at once, and hands each covered sample's
/// colour to a sink.
template <typename Sink>
class RowShader {
 public:
  RowShader(const ShadedScene& scene, const Visibility& visibility, Sink& sink)
      : scene_(scene),
        visibility_(visibility),
        places_(sample_places(visibility.samples)),
        sink_(sink) {}

  void shade(int row) {
    sink_.begin(row, background_of_row(row, visibility_.size.height));
    const SampleKey* keys = visibility_.keys.data() + visibility_.place(0, row);
    for (int x = 0; x < visibility_.size.width; ++x, keys += visibility_.samples)
      add_pixel(x, row, keys);
    light();
    sink_.end(row);
  }

 private:
  // One fragment for all samples that show the same triangle.
  void add_pixel(int x, int row, const SampleKey* keys) {
    int open = 0;
    for (int s = 0; s < visibility_.samples; ++s)
      if (keys[s] != kNothingSeen) open |= 1 << s;
    while (open != 0) {
      const uint32_t id = id_of_key(keys[std::countr_zero(static_cast<unsigned>(open))]);
      Fragment fragment{id, x, row, 0};
      for (int s = 0; s < visibility_.samples; ++s)
        if ((open >> s & 1) != 0 && id_of_key(keys[s]) == id) fragment.samples |= 1 << s;
      open &= ~fragment.samples;
      if (count_ == kShadeBatch) light();
      fragments_[count_++] = fragment;
    }
  }

  // Memory brings the triangles and their corners of all while the first ones are worked on.
  void light() {
    for (int i = 0; i < count_; ++i) prefetch_triangle(scene_, fragments_[i]);
    for (int i = 0; i < count_; ++i) prefetch_corners(scene_, fragments_[i]);
    for (int i = 0; i < count_; ++i)
      add_fragment(scene_, places_, fragments_[i], batch_, edges_[i]);
    light_batch(scene_.light, batch_);
    for (int i = 0; i < count_; ++i) {
      const Fragment& fragment = fragments_[i];
      const ShadeVector colour{batch_.red[i], batch_.green[i], batch_.blue[i]};
      const Rgb rgb = rgb_of(colour);
      for (int s = 0; s < visibility_.samples; ++s)
        if ((fragment.samples >> s & 1) != 0)
          sink_.put(fragment.x, s, scene_.wireframe ? under_edges(colour, edges_[i][s]) : rgb,
                    batch_, i);
    }
    batch_.count = count_ = 0;
  }

  const ShadedScene& scene_;
  const Visibility& visibility_;
  const SamplePlaces& places_;
  Sink& sink_;
  int count_ = 0;
  std::array<Fragment, kShadeBatch> fragments_{};
  ShadeBatch batch_{};
  std::array<EdgeCounts, kShadeBatch> edges_{};
};

/// Averages the samples of each pixel.
class AveragedRows {
 public:
  AveragedRows(Image& image, int samples) : image_(image), samples_(samples) {}

  void begin(int, const Rgb& background) {
    background_ = background;
    std::fill_n(covered_.begin(), image_.size.width, uint8_t{0});
    std::fill_n(sums_.begin(), image_.size.width, std::array<uint16_t, 3>{});
  }
  void put(int x, int, const Rgb& rgb, const ShadeBatch&, int) {
    for (int c = 0; c < 3; ++c) sums_[x][c] = static_cast<uint16_t>(sums_[x][c] + rgb[c]);
    ++covered_[x];
  }
  void end(int row) {
    const int shift =
        samples_ == 1 ? 0 : 2;  // a division for each byte takes longer than its light
    uint8_t* to = image_.rgb.data() + size_t{3} * row * image_.size.width;
    for (int x = 0; x < image_.size.width; ++x, to += 3) {
      const int open = samples_ - covered_[x];
      for (int c = 0; c < 3; ++c)
        to[c] = static_cast<uint8_t>((sums_[x][c] + open * background_[c] + samples_ / 2) >> shift);
    }
  }

 private:
  Image& image_;
  int samples_;
  Rgb background_{};
  std::array<std::array<uint16_t, 3>, kImageSidePixelsMax> sums_{};
  std::array<uint8_t, kImageSidePixelsMax> covered_{};
};

/// Keeps the samples.
class KeptSamples {
 public:
  KeptSamples(GBuffer& g_buffer, const Visibility& visibility)
      : g_buffer_(g_buffer), visibility_(visibility) {}

  void begin(int row, const Rgb& background) {
    row_ = g_buffer_.data() + visibility_.place(0, row);
    const size_t samples = size_t(visibility_.size.width) * visibility_.samples;
    std::fill_n(row_, samples, GBufferSample{.colour = background});
  }
  void put(int x, int s, const Rgb& rgb, const ShadeBatch& batch, int i) {
    const auto steps = [](float part) { return static_cast<int16_t>(std::lround(part * 32767)); };
    const auto part = [](float of) { return static_cast<uint16_t>(of * 65535 + 0.5f); };
    row_[x * visibility_.samples + s] = {
        {steps(batch.shown_x[i]), steps(batch.shown_y[i]), steps(batch.shown_z[i])},
        part(batch.strength[i]),
        part(batch.left[i]),
        rgb};
  }
  void end(int) {}

 private:
  GBuffer& g_buffer_;
  const Visibility& visibility_;
  GBufferSample* row_ = nullptr;
};

template <typename Sink>
void shade_into(const ShadedScene& scene, const Visibility& visibility, const RowRange& rows,
                Sink& sink) {
  RowShader<Sink> shader(scene, visibility, sink);
  for (int row = rows.first; row < rows.end; ++row) shader.shade(row);
}

}  // namespace

void shade_rows(const ShadedScene& scene, const Visibility& visibility, const RowRange& rows,
                Image& image) {
  AveragedRows sink(image, visibility.samples);
  shade_into(scene, visibility, rows, sink);
}

void shade_g_buffer(const ShadedScene& scene, const Visibility& visibility, const RowRange& rows,
                    GBuffer& g_buffer) {
  KeptSamples sink(g_buffer, visibility);
  shade_into(scene, visibility, rows, sink);
}

}  // namespace burnish
