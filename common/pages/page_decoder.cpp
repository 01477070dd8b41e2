#include <array>
#include <bit>
#include <numeric>
#include <string>

#include "common/packing/byte_planes.h"
#include "common/packing/zigzag.h"
#include "common/packing/zstd_frame.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_header.h"
#include "common/pages/page_prediction.h"
#include "common/pages/page_walk.h"

namespace burnish {

namespace {

/// Decodes the sections of one page. Vertices and triangles stay in the order of the walk.
class SectionReader {
 public:
  SectionReader(const PageHeader& header, std::span<const uint8_t> body) : header_(header) {
    const auto sizes = section_bytes(header);
    for (size_t s = 0; s < kPageSections; ++s) {
      sections_[s] = body.first(sizes[s]);
      body = body.subspan(sizes[s]);
    }
  }

  std::vector<PagePatch> patches() const {
    std::vector<uint32_t> differences(header_.patches);
    read_planes<uint32_t>(at(PageSection::kFiner), 4, differences);
    std::vector<PagePatch> patches;
    PageId last = 0;
    for (const uint32_t difference : differences) patches.push_back({last += difference, 0});
    return patches;
  }

  WalkCode walk_code() const {
    WalkCode code;
    code.steps.resize(header_.steps);
    const auto steps = at(PageSection::kSteps);
    for (size_t i = 0; i < code.steps.size(); ++i) code.steps[i] = steps[i / 2] >> 4 * (i % 2) & 15;
    code.named_vertices.resize(header_.named_vertices);
    read_planes<uint16_t>(at(PageSection::kNamedVertices), 2, code.named_vertices);
    code.turns.resize(header_.triangles, 0);
    if (header_.patches > 1) read_bits(at(PageSection::kTurns), code.turns);
    code.named_patches.resize(header_.named_patches);
    read_planes<uint16_t>(at(PageSection::kNamedPatches), 2, code.named_patches);
    return code;
  }

  std::vector<uint8_t> border() const {
    std::vector<uint8_t> is_border(header_.vertices);
    read_bits(at(PageSection::kBorder), is_border);
    return is_border;
  }

  /// Fails: data_loss if a coordinate is outside every lattice.
  Result<std::vector<Vec3i>> positions(std::span<const WalkOrigin> origins) const {
    const size_t count = header_.vertices;
    std::vector<uint32_t> residuals(3 * count);
    read_planes<uint32_t>(at(PageSection::kPlaces), header_.place_bytes, residuals);
    std::vector<Vec3i> positions(count, Vec3i::Zero());
    uint32_t any = 0;
    for (size_t v = 0; v < count; ++v) {
      const auto predicted =
          v == 0 ? header_.first_position : predicted_position(origins[v], positions);
      for (int axis = 0; axis < 3; ++axis) {
        const uint32_t place = predicted[axis] + from_zigzag(residuals[axis * count + v]);
        any |= place;
        positions[v][axis] = static_cast<int>(place);
      }
    }
    if (any >> kPageGridBitsMax != 0)
      return data_loss("a coordinate has " + std::to_string(std::bit_width(any)) +
                       " bits, the limit is " + std::to_string(kPageGridBitsMax));
    return positions;
  }

  /// Returns a normal per vertex; zero for those that have none.
  std::vector<Vec3f> normals(std::span<const uint8_t> is_border,
                             std::span<const NormalSum> sums) const {
    const auto planes = at(PageSection::kNormals);
    const size_t count = planes.size() / 2;
    std::vector<Vec3f> normals(sums.size(), Vec3f::Zero());
    for (size_t v = 0, i = 0; v < sums.size(); ++v) {
      if (!header_.has_all_normals() && is_border[v] == 0) continue;
      OctahedralCode code = predicted_code(sums[v]);
      for (size_t k = 0; k < 2; ++k)
        code[k] = static_cast<int8_t>(code[k] + from_zigzag(planes[k * count + i]));
      normals[v] = octahedral_normal(code);
      ++i;
    }
    return normals;
  }

