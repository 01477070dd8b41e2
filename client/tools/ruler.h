#pragma once

#include <optional>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// Measures the straight distance of two points of the surface.
class Ruler {
 public:
  /// A point of the surface, file units.
  struct End {
    Vec3d edited;    ///< where it was when it was put
    Vec3d original;  ///< the same point before all edits
  };

  /// Puts an end. After two ends it begins anew.
  void put(const End& end);
  void clear() { ends_.clear(); }
  const std::vector<End>& ends() const { return ends_; }  ///< at most two

  /// The distance of two ends; nothing before.
  std::optional<double> length() const;
  std::optional<double> original_length() const;

 private:
  std::vector<End> ends_;
};

}  // namespace burnish
