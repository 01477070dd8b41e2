#include "client/publish/published_tile.h"

#include <cmath>
#include <cstdint>
#include <zlib.h>

#include "common/base/check.h"
#include "common/page_frames/page_frame_body.h"
#include "common/page_frames/page_steps.h"

namespace burnish {

/// Returns steps of 1/256 cell: all x, then all y, then all z.
static std::vector<int32_t> steps_of(const PageMove& move) {
  constexpr float kStepsPerCell = 256;
  std::vector<int32_t> steps;
  for (int axis = 0; axis < 3; ++axis)
    for (const Vec3f& way : move.displacements)
      steps.push_back(static_cast<int32_t>(std::lround(way[axis] * kStepsPerCell)));
  return steps;
}

static void add_values(const Page& page, const PageMove& move, PageFrameBodyWriter& body) {
  const std::vector<int32_t> wanted = steps_of(move);
  std::vector<int32_t> values(wanted.size(), 0);
  std::vector<uint32_t> residuals(wanted.size());
  if (code_page(make_vertex_page_layout(page), wanted, 0, values, residuals))
    body.add_values(0, residuals);
}

std::string published_tile(const Page& page, const PageMove& move) {
  PageFrameBodyWriter body(1);
  add_values(page, move, body);
  if (move.gain != 0) body.add_gain(0, move.gain);
  if (body.sent_pages() == 0 && body.sent_gains() == 0) return {};
  const size_t values = move.displacements.size();
  std::string bytes{static_cast<char>(values & 0xff), static_cast<char>(values >> 8)};
  for (const uint8_t byte : body.bytes()) bytes.push_back(static_cast<char>(byte));
  return bytes;
}

std::string pack_tile(const std::string& tile) {
  if (tile.empty()) return {};
  uLongf size = compressBound(tile.size());
  std::string packed(size, '\0');
  const int end = compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                           reinterpret_cast<const Bytef*>(tile.data()), tile.size());
  BURNISH_CHECK(end == Z_OK, "zlib lacks memory");
  packed.resize(size);
  return packed;
}

}  // namespace burnish
