#include "common/mesh/textures/texture_colours.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>

#include "common/mesh/agreeing_vertices.h"
#include "common/mesh/srgb.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/mesh/textures/texture_sweep.h"
#include "common/picture/picture_rows.h"

namespace burnish {

namespace {

constexpr Rgba8 kWhite = {255, 255, 255, 255};
constexpr uint64_t kJoiningBytes = 25;  // per vertex, of least_that_agree()

/// Sums the colours of a mesh's vertices, weighted by area.
class TexturePainter {
 public:
  TexturePainter(const TriangleMesh& mesh, const SurfaceTextures& textures,
                 const FileBudget& budget)
      : mesh_(mesh),
        textures_(textures),
        budget_(budget),
        sums_(mesh.vertices.size(), Eigen::Array4d::Zero()) {}

  /// Sorts the triangles by picture, and paints those without one.
  Status begin() {
    RETURN_IF_ERROR(find_least_area());
    first_of_.assign(textures_.pictures.size() + 1, 0);
    RETURN_IF_ERROR(for_each_triangle_heard([&](uint32_t t) {
      const uint32_t picture = shown_picture(textures_, t);
      if (picture == kNoTexture) return paint_plain(t);
      ++first_of_[picture + 1];
    }));
    std::partial_sum(first_of_.begin(), first_of_.end(), first_of_.begin());
    by_picture_.resize(first_of_.back());
    std::vector<uint32_t> next(first_of_.begin(), first_of_.end() - 1);
    return for_each_triangle_heard([&](uint32_t t) {
      const uint32_t picture = shown_picture(textures_, t);
      if (picture != kNoTexture) by_picture_[next[picture]++] = t;
    });
  }

  /// Fails: as read_picture_rows(); unimplemented beyond the limits; as the budget does.
  Status paint(uint32_t picture, const std::string& name) {
    const auto triangles = triangles_of(picture);
    has_begun_ = false;
    if (triangles.empty()) return Status::ok();
    if (picture >= kTexturePicturesMax)
      return unimplemented("a scan shows " + std::to_string(kTexturePicturesMax) + " pictures");
    const SurfacePicture& drawn = textures_.pictures[picture];
    ASSIGN_OR_RETURN(const auto file, drawn.read());
    return paint(triangles, file, name + ": " + drawn.name);
  }

  /// Gives triangles their plain colours after paint() has failed: all of the picture's, or bare
  /// vertices if a part of it was painted.
  void paint_rest(uint32_t picture) {
    for (const uint32_t t : triangles_of(picture)) {
      if (!has_begun_) paint_plain(t);
      for (const uint32_t v : mesh_.triangles[t])
        if (sums_[v][3] == 0) sums_[v] = plain_of(t);
    }
  }

  /// Gives vertices that look alike at one place the mean of all, so that a seam shows no line.
  /// Fails: cancelled, as the budget hears.
  Status join_alike() try {
    const Progress goes_on = [this](std::string_view, double) { return hear(budget_).is_ok(); };
    MeshView plain;
    plain.vertices = mesh_.vertices;
    plain.triangles = mesh_.triangles;
    const ScratchArray<uint32_t> least = least_that_agree(plain, {}, {goes_on, {}});
    for (uint32_t v = 0; v < least.size(); ++v)
      if (least[v] != v) sums_[least[v]] += sums_[v];
    for (uint32_t v = 0; v < least.size(); ++v) sums_[v] = sums_[least[v]];
    return Status::ok();
  } catch (const WorkCancelled&) {
    RETURN_IF_ERROR(hear(budget_));
    return cancelled("joining colours was cancelled");
  }

  std::vector<Rgba8> colours() const {
    std::vector<Rgba8> colours(sums_.size(), kWhite);
    for (size_t v = 0; v < sums_.size(); ++v) {
      const double weight = sums_[v][3];
      for (int i = 0; i < 3 && weight > 0; ++i)
        colours[v][i] = srgb_byte(static_cast<float>(sums_[v][i] / weight));
    }
    return colours;
  }

  /// Returns whether the pictures have two pixels of different colours.
  bool has_detail() const { return has_detail_; }

 private:
  template <typename Visit>
  Status for_each_triangle_heard(const Visit& visit) const {
    constexpr size_t kBlock = size_t{1} << 16;
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % kBlock == kBlock - 1) RETURN_IF_ERROR(hear(budget_));
      visit(static_cast<uint32_t>(t));
    }
    return Status::ok();
  }

  double area_of(uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vec3d& origin = mesh_.vertices[a];
    return (mesh_.vertices[b] - origin).cross(mesh_.vertices[c] - origin).norm() / 2;
  }

  /// A vertex of triangles without area has their colours all the same.
  Status find_least_area() {
    constexpr double kLeastPart = 1e-9;
    double sum = 0;
    RETURN_IF_ERROR(for_each_triangle_heard([&](uint32_t t) { sum += area_of(t); }));
    least_area_ = kLeastPart * sum / static_cast<double>(mesh_.triangles.size());
    return Status::ok();
  }

  std::span<const uint32_t> triangles_of(uint32_t picture) const {
    return std::span(by_picture_)
        .subspan(first_of_[picture], first_of_[picture + 1] - first_of_[picture]);
  }

