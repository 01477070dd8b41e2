#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "client/scene/page_renderer.h"
#include "client/tools/stroke_tint.h"
#include "common/pages/page.h"

namespace burnish {

/// Colours the vertices of pages besides the light: by a value of their cells, by an overlay, and
/// by the tint of strokes that no frame shows yet.
class PageMarks {
 public:
  /// The marks that a page has now.
  struct Mark {
    std::shared_ptr<const std::vector<int8_t>> values;      ///< one per vertex; null: all 0
    std::shared_ptr<const std::vector<uint16_t>> overlays;  ///< likewise
    TintProgress tint;
    std::vector<float> weights;  ///< of the tint, one per vertex; empty: all 0
    std::vector<VertexMark> marks;
  };

  /// Needs: `tint` outlives this.
  explicit PageMarks(const StrokeTint& tint) : tint_(tint) {}

  /// Values are those of VertexMark. Shapes: one per vertex.
  void set_values(PageId page, std::vector<int8_t> values);
  void clear_values() { values_.clear(); }
  bool has_values(PageId page) const { return values_.contains(page); }
  /// Overlays are those of VertexMark. Shapes: one per vertex.
  void set_overlays(PageId page, std::vector<uint16_t> overlays);
  void clear_overlays() { overlays_.clear(); }

  /// Brings a page's marks up to date. Returns whether they have changed. Shapes: one cell per
  /// vertex. Units: cells of the session's depth.
  bool update(PageId page, std::span<const Vec3i> cells, Mark& mark) const;

 private:
  const StrokeTint& tint_;
  template <typename Value>
  using ByPage = std::unordered_map<PageId, std::shared_ptr<const std::vector<Value>>>;
  ByPage<int8_t> values_;
  ByPage<uint16_t> overlays_;
};

}  // namespace burnish
