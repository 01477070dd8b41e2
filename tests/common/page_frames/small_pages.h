#pragma once

#include <memory>
#include <random>
#include <vector>

#include "common/page_frames/page_frame_encoder.h"
#include "common/page_frames/page_sample.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// A generated scan in small pages of two levels, and a grid of the cells that hold its vertices.
/// Neighbours share vertices; a page of the coarse level has vertices of several fine ones, and no
/// triangles. That is enough for frames.
struct SmallPages {
  PageGrid lattice;
  SparseGrid grid;
  std::vector<Page> pages;  ///< by number
};
const SmallPages& small_pages();

/// Returns a displacement that is smooth over the grid. Units: cells.
std::vector<Vec3f> wavy_field(double amplitude, double phase);
/// Changes the displacement of corners near a random vertex of the scan.
void dab_field(std::mt19937& random, double amplitude, std::vector<Vec3f>& field);

/// The values of all small pages, as a server has them.
class PageSampler {
 public:
  explicit PageSampler(PageFrameKind kind);

  PageFrameKind kind() const { return kind_; }
  uint32_t page_count() const { return static_cast<uint32_t>(evaluations_.size()); }
  ShownPage shown(PageId page) const { return evaluations_[page]->shown; }
  /// Returns a change that shows these pages.
  PageChange adding(uint32_t revision, const std::vector<PageId>& pages) const;

  void sample(const std::vector<Vec3f>& field);
  std::span<const int32_t> steps(PageId page) const { return samples_[page].steps; }
  std::vector<WantedPage> wanted(const ShownPages& shown) const;

 private:
  PageFrameKind kind_;
  std::vector<std::shared_ptr<const PageEvaluation>> evaluations_;  // by page
  std::vector<PageSample> samples_;                                 // by page
};

/// Returns a made-up page whose values are each predicted by the one before.
ShownPage plain_page(PageId page, uint32_t values);

/// Returns all values of a state, page by page.
std::vector<int32_t> values_of(const PageFrameState& state);
/// Returns what a frame of this shift makes of wanted values.
std::vector<int32_t> rounded(std::span<const int32_t> steps, int shift);

}  // namespace burnish
