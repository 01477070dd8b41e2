#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/moved/colour_edit.h"
#include "common/mesh/rewrite/pictures/level_seams.h"
#include "common/mesh/rewrite/pictures/picture_place.h"
#include "common/mesh/rewrite/pictures/shown_light.h"
#include "common/picture/picture_rewriter.h"

namespace burnish {

/// Changed texels go so far beyond the triangles: two mips read them.
inline constexpr uint32_t kGutterTexels = 4;

/// Says what becomes of the texels of a surface. Needs: what it refers to outlives it.
struct TexelEdit {
  const TexturedSurface& surface;
  ColourEdit colours;
  const LevelledSeams* seams = nullptr;  ///< null: they stay

  bool changes(uint32_t triangle) const {
    return colours.changes(surface.mesh.triangles[triangle]) ||
           (seams != nullptr && seams->changes(triangle));
  }
};

/// Changes the texels of a picture as renderers show edited colours: in linear light, a texel times
/// a gain plus a change, both between its triangle's corners (client/gl/texel_shader.cpp). Factors
/// of levelled seams multiply the texel first. Where
/// several triangles show a texel it gets the mean of their changes. Beyond triangles the change
/// goes on as the mean of what is around. Works in bands of rows, so a picture of any height takes
/// no more memory. The same texels for any number of threads and any bands.
class TexelChanges {
 public:
  /// `triangles`: all that show the picture. Needs: what it refers to outlives it.
  TexelChanges(const TexelEdit& edit, std::span<const uint32_t> triangles,
               const PicturePlace& place, uint32_t width, uint32_t height);

  /// Returns the memory that it takes.
  static uint64_t bytes_of(size_t triangles, uint32_t width);

  /// Changes some rows. Bands come from top to bottom. Asks `goes_on` often. Fails: cancelled.
  Status change(const FileRows& rows, const std::function<bool()>& goes_on);

  /// Returns how many texels that changed are shown by several triangles.
  uint64_t shared_texels() const { return shared_texels_; }

 private:
  /// The rows of a triangle.
  struct Visit {
    uint32_t first, last;
    uint32_t triangle;
  };
  /// The change of a texel: its light's for red, green and blue, and the gains of these less 1.
  /// Level 0: unknown; 1: of triangles; above: of texels around with lower levels.
  struct Change {
    std::array<float, 6> parts = {0, 0, 0, 0, 0, 0};
    uint16_t triangles = 0;
    uint16_t level = 0;
  };
  struct Found {
    uint32_t x;
    Change change;
  };

  void activate(uint32_t first, uint32_t end);
  void sort_into_groups(uint32_t first, uint32_t end);
  bool draw_rows(uint32_t first, uint32_t end);
  void draw(uint32_t triangle, uint32_t from, uint32_t to, uint32_t first);
  static void add_row(std::span<Change> texels, size_t channel, std::array<float, 2> light,
                      std::array<float, 2> tint);
  static void add_gains(std::span<Change> texels, size_t channel, std::array<float, 2> gain);
  static bool take_means(std::span<Change> row);
  void extend(uint32_t rows, uint16_t level);
  void find_around(uint32_t row, uint32_t rows, uint16_t level, std::vector<Found>& found) const;
  uint64_t apply(std::span<const Change> changes, std::span<FileTexel> texels, uint16_t max) const;
  std::span<Change> row_of(uint32_t row) {
    return std::span(changes_).subspan(size_t{row} * width_, width_);
  }

  const TexelEdit edit_;
  const PicturePlace& place_;
  const uint32_t width_, height_;
  const ShownLight light_;
  std::vector<Visit> visits_;  // by first row, then by number
  size_t next_ = 0;            // of visits_
  std::vector<Visit> active_;
  std::vector<uint32_t> group_begins_, in_groups_;  // triangles of some rows of a band
  std::vector<Change> changes_;                     // of a band and the gutter around it
  uint64_t shared_texels_ = 0;
};

}  // namespace burnish