  std::vector<Rgba8> colours(std::span<const WalkOrigin> origins) const {
    const auto planes = at(PageSection::kColours);
    const size_t count = planes.size() / 4;
    std::vector<Rgba8> colours(count);
    for (size_t v = 0; v < count; ++v) {
      const Rgba8 predicted = v == 0 ? Rgba8{} : predicted_colour(origins[v], colours);
      const uint8_t green = planes[v];
      const Rgba8 residual = {static_cast<uint8_t>(planes[count + v] + green), green,
                              static_cast<uint8_t>(planes[2 * count + v] + green),
                              planes[3 * count + v]};
      for (int channel = 0; channel < 4; ++channel)
        colours[v][channel] = static_cast<uint8_t>(predicted[channel] + residual[channel]);
    }
    return colours;
  }

 private:
  std::span<const uint8_t> at(PageSection section) const {
    return sections_[static_cast<size_t>(section)];
  }

  const PageHeader& header_;
  std::array<std::span<const uint8_t>, kPageSections> sections_;
};

/// Returns the place of each vertex of the walk in the page: those on the border come first.
std::vector<uint16_t> places_in_page(std::span<const uint8_t> is_border) {
  const auto border = std::accumulate(is_border.begin(), is_border.end(), size_t{0});
  std::array<size_t, 2> next = {border, 0};
  std::vector<uint16_t> places;
  for (const uint8_t flag : is_border) places.push_back(static_cast<uint16_t>(next[flag]++));
  return places;
}

template <typename T>
std::vector<T> placed(std::span<const T> walked, std::span<const uint16_t> places) {
  std::vector<T> values(walked.size());
  for (size_t v = 0; v < walked.size(); ++v) values[places[v]] = walked[v];
  return values;
}

/// Sorts the triangles by patch and counts those of each.
void place_triangles(const PageWalk& walk, std::span<const uint16_t> places, Page& page) {
  for (const uint16_t patch : walk.patches) ++page.patches[patch].triangles;
  std::vector<uint32_t> next;
  uint32_t begin = 0;
  for (const PagePatch& patch : page.patches) {
    next.push_back(begin);
    begin += patch.triangles;
  }
  page.triangles.resize(walk.triangles.size());
  for (size_t t = 0; t < walk.triangles.size(); ++t) {
    PageTriangle& triangle = page.triangles[next[walk.patches[t]]++];
    for (int k = 0; k < 3; ++k) triangle[k] = places[walk.triangles[t][k]];
  }
}

Result<std::vector<uint8_t>> read_border(const PageHeader& header, const SectionReader& sections) {
  std::vector<uint8_t> is_border = sections.border();
  const auto border = std::accumulate(is_border.begin(), is_border.end(), uint32_t{0});
  if (border == header.border_vertices) return is_border;
  return data_loss(std::to_string(border) + " vertices are on the border, the header says " +
                   std::to_string(header.border_vertices));
}

Result<Page> decode_body(const PageHeader& header, std::span<const uint8_t> compressed) {
  const auto sizes = section_bytes(header);
  const size_t size = std::accumulate(sizes.begin(), sizes.end(), size_t{0});
  ASSIGN_OR_RETURN(const auto body, decompress(compressed, size));
  const SectionReader sections(header, body);
  ASSIGN_OR_RETURN(const PageWalk walk,
                   follow_walk(sections.walk_code(), header.vertices, header.patches));
  ASSIGN_OR_RETURN(const auto is_border, read_border(header, sections));
  ASSIGN_OR_RETURN(const auto positions, sections.positions(walk.origins));

  Page page{
      .id = header.id, .patches = sections.patches(), .border_vertices = header.border_vertices};
  const std::vector<uint16_t> places = places_in_page(is_border);
  place_triangles(walk, places, page);
  page.positions = placed<Vec3i>(positions, places);
  const std::vector<NormalSum> sums = sum_normals(walk.triangles, positions);
  page.normals = placed<Vec3f>(sections.normals(is_border, sums), places);
  if (!header.has_all_normals()) page.normals.resize(header.border_vertices);
  if (header.has_colours()) page.colours = placed<Rgba8>(sections.colours(walk.origins), places);
  const Status checked = check_page(page);
  if (!checked.is_ok()) return data_loss(checked.message());
  return page;
}

}  // namespace

Result<Page> decode_page(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const PageHeader header, read_page_header(bytes));
  auto page = decode_body(header, bytes.subspan(sizeof(header)));
  if (!page.is_ok()) return page.status().with_context("page " + std::to_string(header.id));
  return page;
}

}  // namespace burnish
