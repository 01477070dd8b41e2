#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/page_frames/page_frame_encoder.h"
#include "common/page_frames/page_sample.h"
#include "server/live/client_pages.h"
#include "server/live/held_points.h"
#include "server/live/layer_points.h"
#include "server/session/session.h"

namespace burnish {

class SurfaceSnapshot;

/// A session's surface at one moment.
struct SurfaceMoment {
  const SparseGrid& grid;
  std::span<const EvaluationPoint> scan;  ///< one per vertex of the scan
  std::span<const Vec3f> displacement;    ///< one per corner, cells
  std::span<const float> beta;            ///< one per cell
  bool settled = false;
  const SurfaceSnapshot* last = nullptr;  ///< of the same surface: is not done again
  ColourChange colour = {};
  HeldPoints* held = nullptr;           ///< null: no rim is held
  VertexLayer layer = {};               ///< pages of kind kCorners are without it
  LayerPoints* layer_points = nullptr;  ///< needed with a layer that moves something
};

/// The pages that some clients show, sampled at one moment. Immutable: encoders share it.
class SurfaceSnapshot {
 public:
  /// Takes a page once, however many clients show it. Fails: internal if a displacement is not
  /// finite.
  static Result<SurfaceSnapshot> take(const SurfaceMoment& moment,
                                      std::span<const std::shared_ptr<const ClientPages>> clients);

  /// Returns the surface of a session that has not moved yet. Needs no turn of the session.
  static SurfaceSnapshot unmoved(std::span<const std::shared_ptr<const ClientPages>> clients);

  /// Returns what each page of one of these clients should have, in the order of its pages.
  std::vector<WantedPage> wanted(const ClientPages& client) const;

  float largest_move() const { return largest_move_; }  ///< of the whole surface, cells

 private:
  /// A page's part.
  struct Part {
    std::weak_ptr<const LivePage> page;
    std::shared_ptr<const PageSample> sample;
    uint8_t gain = 0;
    HeldVertices held = {};
  };

  Status sample(std::span<const size_t> parts, const SparseGrid& grid,
                std::span<const Vec3f> values, float scale);
  void add_layer(std::span<const size_t> parts, const SurfaceMoment& moment);
  Status sample_colours(std::span<const size_t> parts, const SparseGrid& grid,
                        const ColourChange& change);
  const Part* find(const LivePage& page) const;

  std::vector<const LivePage*> pages_;  // rising; some may have gone
  std::vector<Part> parts_;             // one per page
  float largest_move_ = 0;
};

}  // namespace burnish
