#include "server/prepare/sheets/decode_pictures.h"

#include <algorithm>
#include <span>
#include <vector>

#include "common/base/loop_progress.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/packing/checksum.h"

namespace burnish {

namespace {

std::vector<uint8_t> find_shown(const SurfaceTextures& textures) {
  std::vector<uint8_t> is_shown(textures.pictures.size(), 0);
  for (uint32_t t = 0; t < textures.triangles.size(); ++t)
    if (const uint32_t picture = shown_picture(textures, t); picture != kNoTexture)
      is_shown[picture] = 1;
  return is_shown;
}

class PictureDecoder {
 public:
  PictureDecoder(const SurfaceTextures& textures, const std::string& name, const AdmitBytes& admit,
                 const Progress& progress, DecodedPictures& decoded)
      : textures_(textures),
        name_(name),
        admit_(admit),
        rows_(progress, "pictures", 0, 1),
        decoded_(decoded) {}

  Status decode(uint32_t picture) {
    const SurfacePicture& shown = textures_.pictures[picture];
    const double part =
        static_cast<double>(picture) / static_cast<double>(textures_.pictures.size());
    if (!rows_.goes_on(part)) return cancelled("reading pictures was cancelled");
    if (picture >= kTexturePicturesMax)
      return unimplemented("picture " + std::to_string(picture) + ": the limit of a scan is " +
                           std::to_string(kTexturePicturesMax));
    ASSIGN_OR_RETURN(const auto file, shown.read());
    decoded_.fingerprint =
        (decoded_.fingerprint ^ sealed_checksum(file, 0, 0)) * 0xd6e8feb86659fd93;
    const auto begin = [&](const PictureSize& size) { return take(size); };
    const auto goes_on = [&] { return rows_.goes_on(part); };
    return decoded_.tiles.decode(picture, file, name_ + ": " + shown.name, begin, goes_on);
  }

 private:
  Status take(const PictureSize& size) {
    const uint64_t texels = texels_ + uint64_t{size.width} * size.height;
    if (texels > kTexelsMax)
      return unimplemented("the pictures so far have " + std::to_string(texels) +
                           " pixels, the limit is " + std::to_string(kTexelsMax));
    RETURN_IF_ERROR(admit_(PictureTiles::memory_bytes(size), PictureTiles::scratch_bytes(size)));
    texels_ = texels;
    return Status::ok();
  }

  const SurfaceTextures& textures_;
  const std::string& name_;
  const AdmitBytes& admit_;
  LoopProgress rows_;
  DecodedPictures& decoded_;
  uint64_t texels_ = 0;
};

}  // namespace

Result<DecodedPictures> decode_pictures(const SurfaceTextures& textures, const std::string& name,
                                        const std::filesystem::path& folder,
                                        const AdmitBytes& admit, const Progress& progress) {
  ASSIGN_OR_RETURN(PictureTiles tiles, PictureTiles::create(folder, textures.pictures.size()));
  DecodedPictures decoded{std::move(tiles)};
  PictureDecoder decoder(textures, name, admit, progress, decoded);
  const std::vector<uint8_t> is_shown = find_shown(textures);
  for (uint32_t picture = 0; picture < is_shown.size(); ++picture) {
    if (is_shown[picture] == 0) continue;
    const Status status = decoder.decode(picture);
    if (!status.is_ok()) {
      if (!can_be_left_out(status, textures)) return status;
      decoded.left_out.push_back(status);
    }
    decoded.count += decoded.tiles.has(picture);
  }
  return decoded;
}

}  // namespace burnish
