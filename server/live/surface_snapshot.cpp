#include "server/live/surface_snapshot.h"

#include <algorithm>
#include <cmath>

#include "common/evaluation/displacement_steps.h"

namespace burnish {

namespace {

using SharedPages = std::vector<std::shared_ptr<const LivePage>>;

SharedPages pages_of(std::span<const std::shared_ptr<const ClientPages>> clients) {
  SharedPages pages;
  for (const auto& client : clients)
    pages.insert(pages.end(), client->pages.begin(), client->pages.end());
  std::ranges::sort(pages);
  pages.erase(std::ranges::unique(pages).begin(), pages.end());
  return pages;
}

uint8_t gain_of(const LivePage& page, std::span<const float> beta) {
  float largest = 0;
  for (const int32_t cell : page.cells) largest = std::max(largest, beta[cell]);
  return gain_exponent(largest);
}

std::shared_ptr<const PageSample> zeros_of(const LivePage& page) {
  const size_t values = size_t{3} * page.evaluation.shown.value_count();
  return std::make_shared<const PageSample>(
      PageSample{page.number(), std::vector<int32_t>(values)});
}

void still(const HeldVertices& held, PageSample& sample) {
  const size_t vertices = sample.steps.size() / 3;
  for_each_held(held, [&](size_t vertex) {
    for (size_t axis = 0; axis < 3; ++axis) sample.steps[axis * vertices + vertex] = 0;
  });
}

// Sums before it rounds: two roundings would be a step off.
std::shared_ptr<const PageSample> colours_of(const LivePage& page, const SparseGrid& grid,
                                             const ColourChange& change) {
  const size_t vertices = page.colours.size();
  auto sample =
      std::make_shared<PageSample>(PageSample{page.number(), std::vector<int32_t>(3 * vertices)});
  for (size_t v = 0; v < vertices; ++v) {
    const PointChange at = change_at(change, grid, page.evaluation.points[v], page.colours[v]);
    const Vec3f shown = is_gains(page.number()) ? Vec3f(at.gain - 1, 0, 0) : at.colour;
    for (size_t channel = 0; channel < 3; ++channel)
      sample->steps[channel * vertices + v] = to_steps(kCellsPerColour * shown[int(channel)]);
  }
  return sample;
}

/// Returns the move of a vertex by its corners and by the layer.
Vec3f whole_move(const SurfaceMoment& moment, const EvaluationPoint& at, uint32_t of_scan) {
  constexpr float kBelowCap = 1 - 1e-6F;  // a length that rounds above the cap would pass it
  Vec3f move = evaluate(moment.grid, at, moment.displacement);
  if (of_scan < moment.layer.moves.size()) move += moment.layer.moves[of_scan];
  const float cap = kBelowCap * static_cast<float>(moment.layer.cap), length = move.norm();
  return cap > 0 && length > cap ? Vec3f(cap / length * move) : move;
}

// Sums before it rounds, as with_details() does.
std::shared_ptr<const PageSample> with_layer(const LivePage& page, const SurfaceMoment& moment,
                                             const LayerPoints::OfPage& of_scan,
                                             const HeldVertices& held) {
  const size_t vertices = page.evaluation.points.size();
  auto sample =
      std::make_shared<PageSample>(PageSample{page.number(), std::vector<int32_t>(3 * vertices)});
  for (size_t v = 0; v < vertices; ++v) {
    const uint32_t number = of_scan ? (*of_scan)[v] : LayerPoints::kNoVertex;
    const Vec3f move = whole_move(moment, page.evaluation.points[v], number);
    for (size_t axis = 0; axis < 3; ++axis)
      sample->steps[axis * vertices + v] = to_steps(move[int(axis)]);
  }
  still(held, *sample);
  return sample;
}

// As largest_move(), with the layer.
float largest_whole_move(const SurfaceMoment& moment, size_t stride,
                         std::span<const uint32_t> held) {
  float largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest)
  for (size_t v = 0; v < moment.scan.size(); v += stride)
    if (!std::ranges::binary_search(held, v))
      largest = std::max(
          largest, whole_move(moment, moment.scan[v], static_cast<uint32_t>(v)).squaredNorm());
  return std::sqrt(largest);
}

// All points of a large scan would take longer than all pages that are shown. While the surface
// moves some of them do: neighbours move alike. A settled surface tells the true value.
float largest_move_of(const SurfaceMoment& moment) {
  constexpr size_t kMovingPointsMax = size_t{1} << 17;
  const size_t stride =
      moment.settled ? 1 : (moment.scan.size() + kMovingPointsMax - 1) / kMovingPointsMax;
  const std::span<const uint32_t> held =
      moment.held ? std::span<const uint32_t>(moment.held->rims()->vertices)
                  : std::span<const uint32_t>();
  if (moment.layer.is_there()) return largest_whole_move(moment, std::max(stride, size_t{1}), held);
  return largest_move(moment.grid, moment.scan, moment.displacement, std::max(stride, size_t{1}),
                      held);
}

}  // namespace

