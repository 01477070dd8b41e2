#pragma once

#include <optional>
#include <vector>

namespace burnish {

/// A rectangle's corner in an array of square layers, texels.
struct ShelfPlace {
  int layer = 0;
  int x = 0;
  int y = 0;
};

/// Packs rectangles into the layers of an array: on shelves, from left to right. A shelf is free
/// again once all its rectangles are gone. Corners and sides are multiples of kShelfStep, so that
/// two halvings keep them apart.
class SheetShelves {
 public:
  SheetShelves(int side, int layers) : side_(side), layers_(layers), tops_(layers, 0) {}

  /// Returns nothing where there is no room. Needs: 1 <= width, height <= side.
  std::optional<ShelfPlace> take(int width, int height);
  /// Needs: a place that was taken with this height.
  void give_back(const ShelfPlace& place);

  int layers() const { return layers_; }

  static constexpr int kShelfStep = 4;
  static constexpr int kShelfHeightStep = 16;  // few heights, so that shelves serve again

 private:
  struct Shelf {
    int layer;
    int y;
    int height;
    int filled = 0;  // columns
    int count = 0;   // rectangles
  };
  std::optional<ShelfPlace> put(Shelf& shelf, int width);

  int side_;
  int layers_;
  std::vector<int> tops_;  // by layer: rows that have shelves
  std::vector<Shelf> shelves_;
};

}  // namespace burnish
