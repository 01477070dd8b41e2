#include "server/live/surface_shot.h"

#include <algorithm>

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

// All points of a large scan would take longer than all pages that are shown. While the surface
// moves some of them do: neighbours move alike. A settled surface tells the true value.
float largest_move_of(const SurfaceMoment& moment) {
  constexpr size_t kMovingPointsMax = size_t{1} << 17;
  const size_t stride =
      moment.settled ? 1 : (moment.scan.size() + kMovingPointsMax - 1) / kMovingPointsMax;
  return largest_move(moment.grid, moment.scan, moment.displacement, std::max(stride, size_t{1}));
}

}  // namespace

Result<SurfaceShot> SurfaceShot::take(const SurfaceMoment& moment,
                                      std::span<const std::shared_ptr<const ClientPages>> clients) {
  const SharedPages pages = pages_of(clients);
  std::vector<std::shared_ptr<const PageEvaluation>> evaluations;
  for (const auto& page : pages) evaluations.emplace_back(page, &page->evaluation);
  SurfaceShot shot;
  ASSIGN_OR_RETURN(shot.samples_, sample_pages(moment.grid, evaluations, moment.displacement));
  for (const auto& page : pages) {
    shot.pages_.push_back(page.get());
    shot.gains_.push_back(gain_of(*page, moment.beta));
  }
  shot.largest_move_ = largest_move_of(moment);
  return shot;
}

std::vector<WantedPage> SurfaceShot::wanted(const ClientPages& client) const {
  std::vector<WantedPage> wanted;
  wanted.reserve(client.pages.size());
  for (const auto& page : client.pages) {
    const auto at = std::ranges::lower_bound(pages_, page.get()) - pages_.begin();
    wanted.push_back({samples_[at].steps, gains_[at]});
  }
  return wanted;
}

}  // namespace burnish
