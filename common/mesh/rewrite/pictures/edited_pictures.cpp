#include "common/mesh/rewrite/pictures/edited_pictures.h"

#include <optional>
#include <span>
#include <utility>

#include "common/base/limits.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/pictures/texel_changes.h"
#include "common/mesh/textures/shown_picture.h"

namespace burnish {

namespace {

constexpr size_t kHeardTriangles = size_t{1} << 16;

/// The triangles of each picture.
struct PictureUse {
  std::vector<uint32_t> triangles;
  bool is_edited = false;  // one of them is
};

class PictureEdits {
 public:
  PictureEdits(const TexturedSurface& surface, const ColourEdit& edit, PictureWork& work)
      : surface_(surface), edit_(edit), work_(work) {}

  Result<std::vector<EditedPicture>> edit() {
    RETURN_IF_ERROR(ask(surface_bytes() + triangle_bytes()));
    if (edit_.seams.is_on()) RETURN_IF_ERROR(level());
    RETURN_IF_ERROR(find_uses());
    uint64_t texels = 0;
    for (size_t p = 0; p < uses_.size(); ++p) {
      if (!uses_[p].is_edited) continue;
      ++work_.report.pictures;
      const Status edited = p < kTexturePicturesMax ? edit_picture(p, texels) : too_many();
      if (edited.is_ok()) continue;
      if (edited.code() == StatusCode::kCancelled ||
          edited.code() == StatusCode::kResourceExhausted)
        return edited;
      work_.report.kept.push_back(edited.message());
    }
    return std::move(edited_);
  }

 private:
  Status ask(uint64_t bytes) const { return work_.budget ? work_.budget(bytes) : Status::ok(); }

  Status level() {
    const auto beside = [&](uint64_t bytes) {
      return ask(bytes == 0 ? 0 : surface_bytes() + bytes);
    };
    ASSIGN_OR_RETURN(levelled_, level_seams(surface_, edit_.seams, beside));
    work_.report.seams = levelled_->report;
    return Status::ok();
  }

  const LevelledSeams* levelled() const { return levelled_ ? &*levelled_ : nullptr; }

  static Status too_many() {
    return unimplemented("pictures beyond the first " + std::to_string(kTexturePicturesMax));
  }

  /// Returns the memory of the surface and its textures.
  uint64_t surface_bytes() const {
    const SurfaceTextures& textures = surface_.textures;
    return std::span(surface_.mesh.vertices).size_bytes() +
           std::span(surface_.mesh.triangles).size_bytes() +
           std::span(surface_.mesh.colours).size_bytes() +
           std::span(textures.triangles).size_bytes() +
           std::span(textures.coordinates).size_bytes() + (levelled_ ? levelled_->byte_count() : 0);
  }

  uint64_t triangle_bytes() const {
    constexpr uint64_t kPlaces = 2;  // a vector that grows has room to spare
    return surface_.mesh.triangles.size() * sizeof(uint32_t) * kPlaces;
  }

  Status find_uses() {
    uses_.resize(surface_.textures.pictures.size());
    for (size_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
      if (t % kHeardTriangles == 0) RETURN_IF_ERROR(ask(0));
      const uint32_t picture = shown_picture(surface_.textures, static_cast<uint32_t>(t));
      const bool is_recoloured = edit_.changes(surface_.mesh.triangles[t]);
      if (picture == kNoTexture) {
        work_.report.bare_triangles += is_recoloured;
        continue;
      }
      uses_[picture].triangles.push_back(static_cast<uint32_t>(t));
      uses_[picture].is_edited |=
          is_recoloured || (levelled_ && levelled_->changes(static_cast<uint32_t>(t)));
    }
    return Status::ok();
  }

