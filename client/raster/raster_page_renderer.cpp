#include "client/raster/raster_page_renderer.h"

#include <algorithm>
#include <string>

#include "client/raster/g_buffer_rows.h"
#include "client/raster/occlusion_rows.h"
#include "client/raster/page_filler.h"
#include "client/raster/shade_rows.h"
#include "common/base/check.h"
#include "common/base/out_of_memory.h"

namespace burnish {
namespace {

constexpr int kRowsOfPart = 8;

void run_rows(WorkCrew& crew, int height, const std::function<void(const RowRange&)>& work) {
  crew.run((height + kRowsOfPart - 1) / kRowsOfPart, [&](int part) {
    work({part * kRowsOfPart, std::min((part + 1) * kRowsOfPart, height)});
  });
}

}  // namespace

RasterPageRenderer::RasterPageRenderer(int threads) : crew_(threads) {}

void RasterPageRenderer::open(const PageSpace& space) {
  space_ = space;
  for (RasterPage& page : pages_) page = {};
}

Status RasterPageRenderer::reserve(uint32_t slots) {
  if (slots <= pages_.size()) return Status::ok();
  RETURN_IF_ERROR(check_page_slots(slots));
  return with_memory_for("room for " + std::to_string(slots) + " pages", [&] {
    pages_.resize(slots);
    return Status::ok();
  });
}

Status RasterPageRenderer::upload_page(uint32_t slot, const PageMesh& mesh) {
  const size_t vertices = mesh.positions.size();
  BURNISH_CHECK(slot < pages_.size(), "slots are reserved");
  BURNISH_CHECK(vertices <= kPageVerticesMax, "pages are checked where they are decoded");
  BURNISH_CHECK(mesh.triangles.size() <= kPageTrianglesMax,
                "pages are checked where they are decoded");
  const Status put = with_memory_for("page of " + std::to_string(vertices) + " vertices", [&] {
    pages_[slot].put(mesh);
    return Status::ok();
  });
  if (!put.is_ok()) pages_[slot] = {};
  return put;
}

RasterPage& RasterPageRenderer::filled(uint32_t slot, size_t vertices) {
  BURNISH_CHECK(slot < pages_.size(), "slots are reserved");
  BURNISH_CHECK(vertices == pages_[slot].vertices(), "one per vertex of the page in the slot");
  return pages_[slot];
}

Status RasterPageRenderer::move_page(uint32_t slot, std::span<const Vec3f> displacements,
                                     std::span<const Vec3f> normals,
                                     std::span<const float> ridges) {
  filled(slot, normals.size());
  filled(slot, ridges.size());
  RasterPage& page = filled(slot, displacements.size());
  return with_memory_for("displacements of a page", [&] {
    page.move(displacements, normals, ridges, space_.cell_size);
    return Status::ok();
  });
}

Status RasterPageRenderer::mark_page(uint32_t slot, std::span<const VertexMark> marks) {
  RasterPage& page = filled(slot, marks.size());
  return with_memory_for("marks of a page", [&] {
    page.marks.assign(marks.begin(), marks.end());
    return Status::ok();
  });
}

Status RasterPageRenderer::colour_page(uint32_t slot, std::span<const Rgba8> colours,
                                       std::span<const TexelChange> texels) {
  filled(slot, texels.size());
  RasterPage& page = filled(slot, colours.size());
  return with_memory_for("colours of a page", [&] {
    page.moved_colours.assign(colours.begin(), colours.end());
    page.moved_texels.assign(texels.begin(), texels.end());
    return Status::ok();
  });
}

Status RasterPageRenderer::texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) {
  BURNISH_CHECK(slot < pages_.size(), "slots are reserved");
  BURNISH_CHECK(!texture || texture->chart_of_triangle.size() == pages_[slot].triangles.size(),
                "one chart number per triangle of the page in the slot");
  pages_[slot].texture = std::move(texture);
  return Status::ok();
}

void RasterPageRenderer::check_patches(std::span<const PatchRange> patches) const {
  for (const PatchRange& patch : patches) {
    BURNISH_CHECK(patch.slot < pages_.size(), "slots are reserved");
    BURNISH_CHECK(size_t{patch.first} + patch.count <= pages_[patch.slot].triangles.size(),
                  "patches lie inside the page in their slot");
  }
}

Status RasterPageRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                                std::span<const PatchRange> patches) {
  check_patches(patches);
  RETURN_IF_ERROR(check_image_size(size));
  const std::string what =
      "picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels";
  const double seconds_before = crew_.seconds();
  return with_memory_for(what, [&] {
    const PageProjection projection = make_page_projection(space_, camera, size);
    const ShadedScene scene = make_shaded_scene(pages_, space_, projection, style);
    visibility_.size = size;
    visibility_.samples = sampling_ == RasterSampling::kOne ? 1 : 4;
    visibility_.keys.resize(size_t(size.width) * size.height * visibility_.samples);
    image_.rgb.resize(size_t{3} * size.width * size.height);
    image_.size = size;
    draw_pages(projection, style, patches);
    if (!patches.empty() && needs_surroundings(style.lighting)) {
      shade_with_surroundings(scene, style.lighting);
    } else {
      shade(scene);
    }
    draw_ms_ = 1e3 * (crew_.seconds() - seconds_before) / crew_.threads();
    return Status::ok();
  });
}

void RasterPageRenderer::draw_pages(const PageProjection& projection, const DrawStyle& style,
                                    std::span<const PatchRange> patches) {
  const ImageSize& size = visibility_.size;
  run_rows(crew_, size.height, [&](const RowRange& rows) {
    SampleKey* const keys = visibility_.keys.data();
    std::fill(keys + visibility_.place(0, rows.first), keys + visibility_.place(0, rows.end),
              kNothingSeen);
  });
  const int middle = split_column(style.split, size.width);
  fill_pages(pages_, projection, patches, {{0, middle}, true}, crew_, visibility_);
  fill_pages(pages_, projection, patches, {{middle, size.width}, style.original}, crew_,
             visibility_);
}

void RasterPageRenderer::shade(const ShadedScene& scene) {
  run_rows(crew_, image_.size.height,
           [&](const RowRange& rows) { shade_rows(scene, visibility_, rows, image_); });
}

void RasterPageRenderer::shade_with_surroundings(const ShadedScene& scene,
                                                 const Lighting& lighting) {
  const int height = image_.size.height;
  g_buffer_.resize(visibility_.keys.size());
  occlusions_.resize(size_t(image_.size.width) * height);
  run_rows(crew_, height,
           [&](const RowRange& rows) { shade_g_buffer(scene, visibility_, rows, g_buffer_); });
  const GBufferPlaces places(scene.projection, visibility_, g_buffer_);
  if (lighting.occlusion > 0)
    run_rows(crew_, height, [&](const RowRange& rows) { occlude_rows(places, rows, occlusions_); });
  run_rows(crew_, height, [&](const RowRange& rows) {
    light_g_buffer(places, g_buffer_, occlusions_, lighting, rows, image_);
  });
}

Result<Image> RasterPageRenderer::read_pixels() {
  if (image_.size == ImageSize{}) return failed_precondition("nothing has been drawn yet");
  return image_;
}

}  // namespace burnish
