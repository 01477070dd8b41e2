#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "common/base/scratch_vector.h"
#include "common/base/types.h"
#include "common/mesh/reading/text_scanner.h"

namespace burnish {

/// Returns the next three numbers of the line; nothing if they are none.
std::optional<std::array<float, 3>> next_colour(TextScanner& scanner);

/// Returns the larger of a number and the channels of a colour. NaN counts as nothing.
inline float largest_channel(float largest, const std::array<float, 3>& rgb) {
  for (const float channel : rgb)
    if (channel > largest) largest = channel;
  return largest;
}

/// Returns by how much the channels of a file are multiplied: its largest channel decides. A little
/// above 1 is still 1.
inline float colour_scale(float largest) {
  constexpr float kRounded = 1.5F;
  return largest > kRounded ? 1.0F : 255.0F;
}
uint8_t colour_byte(float channel, float scale);

/// Collects the vertex colours of OBJ and OFF. These formats do not say whether colours range to 1
/// or to 255; the largest value of the file decides, once all are read.
class TextColours {
 public:
  explicit TextColours(const ScratchSpace& space) : colours_(space) {}

  /// Sets the colour of vertex number `vertex`; vertices in between are white.
  void set(size_t vertex, const std::array<float, 3>& rgb);

  /// Leaves `result` empty if no vertex had a colour, else has one for each of `vertices` in it.
  template <typename Colours>
  void finish(size_t vertices, Colours& result) const {
    if (colours_.size() == 0) return;
    result.resize(vertices, Rgba8{255, 255, 255, 255});
    for (size_t v = 0; v < colours_.size(); ++v) set_known(colours_[v], result[v]);
  }

 private:
  static constexpr float kUnset = -1;

  void set_known(const std::array<float, 3>& from, Rgba8& to) const;

  ScratchVector<std::array<float, 3>> colours_;
  float largest_ = 0;
};

}  // namespace burnish