  /// Fails: also for what only this picture cannot.
  Status edit_picture(size_t number, uint64_t& texels) {
    const SurfacePicture& picture = surface_.textures.pictures[number];
    const auto file = picture.read();
    if (!file.is_ok()) return file.status().with_context(picture.name);
    const std::span<const uint32_t> triangles = uses_[number].triangles;
    std::optional<PicturePlace> place;
    std::optional<TexelChanges> changes;
    const auto goes_on = [&] { return ask(0).is_ok(); };
    const auto begin = [&](const PictureSize& size) {
      RETURN_IF_ERROR(count(size, texels));
      RETURN_IF_ERROR(ask(size.decoding_bytes + surface_bytes() + held_bytes_ + triangle_bytes() +
                          TexelChanges::bytes_of(triangles.size(), size.width)));
      ASSIGN_OR_RETURN(place,
                       PicturePlace::find(surface_.textures, triangles, size.width, size.height));
      changes.emplace(TexelEdit{surface_, edit_, levelled()}, triangles, *place, size.width,
                      size.height);
      return Status::ok();
    };
    const auto change = [&](const FileRows& rows) { return changes->change(rows, goes_on); };
    ASSIGN_OR_RETURN(RewrittenPicture rewritten,
                     rewrite_picture(*file, picture.name, {begin, change, goes_on}));
    take(picture, std::move(rewritten), changes->shared_texels());
    return Status::ok();
  }

  static Status count(const PictureSize& size, uint64_t& texels) {
    texels += uint64_t{size.width} * size.height;
    if (texels <= kTexelsMax) return Status::ok();
    return unimplemented("the pictures so far have " + std::to_string(texels) +
                         " pixels, the limit is " + std::to_string(kTexelsMax));
  }

  void take(const SurfacePicture& picture, RewrittenPicture rewritten, uint64_t shared_texels) {
    if (rewritten.texels == 0) return;
    PictureReport& report = work_.report;
    ++report.changed;
    report.texels += rewritten.texels;
    report.shared_texels += shared_texels;
    if (!rewritten.note.empty()) report.notes.push_back(picture.name + ": " + rewritten.note);
    held_bytes_ += rewritten.bytes.size();
    edited_.push_back({picture.path, picture.image, std::move(rewritten.bytes)});
  }

  const TexturedSurface& surface_;
  const ColourEdit& edit_;
  PictureWork& work_;
  std::optional<LevelledSeams> levelled_;
  std::vector<PictureUse> uses_;  // by picture
  std::vector<EditedPicture> edited_;
  uint64_t held_bytes_ = 0;  // of the edited ones
};

}  // namespace

std::string text_of(const PictureReport& report) {
  if (report.pictures == 0) return report.seams ? text_of(*report.seams) : std::string();
  std::string text = std::to_string(report.changed) + " of " + std::to_string(report.pictures) +
                     " pictures changed, " + std::to_string(report.texels) + " texels";
  if (report.shared_texels > 0)
    text += "; " + std::to_string(report.shared_texels) +
            " of them are shown more than once and got the mean";
  if (report.seams) text += "; " + text_of(*report.seams);
  for (const std::string& note : report.notes) text += "; " + note;
  return text;
}

Result<std::vector<EditedPicture>> edit_pictures(const TexturedSurface& surface,
                                                 const ColourEdit& edit, PictureWork& work) {
  return PictureEdits(surface, edit, work).edit();
}

Result<std::vector<EditedPicture>> edit_pictures_of(const PicturesSource& source,
                                                    const ColourEdit& edit, PictureWork* work) {
  std::vector<EditedPicture> edited;
  const bool has_textures = source.format == MeshFormat::kObj ||
                            source.format == MeshFormat::kPly || is_gltf(source.format);
  if (work == nullptr || !has_textures || !edit.is_there()) return edited;
  if (work->budget) RETURN_IF_ERROR(work->budget(kReadingBytesPerFileByte * source.bytes.size()));
  const auto take = [&](const TexturedSurface& surface) -> Status {
    if (surface.textures.triangles.empty()) return Status::ok();
    if (surface.mesh.vertices.size() != edit.before.size())
      return changed_original(source.name, "it has another number of vertices");
    ASSIGN_OR_RETURN(edited, edit_pictures(surface, edit, *work));
    return Status::ok();
  };
  RETURN_IF_ERROR(
      read_textured_surface(source.bytes, source.format, source.name, take, source.beside));
  return edited;
}

}  // namespace burnish
