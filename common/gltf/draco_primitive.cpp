#include "common/gltf/draco_primitive.h"

#include <new>

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

/// Draco throws what the standard library throws.
Status decode_mesh(UnpackedViews& views, std::span<const uint8_t> bytes, const std::string& place,
                   draco::Mesh& mesh) {
  try {
    return decode_checked(views, bytes, place, mesh);
  } catch (const std::bad_alloc&) {
    return resource_exhausted(place + ": not enough memory for its Draco data");
  } catch (const std::exception&) {
    return invalid_argument(place + ": its Draco data are damaged");
  }
}

template <typename T>
bool copy_values(const draco::PointAttribute& attribute, const GltfAccessor& accessor,
                 std::vector<uint8_t>& bytes) {
  const auto components = static_cast<int8_t>(accessor.element.components);
  const size_t size = accessor.element.bytes();
  for (uint32_t i = 0; i < accessor.count; ++i) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
    std::array<T, 4> numbers = {};
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(value, components, numbers.data()))
      return false;
    std::memcpy(bytes.data() + i * size, numbers.data(), size);
  }
  return true;
}

bool copy_values_of_type(const draco::PointAttribute& attribute, const GltfAccessor& accessor,
                         std::vector<uint8_t>& bytes) {
  switch (accessor.element.component) {
    case GltfComponent::kByte:
      return copy_values<int8_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedByte:
      return copy_values<uint8_t>(attribute, accessor, bytes);
    case GltfComponent::kShort:
      return copy_values<int16_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedShort:
      return copy_values<uint16_t>(attribute, accessor, bytes);
    case GltfComponent::kUnsignedInt:
      return copy_values<uint32_t>(attribute, accessor, bytes);
    case GltfComponent::kFloat:
      return copy_values<float>(attribute, accessor, bytes);
  }
  return false;
}

Result<GltfAccessor> read_attribute(UnpackedViews& views, const draco::Mesh& mesh,
                                    uint64_t accessor_index, uint64_t id,
                                    const std::string& place) {
  ASSIGN_OR_RETURN(GltfAccessor accessor,
                   read_accessor_shape(views.document(), accessor_index, place));
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
  if (attribute == nullptr)
    return invalid_argument(place + ": its Draco data have no attribute " + std::to_string(id));
  if (accessor.count != mesh.num_points())
    return invalid_argument(place + ": its Draco data have " + std::to_string(mesh.num_points()) +
                            " points, but accessor " + std::to_string(accessor_index) + " has " +
                            std::to_string(accessor.count));
  RETURN_IF_ERROR(views.charge(accessor.count * accessor.element.bytes()));
  std::vector<uint8_t> bytes(accessor.count * accessor.element.bytes());
  if (!copy_values_of_type(*attribute, accessor, bytes))
    return invalid_argument(place + ": Draco attribute " + std::to_string(id) + " is damaged");
  set_made_bytes(accessor, std::move(bytes));
  return accessor;
}

GltfAccessor indices_of(const draco::Mesh& mesh) {
  std::vector<uint8_t> bytes(size_t{mesh.num_faces()} * sizeof(draco::Mesh::Face));
  for (uint32_t f = 0; f < mesh.num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(f));
    const std::array<uint32_t, 3> corners = {face[0].value(), face[1].value(), face[2].value()};
    std::memcpy(bytes.data() + f * sizeof corners, corners.data(), sizeof corners);
  }
  GltfAccessor accessor;
  accessor.count = uint64_t{3} * mesh.num_faces();
  accessor.element = {GltfComponent::kUnsignedInt, 1, false};
  set_made_bytes(accessor, std::move(bytes));
  return accessor;
}

}  // namespace

Status read_draco(UnpackedViews& views, const GltfJson& json, const GltfJson& draco_json,
                  const std::string& place, GltfPrimitive& primitive) {
  ASSIGN_OR_RETURN(const uint64_t view_index, read_whole(draco_json, "bufferView", place));
  ASSIGN_OR_RETURN(const GltfView view, views.view(view_index, place));
  draco::Mesh mesh;
  RETURN_IF_ERROR(decode_mesh(views, view.bytes, place, mesh));
  RETURN_IF_ERROR(views.charge(uint64_t{12} * mesh.num_faces()));
  primitive.mode = GltfMode::kTriangles;
  primitive.indices = indices_of(mesh);
  ASSIGN_OR_RETURN(primitive.indices->index, read_whole(json, "indices", place, kNoAccessor));
  const GltfJson* ids = find_object(draco_json, {"attributes"});
  const GltfJson* accessors = find_object(json, {"attributes"});
  if (ids == nullptr) return invalid_argument(place + ": its Draco data name no attributes");
  for (const auto& item : ids->items()) {
    const std::string& name = item.key();
    if (find_member(*accessors, name.c_str()) == nullptr) continue;
    ASSIGN_OR_RETURN(const uint64_t number, read_whole(*ids, name.c_str(), place));
    ASSIGN_OR_RETURN(const uint64_t index, read_whole(*accessors, name.c_str(), place));
    ASSIGN_OR_RETURN(GltfAccessor accessor, read_attribute(views, mesh, index, number, place));
    primitive.attributes.emplace(name, std::move(accessor));
  }
  return Status::ok();
}

}  // namespace burnish
