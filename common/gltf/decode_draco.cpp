#include "common/gltf/decode_draco.h"

#include <new>
#include <type_traits>

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

namespace burnish {

namespace {

/// Decodes no more than the views can be charged for. Draco itself believes the counts in its data.
template <typename Decoder>
class ChargedDecoder final : public Decoder {
 public:
  explicit ChargedDecoder(UnpackedViews& views) : views_(views) {}

  const Status& refusal() const { return refusal_; }

 protected:
  bool DecodeGeometryData() override {
    constexpr bool kIsSequential = std::is_same_v<Decoder, draco::MeshSequentialDecoder>;
    constexpr uint64_t kTableBytes = 32, kSeamBytes = 20;  // of a face; with seams of an attribute
    draco::DecoderBuffer ahead = *this->buffer();
    uint32_t first = 0, second = 0;
    uint8_t seams = 0;
    if (this->bitstream_version() < DRACO_BITSTREAM_VERSION(2, 2) ||
        !draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead) ||
        (!kIsSequential && !ahead.Decode(&seams)))
      return false;
    const uint64_t bytes = (uint64_t{first} + second) * (kTableBytes + kSeamBytes * seams);
    return charge(bytes) && Decoder::DecodeGeometryData();
  }

  bool DecodeAllAttributes() override {
    constexpr uint64_t kMapBytes = 4, kPortableBytes = 4;
    const draco::PointCloud& cloud = *this->point_cloud();
    for (int i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      const auto components = static_cast<uint64_t>(attribute.num_components());
      const auto value_bytes = static_cast<uint64_t>(attribute.byte_stride());
      if (!charge(cloud.num_points() * (kMapBytes + kPortableBytes * components + value_bytes)))
        return false;
    }
    return Decoder::DecodeAllAttributes();
  }

 private:
  bool charge(uint64_t bytes) {
    refusal_ = views_.charge(bytes);
    return refusal_.is_ok();
  }

  UnpackedViews& views_;
  Status refusal_;
};

template <typename Decoder>
Status decode_by(UnpackedViews& views, std::span<const uint8_t> bytes, const std::string& place,
                 draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  ChargedDecoder<Decoder> decoder(views);
  const bool is_decoded = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh).ok();
  RETURN_IF_ERROR(decoder.refusal().with_context(place));
  if (is_decoded) return Status::ok();
  return invalid_argument(place + ": its Draco data are damaged");
}

Status decode_checked(UnpackedViews& views, std::span<const uint8_t> bytes,
                      const std::string& place, draco::Mesh& mesh) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header{};
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() ||
      header.encoder_type != draco::TRIANGULAR_MESH)
    return invalid_argument(place + ": its Draco data are not a mesh");
  if ((header.flags & METADATA_FLAG_MASK) != 0)
    return invalid_argument(place + ": its Draco data have metadata, which cannot be read");
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
    return decode_by<draco::MeshEdgebreakerDecoder>(views, bytes, place, mesh);
  return decode_by<draco::MeshSequentialDecoder>(views, bytes, place, mesh);
}

}  // namespace

/// Draco throws what the standard library throws.
Status decode_draco(UnpackedViews& views, std::span<const uint8_t> bytes, const std::string& place,
                    draco::Mesh& mesh) {
  try {
    return decode_checked(views, bytes, place, mesh);
  } catch (const std::bad_alloc&) {
    return resource_exhausted(place + ": not enough memory for its Draco data");
  } catch (const WorkCancelled&) {
    throw;
  } catch (const std::exception&) {
    return invalid_argument(place + ": its Draco data are damaged");
  }
}

}  // namespace burnish