const SurfaceSnapshot::Part* SurfaceSnapshot::find(const LivePage& page) const {
  const auto found = std::ranges::lower_bound(pages_, &page);
  if (found == pages_.end() || *found != &page) return nullptr;
  const Part& part = parts_[found - pages_.begin()];
  return part.page.expired() ? nullptr : &part;  // another page may have come to its place
}

Result<SurfaceSnapshot> SurfaceSnapshot::take(
    const SurfaceMoment& moment, std::span<const std::shared_ptr<const ClientPages>> clients) {
  SurfaceSnapshot snapshot;
  std::vector<size_t> places, colours;  // parts to sample
  for (const auto& page : pages_of(clients)) {
    const bool is_colour = is_colours(page->number());
    const Part* known = moment.last ? moment.last->find(*page) : nullptr;
    if (!known) (is_colour ? colours : places).push_back(snapshot.parts_.size());
    const uint8_t gain = is_colour ? 0 : gain_of(*page, moment.beta);
    snapshot.pages_.push_back(page.get());
    snapshot.parts_.push_back(known ? *known : Part{page, nullptr, gain});
    if (!known && moment.held) snapshot.parts_.back().held = moment.held->of(page);
  }
  RETURN_IF_ERROR(snapshot.sample(places, moment.grid, moment.displacement, 1));
  if (moment.layer.is_there()) snapshot.add_layer(places, moment);
  RETURN_IF_ERROR(snapshot.sample_colours(colours, moment.grid, moment.colour));
  snapshot.largest_move_ = moment.last ? moment.last->largest_move_ : largest_move_of(moment);
  return snapshot;
}

Status SurfaceSnapshot::sample(std::span<const size_t> parts, const SparseGrid& grid,
                               std::span<const Vec3f> values, float scale) {
  std::vector<std::shared_ptr<const PageEvaluation>> pages;
  std::vector<PageFrameKind> kinds;
  for (const size_t part : parts) {
    const auto page = parts_[part].page.lock();
    pages.emplace_back(page, &page->evaluation);
    kinds.push_back(page->kind);
  }
  ASSIGN_OR_RETURN(auto samples, sample_pages(grid, pages, values, scale));
  for (size_t i = 0; i < samples.size(); ++i) {
    Part& part = parts_[parts[i]];
    if (kinds[i] == PageFrameKind::kVertices) still(part.held, samples[i]);
    part.sample = std::make_shared<const PageSample>(std::move(samples[i]));
  }
  return Status::ok();
}

void SurfaceSnapshot::add_layer(std::span<const size_t> parts, const SurfaceMoment& moment) {
  struct Layered {
    std::shared_ptr<const LivePage> page;
    LayerPoints::OfPage of_scan;
    Part* part;
  };
  std::vector<Layered> layered;
  for (const size_t part : parts) {
    auto page = parts_[part].page.lock();
    if (page->kind != PageFrameKind::kVertices) continue;
    LayerPoints::OfPage of_scan =
        moment.layer.moves.empty() ? nullptr : moment.layer_points->of(page);
    layered.push_back({std::move(page), std::move(of_scan), &parts_[part]});
  }
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < layered.size(); ++i) {
    const Layered& one = layered[i];
    one.part->sample = with_layer(*one.page, moment, one.of_scan, one.part->held);
  }
}

Status SurfaceSnapshot::sample_colours(std::span<const size_t> parts, const SparseGrid& grid,
                                       const ColourChange& change) {
  std::vector<size_t> of_grid;
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts_[parts[i]];
    const auto page = part.page.lock();
    const bool is_whole = change.is_there() && !page->colours.empty();
    part.sample = is_whole ? colours_of(*page, grid, change) : zeros_of(*page);
  }
  if (change.on_grid.empty()) return Status::ok();
  // Corners know what the grid does.
  for (const size_t part : parts) {
    const auto page = parts_[part].page.lock();
    if (page->colours.empty() && !is_gains(page->number())) of_grid.push_back(part);
  }
  return sample(of_grid, grid, change.on_grid, kCellsPerColour);
}

SurfaceSnapshot SurfaceSnapshot::unmoved(
    std::span<const std::shared_ptr<const ClientPages>> clients) {
  SurfaceSnapshot snapshot;
  for (const auto& page : pages_of(clients)) {
    snapshot.pages_.push_back(page.get());
    snapshot.parts_.push_back({page, zeros_of(*page), 0});
  }
  return snapshot;
}

std::vector<WantedPage> SurfaceSnapshot::wanted(const ClientPages& client) const {
  const bool says_held = client.knows_held && client.kind == PageFrameKind::kCorners;
  std::vector<WantedPage> wanted;
  wanted.reserve(client.pages.size());
  for (const auto& page : client.pages) {
    const Part& part = *find(*page);
    wanted.push_back({part.sample->steps, part.gain, says_held ? part.held : nullptr});
  }
  return wanted;
}

}  // namespace burnish
