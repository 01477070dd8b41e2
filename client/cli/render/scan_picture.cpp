#include "client/cli/render/scan_picture.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/cli/render/textured_picture.h"
#include "client/scene/raw_pages.h"
#include "common/base/mapped_file.h"
#include "common/base/text.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/io/named_files.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/textures/shown_picture.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

namespace {

/// Returns false only for a file that has no pictures.
bool may_show_pictures(std::span<const uint8_t> bytes, MeshFormat format) {
  if (format == MeshFormat::kObj || format == MeshFormat::kPly) return true;  // beside it
  return may_have_pictures(bytes, format);
}

bool shows_pictures(const SurfaceTextures& textures) {
  for (uint32_t t = 0; t < textures.triangles.size(); ++t)
    if (shown_picture(textures, t) != kNoTexture) return true;
  return false;
}

class ScanPainter {
 public:
  ScanPainter(const std::filesystem::path& scan, const PictureOptions& options, ScanColours colours)
      : scan_(scan), options_(options), colours_(colours) {
    const auto format = mesh_format_of_path(scan);
    if (!options_.up && format.is_ok() && is_gltf(*format)) options_.up = UpAxis::kY;
  }

  Result<ScanPicture> draw() {
    if (colours_ != ScanColours::kNone) RETURN_IF_ERROR(draw_with_textures());
    if (!is_drawn_) {
      ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(scan_));
      RETURN_IF_ERROR(draw_colours(mesh));
    }
    return std::move(drawn_);
  }

 private:
  /// Draws nothing if the scan has no pictures, or if none can be shown.
  Status draw_with_textures() {
    ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(scan_));
    ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(scan_));
    if (file.bytes().empty() || !may_show_pictures(file.bytes(), format)) return Status::ok();
    const FolderFiles files(scan_.parent_path());
    const MeshSurroundings beside{&files, scan_.filename().string(), {}};
    warn_of_missing(find_named_files(file.bytes(), format, beside));
    const auto take = [&](const TexturedSurface& surface) {
      if (shows_pictures(surface.textures)) {
        draw_textures(surface);
        return Status::ok();
      }
      warn_of_hidden(surface.textures.pictures);
      // Read by itself, a scan has the plain colours of its materials too.
      return surface.textures.triangles.empty() ? draw_colours(surface.mesh) : Status::ok();
    };
    return read_textured_surface(file.bytes(), format, scan_.string(), take, beside);
  }

  /// Names in files may control a terminal.
  void warn(const std::string& text) {
    constexpr size_t kWarningBytesMax = 5000;  // a path may have 4096
    drawn_.warnings.push_back(one_line(text, kWarningBytesMax));
  }

  // Stays silent if the files cannot be found: reading the scan says why.
  void warn_of_missing(const Result<NamedFiles>& named) {
    if (!named.is_ok() || named->missing.empty()) return;
    warn(missing_text(scan_.string(), named->missing));
  }

  void warn_of_hidden(const std::vector<SurfacePicture>& pictures) {
    if (pictures.empty()) return;
    std::vector<std::string> names;
    names.reserve(pictures.size());
    for (const SurfacePicture& picture : pictures) names.push_back(picture.name);
    warn("no triangle shows " + few_names(names) +
         ": one must have its material, and texture coordinates that are finite and up to " +
         std::to_string(static_cast<uint64_t>(kTextureCoordinateMax)));
  }

  void draw_textures(const TexturedSurface& surface) {
    MachineBudget machine;
    auto drawn = draw_textured_picture(surface, scan_.string(), options_, machine);
    if (!drawn.is_ok())
      return warn("the scan's pictures are not shown, but their mean colours: " +
                  drawn.status().message());
    for (const std::string& warning : drawn->warnings) warn(warning);
    if (!drawn->image) return;
    drawn_.image = *std::move(drawn->image);
    drawn_.camera = picture_camera(options_, referenced_box(surface.mesh));
    is_drawn_ = drawn_.is_textured = true;
  }

  Status draw_colours(const TriangleMesh& mesh) {
    if (colours_ == ScanColours::kNeeded && !mesh.has_colours()) return no_colours();
    PictureOptions options = options_;
    if (mesh.has_colours() && colours_ != ScanColours::kNone)
      options.style.colouring = Colouring::kScan;
    ASSIGN_OR_RETURN(drawn_.image, draw_picture(mesh, options));
    drawn_.camera = picture_camera(options, referenced_box(mesh));
    is_drawn_ = true;
    return Status::ok();
  }

  /// An error takes the place of the picture and its warnings, which may say why.
  Status no_colours() const {
    std::string text = scan_.string() + " has no colours";
    for (const std::string& warning : drawn_.warnings) text += "; " + warning;
    return failed_precondition(text);
  }

  const std::filesystem::path& scan_;
  PictureOptions options_;
  const ScanColours colours_;
  ScanPicture drawn_;
  bool is_drawn_ = false;
};

}  // namespace

Result<ScanPicture> draw_scan_picture(const std::filesystem::path& scan,
                                      const PictureOptions& options, ScanColours colours) {
  return ScanPainter(scan, options, colours).draw();
}

}  // namespace burnish
