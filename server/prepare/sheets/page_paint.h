#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/pictures/level_seams.h"
#include "common/pages/page.h"
#include "common/sheets/bake_sheet.h"
#include "common/sheets/chart.h"
#include "server/prepare/pages/page_texels.h"
#include "server/prepare/sheets/picture_sampler.h"
#include "server/prepare/sheets/picture_tiles.h"
#include "server/prepare/sheets/tiled_level.h"
#include "server/prepare/sheets/triangle_finder.h"

namespace burnish {

/// The colours that the scan's pictures show on a page of level 0.
class PagePaint {
 public:
  /// `seams`: of the surface; null: they stay. Needs: the arguments outlive this and its source.
  PagePaint(const Page& page, const TexturedSurface& surface, const PictureTiles& tiles,
            const TriangleFinder& finder, const LevelledSeams* seams = nullptr);
  /// The same for a page whose triangles are these of the scan, each from its first corner on.
  PagePaint(const Page& page, const TexturedSurface& surface, const PictureTiles& tiles,
            std::span<const uint32_t> triangles);

  /// Texels of pictures inside the page's triangles.
  double used_texels() const;
  /// Returns the density that a sheet needs to show them, texels per step; 0 without a picture.
  double needed_density() const { return needed_texel_density(shown_); }
  /// Triangles that the scan does not have at these places: nothing is drawn for them.
  size_t lost_triangles() const { return lost_triangles_; }

  /// Returns the page's triangles with their pictures, as a sheet of this density shows them: where
  /// it has fewer texels than a picture, with means of the picture's. For one thread.
  BakeSource source(PictureSampler& sampler, double texels_per_step) const;

 private:
  /// A triangle of the page with what its corners show.
  struct Painted {
    std::array<Vec3d, 3> places;      ///< steps
    std::array<Vec2d, 3> on_picture;  ///< 0 to 1
    uint32_t picture = kNoTexture;
    TextureWraps wraps;
    double texels_per_step = 0;  ///< of the picture, along the direction with the most
    bool is_tinted = false;
    std::array<Vec3f, 3> tints;  ///< linear light; the colours themselves without a picture
  };
  /// The level of a picture on which a triangle is drawn.
  struct Drawn {
    const TiledLevel* level = nullptr;  ///< null without a picture
    std::array<Vec2d, 3> corners;       ///< texels
  };
  static Texel texel_of(const Painted& painted, const Drawn& drawn, const Vec3d& weights,
                        PictureSampler& sampler);
  void add(const std::array<Vec3d, 3>& places, const FoundTriangle& found,
           const TexturedSurface& surface);
  Painted painted(const std::array<Vec3d, 3>& places, const FoundTriangle& found,
                  const TexturedSurface& surface) const;
  void tint(Painted& painted, const FoundTriangle& found, const TexturedSurface& surface) const;
  void put_on_picture(Painted& painted, const FoundTriangle& found, uint32_t picture,
                      const SurfaceTextures& textures) const;
  std::array<Vec2d, 3> texels_of(const Painted& painted) const;
  Drawn drawn(const Painted& painted, double texels_per_step) const;
  void count(const Painted& painted);

  const PictureTiles& tiles_;
  const LevelledSeams* seams_;
  std::vector<Painted> triangles_;
  std::vector<TexelsOnArea> shown_;  // areas in steps²
  size_t lost_triangles_ = 0;
};

}  // namespace burnish
