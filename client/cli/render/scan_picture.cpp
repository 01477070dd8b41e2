#include "client/cli/render/scan_picture.h"

#include <optional>
#include <span>
#include <utility>

#include "client/cli/render/textured_picture.h"
#include "common/base/mapped_file.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/io/named_files.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

namespace {

/// Returns false only for a file that has no pictures.
bool may_show_pictures(std::span<const uint8_t> bytes, MeshFormat format) {
  if (format == MeshFormat::kObj || format == MeshFormat::kPly) return true;  // beside it
  return may_have_pictures(bytes, format);
}

class ScanPainter {
 public:
  ScanPainter(const std::filesystem::path& scan, const PictureOptions& options, ScanColours colours)
      : scan_(scan), options_(options), colours_(colours) {}

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
      if (surface.textures.triangles.empty()) return draw_colours(surface.mesh);
      draw_textures(surface);
      return Status::ok();
    };
    return read_textured_surface(file.bytes(), format, scan_.string(), take, beside);
  }

  // Where files cannot be found, reading the scan says why.
  void warn_of_missing(const Result<NamedFiles>& named) {
    if (!named.is_ok() || named->missing.empty()) return;
    std::string text = "not beside " + scan_.string() + ":";
    for (const std::string& name : named->missing) text += " " + name;
    drawn_.warnings.push_back(text);
  }

  void draw_textures(const TexturedSurface& surface) {
    auto drawn = draw_textured_picture(surface, scan_.string(), options_);
    if (!drawn.is_ok()) {
      drawn_.warnings.push_back("the scan's pictures are not shown, but their mean colours: " +
                                drawn.status().message());
      return;
    }
    for (std::string& warning : drawn->warnings) drawn_.warnings.push_back(std::move(warning));
    if (!drawn->image) return;
    drawn_.image = *std::move(drawn->image);
    is_drawn_ = drawn_.is_textured = true;
  }

  Status draw_colours(const TriangleMesh& mesh) {
    if (colours_ == ScanColours::kNeeded && !mesh.has_colours())
      return failed_precondition(scan_.string() + " has no colours");
    PictureOptions options = options_;
    if (mesh.has_colours() && colours_ != ScanColours::kNone)
      options.style.colouring = Colouring::kScan;
    ASSIGN_OR_RETURN(drawn_.image, draw_picture(mesh, options));
    is_drawn_ = true;
    return Status::ok();
  }

  const std::filesystem::path& scan_;
  const PictureOptions& options_;
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
