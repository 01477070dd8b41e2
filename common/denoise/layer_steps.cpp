#include "common/denoise/layer_steps.h"

#include "common/base/dispatch.h"

namespace burnish {

[[gnu::always_inline]] static inline float along(Float4 normal, Float4 way) {
  const Float4 product = normal * way;
  return product[0] + product[1] + product[2];
}

BURNISH_DISPATCH void measure_centres(const LayerField& field, size_t begin, size_t end) {
  for (size_t t = begin; t < end; ++t) {
    const Triangle& at = field.triangles[t];
    const Float4 sum = field.moves[at[0]] + field.moves[at[1]] + field.moves[at[2]];
    field.planes[t][3] = along(field.planes[t], sum) * (1.f / 3);
  }
}

BURNISH_DISPATCH void pull_places(const LayerField& field, size_t begin, size_t end) {
  for (size_t place = begin; place < end; ++place) {
    const Float4 move = field.moves[place];
    Float4 sum = {};
    for (uint64_t i = field.fan_starts[place]; i < field.fan_starts[place + 1]; ++i) {
      const Float4 plane = field.planes[field.fans[i]];
      sum += plane * (field.offsets[i] + (plane[3] - along(plane, move)));
    }
    Float4 pull = sum * move[3];
    pull[3] = 0;
    field.moves[place] = move + pull;
  }
}

}  // namespace burnish