  /// Returns the plain colour of a triangle, with the weight 1.
  Eigen::Array4d plain_of(uint32_t triangle) const {
    const uint32_t material = textures_.triangles[triangle].material;
    Eigen::Array4d colour = Eigen::Array4d::Ones();
    if (material != kNoTexture)
      colour.head<3>() = textures_.materials[material].plain.cast<double>().array();
    return colour;
  }

  void paint_plain(uint32_t triangle) {
    const double weight = (area_of(triangle) + least_area_) / 3;
    for (const uint32_t v : mesh_.triangles[triangle]) sums_[v] += weight * plain_of(triangle);
  }

  void add(uint32_t triangle, int corner, const Eigen::Array4d& part) {
    const SurfaceMaterial& material = textures_.materials[textures_.triangles[triangle].material];
    Eigen::Array4d coloured = part;
    coloured.head<3>() *= material.factor.cast<double>().array();
    sums_[mesh_.triangles[triangle][static_cast<size_t>(corner)]] +=
        (area_of(triangle) + least_area_) * coloured;
  }

  Status paint(std::span<const uint32_t> triangles, std::span<const uint8_t> file,
               const std::string& name) {
    std::optional<TextureSweep> sweep;
    const auto goes_on = [&] { return hear(budget_).is_ok(); };
    const auto begin = [&](const PictureSize& size) {
      RETURN_IF_ERROR(count_texels(size));
      if (budget_)
        RETURN_IF_ERROR(budget_(size.decoding_bytes + held_bytes() +
                                TextureSweep::bytes_of(triangles.size(), size)));
      sweep.emplace(textures_, triangles, size, goes_on);
      has_begun_ = true;
      return Status::ok();
    };
    const auto add_part = [&](uint32_t t, int corner, const Eigen::Array4d& part) {
      add(t, corner, part);
    };
    const auto take = [&](const PixelRun& run) {
      look_for_detail(run);
      sweep->take(run, add_part);
    };
    RETURN_IF_ERROR(read_picture_rows(file, name, {begin, take, goes_on}));
    return sweep->is_cancelled() ? cancelled(name + ": painting was cancelled") : Status::ok();
  }

  void look_for_detail(const PixelRun& run) {
    if (run.pixels.empty() || has_detail_) return;
    if (!first_pixel_) first_pixel_ = run.pixels[0];
    has_detail_ =
        std::ranges::any_of(run.pixels, [&](const Rgba8& c) { return c != *first_pixel_; });
  }

  Status count_texels(const PictureSize& size) {
    const uint64_t texels = texels_ + uint64_t{size.width} * size.height;
    if (texels > kTexelsMax)
      return unimplemented("the pictures so far have " + std::to_string(texels) +
                           " pixels, the limit is " + std::to_string(kTexelsMax));
    texels_ = texels;
    return Status::ok();
  }

  /// Returns the memory that textures and sums take.
  uint64_t held_bytes() const {
    return textures_.triangles.size() * sizeof(TexturedTriangle) +
           textures_.coordinates.size() * sizeof textures_.coordinates[0] +
           sums_.size() * (sizeof sums_[0] + kJoiningBytes) +
           by_picture_.size() * sizeof by_picture_[0];
  }

  const TriangleMesh& mesh_;
  const SurfaceTextures& textures_;
  const FileBudget& budget_;
  std::vector<Eigen::Array4d> sums_;  // per vertex: colour times weight, and weight
  std::vector<uint32_t> by_picture_;  // triangles
  std::vector<uint32_t> first_of_;    // of by_picture_, per picture
  uint64_t texels_ = 0;
  double least_area_ = 0;
  bool has_begun_ = false;
  std::optional<Rgba8> first_pixel_;  // of all pictures
  bool has_detail_ = false;
};

/// Paints all pictures. Fails: as add_texture_colours().
Status paint(TexturePainter& painter, const SurfaceTextures& textures, const std::string& name) {
  RETURN_IF_ERROR(painter.begin());
  for (uint32_t picture = 0; picture < textures.pictures.size(); ++picture) {
    const Status painted = painter.paint(picture, name);
    if (painted.is_ok()) continue;
    if (!can_be_left_out(painted, textures)) return painted;
    painter.paint_rest(picture);
  }
  return painter.join_alike();
}

bool is_one_colour(const std::vector<Rgba8>& colours) {
  return std::ranges::all_of(colours, [&](const Rgba8& c) { return c == colours[0]; });
}

}  // namespace

Status add_texture_colours(TriangleMesh& mesh, const SurfaceTextures& textures,
                           const FileBudget& budget, const std::string& name) {
  // Readers walk through a file twice; one whose walks differ must not end a server.
  if (textures.triangles.size() != mesh.triangles.size()) return Status::ok();
  TexturePainter painter(mesh, textures, budget);
  RETURN_IF_ERROR(paint(painter, textures, name));
  std::vector<Rgba8> colours = painter.colours();
  if (!mesh.has_colours()) {
    if (painter.has_detail() || !is_one_colour(colours)) mesh.colours = std::move(colours);
    return Status::ok();
  }
  for (size_t v = 0; v < colours.size(); ++v)
    for (size_t i = 0; i < 3; ++i)
      mesh.colours[v][i] =
          srgb_byte(linear_of_srgb(mesh.colours[v][i]) * linear_of_srgb(colours[v][i]));
  return Status::ok();
}

}  // namespace burnish
