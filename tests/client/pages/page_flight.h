#pragma once

#include <chrono>
#include <vector>

#include "client/pages/page_loader.h"
#include "tests/client/pages/simulated_link.h"
#include "tests/client/pages/synthetic_scan.h"

namespace burnish {

struct PageFlightOptions {
  PageBudget budget;
  bool is_software = false;
  SimulatedLinkOptions link;
  int decodes_per_picture = 1000;
  std::chrono::microseconds picture_interval{16'667};
};

/// A client that flies over a synthetic scan at 60 pictures a second of simulated time, or fewer.
/// Fails the test at the first picture whose cut is not legal, has a hole or is over a budget, or
/// whose card does not hold what is drawn.
class PageFlight {
 public:
  PageFlight(const SyntheticScan& scan, const PageFlightOptions& options);

  /// Draws one picture.
  void picture(const Camera& camera);
  /// Draws pictures until nothing would change any more. Returns the simulated seconds, and fails
  /// the test after `limit`.
  double settle(const Camera& camera, double limit_seconds = 120);
  /// Flies from one camera to another in so many pictures.
  void fly(const Camera& from, const Camera& to, int pictures);

  PageLoader& loader() { return loader_; }
  const ChosenCut& cut() const { return loader_.cut(); }
  SimulatedLink& link() { return link_; }
  PageLoader::Time now() const { return now_; }
  size_t given_up() const { return given_up_; }

  bool surface_moves = false;
  uint64_t frame_vertices_max = 0;
  uint64_t server_vertices_max = 0;
  uint64_t moving_triangles_max = 0;
  std::function<bool(PageId)> has_values;
  bool rests_early = false;

 private:
  void carry_out();
  void decode();
  void check_cut();
  void check_budgets();
  void check_card();

  const SyntheticScan& scan_;
  PageFlightOptions options_;
  PageLoader loader_;
  SimulatedLink link_;
  PageLoader::Time now_;
  std::vector<PageId> card_;  ///< by slot
  bool had_root_ = false;
  size_t given_up_ = 0;
};

}  // namespace burnish
