#include "tests/fuzz/readers.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>
#include <xxhash.h>

#include "client/cli/cell_field_file.h"
#include "client/cli/stroke_file.h"
#include "client/model/settings/preferences.h"
#include "client/script/script.h"
#include "common/base/check.h"
#include "common/edit/transfer_curve.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/obj/mtl_reader.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/mesh/textures/texture_row.h"
#include "common/picture/picture.h"
#include "common/picture/picture_rewriter.h"
#include "common/wire/edit_bytes.h"
#include "server/config/config_file.h"
#include "server/fields/paint_checkpoints.h"
#include "server/library/scan_record.h"
#include "server/prepare/prepared_file.h"
#include "server/trust/users.h"
#include "tests/fuzz/memory_file.h"

namespace burnish {
namespace {

constexpr size_t kPaintedCells = 1000;

std::string_view text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// toml++ 3.3 reaches its own "unreachable" for letters beyond ASCII outside of texts, which is
/// undefined behaviour. So such files are not tried.
bool is_ascii(std::span<const uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](uint8_t byte) { return byte < 0x80; });
}

bool read_curve(std::span<const uint8_t> bytes) {
  const auto curve = TransferCurve::parse(text_of(bytes));
  if (!curve.is_ok()) return false;
  const auto again = TransferCurve::parse(curve->to_string());
  BURNISH_CHECK(again.is_ok() && *again == *curve, "a curve does not read back");
  return true;
}

bool read_strokes(std::span<const uint8_t> bytes) {
  return parse_strokes(text_of(bytes), "fuzzed").is_ok();
}

bool read_cell_fields(std::span<const uint8_t> bytes) {
  return parse_cell_fields(text_of(bytes), "fuzzed").is_ok();
}

bool read_materials(std::span<const uint8_t> bytes) {
  return read_material_file(bytes, "fuzzed").is_ok();
}

/// Writes a picture again with darker greens.
static void rewrite_fuzzed_picture(std::span<const uint8_t> bytes, const Picture& before) {
  const auto begin = [](const PictureSize&) { return Status::ok(); };
  const auto change = [](const FileRows& rows) {
    for (FileTexel& texel : rows.texels) texel[1] /= 2;
    return Status::ok();
  };
  const auto rewritten = rewrite_picture(bytes, "fuzzed", {begin, change, {}});
  if (!rewritten.is_ok() || rewritten->bytes.empty()) return;
  const auto after = read_picture(rewritten->bytes, "rewritten");
  BURNISH_CHECK(after.is_ok(), after.status().message());
  BURNISH_CHECK(after->width == before.width && after->height == before.height,
                "a rewritten picture has other sides");
}

bool read_fuzzed_picture(std::span<const uint8_t> bytes) {
  const auto picture = read_picture(bytes, "fuzzed");
  if (!picture.is_ok()) return false;
  BURNISH_CHECK(picture->pixels.size() == size_t{picture->width} * picture->height,
                "a picture has other than its pixels");
  rewrite_fuzzed_picture(bytes, *picture);
  TextureRow row(picture->width);
  row.set({0, 0, 1, std::span(picture->pixels).first(picture->width)});
  (void)row.mean(-0.3, 1e6, TextureWrap::kMirror);
  return true;
}

/// An archive as the server bakes it: each triangle finds its material and its picture.
bool read_fuzzed_textures(std::span<const uint8_t> bytes) {
  return read_textured_surface(bytes, MeshFormat::kZip, "fuzzed",
                               [](const TexturedSurface& surface) {
                                 for (uint32_t t = 0; t < surface.textures.triangles.size(); ++t)
                                   (void)shown_picture(surface.textures, t);
                                 for (const SurfacePicture& picture : surface.textures.pictures)
                                   (void)picture.read();
                                 return Status::ok();
                               })
      .is_ok();
}

bool read_fuzzed_script(std::span<const uint8_t> bytes) {
  return parse_script(text_of(bytes), "fuzzed").is_ok();
}

bool read_fuzzed_preferences(std::span<const uint8_t> bytes) {
  return is_ascii(bytes) && read_preferences(MemoryFile(bytes).path()).is_ok();
}

bool read_users(std::span<const uint8_t> bytes) {
  return is_ascii(bytes) && read_users_file(MemoryFile(bytes).path()).is_ok();
}

bool read_config(std::span<const uint8_t> bytes) {
  ServerConfig config;
  return is_ascii(bytes) && read_config_text(text_of(bytes), "fuzzed", config).is_ok() &&
         validate(config).is_ok();
}

bool read_scan_record(std::span<const uint8_t> bytes) {
  return scan_from_json(std::string(text_of(bytes))).is_ok();
}

bool read_edit(std::span<const uint8_t> bytes) {
  const auto edit = edit_from_bytes(text_of(bytes));
  if (!edit.is_ok()) return false;
  const std::string kept = edit_to_bytes(*edit);
  const auto again = edit_from_bytes(kept);
  BURNISH_CHECK(again.is_ok() && edit_to_bytes(*again) == kept, "an edit does not read back");
  return true;
}

/// The first eight bytes are the hash of the rest; this corrects them.
bool read_painted(std::span<const uint8_t> bytes) {
  const std::string_view body = text_of(bytes);
  const uint64_t hash = XXH3_64bits(body.data(), body.size());
  std::string sealed(reinterpret_cast<const char*>(&hash), sizeof hash);
  sealed += body;
  (void)painted_from_bytes(body, kPaintedCells);
  const auto painted = painted_from_bytes(sealed, kPaintedCells);
  if (!painted.is_ok()) return false;
  BURNISH_CHECK(painted_to_bytes(*painted) == sealed, "paint does not read back");
  return true;
}

/// Corrects the checksums of the sections that lie within the file, and the header's.
void seal_prepared(std::span<uint8_t> file) {
  if (file.size() < sizeof(PreparedHeader)) return;
  PreparedHeader header;
  std::memcpy(&header, file.data(), sizeof header);
  for (SectionEntry& section : header.sections) {
    const uint64_t size = section.count * section.element_bytes;
    const bool is_inside = section.offset <= file.size() && size <= file.size() - section.offset;
    if (is_inside) section.checksum = prepared_checksum(file.subspan(section.offset, size));
  }
  header.checksum = header_checksum(header);
  std::memcpy(file.data(), &header, sizeof header);
}

bool read_prepared(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> sealed(bytes.begin(), bytes.end());
  seal_prepared(sealed);
  return read_prepared_mesh(MemoryFile(sealed).path()).is_ok();
}

constexpr FuzzedReader kReaders[] = {
    {"cell_fields", read_cell_fields},
    {"config", read_config},
    {"curve", read_curve},
    {"edit", read_edit},
    {"hierarchy", read_fuzzed_hierarchy},
    {"live", read_live_messages},
    {"materials", read_materials},
    {"charts", read_fuzzed_charts},
    {"sheet", read_fuzzed_sheet},
    {"sheet_block", read_sheet_block},
    {"sheet_file", read_sheet_file},
    {"page", read_fuzzed_page},
    {"page_block", read_page_block},
    {"page_file", read_page_file},
    {"page_frames", read_page_frames},
    {"painted", read_painted},
    {"picture", read_fuzzed_picture},
    {"preferences", read_fuzzed_preferences},
    {"prepared", read_prepared},
    {"scan_record", read_scan_record},
    {"script", read_fuzzed_script},
    {"server_message", read_server_message},
    {"strokes", read_strokes},
    {"textured", read_fuzzed_textures},
    {"users", read_users},
    {"web_frames", read_web_frames},
    {"web_request", read_web_request},
};

}  // namespace

std::span<const FuzzedReader> fuzzed_readers() {
  return kReaders;
}

const FuzzedReader& fuzzed_reader(std::string_view name) {
  const auto found = std::ranges::find(kReaders, name, &FuzzedReader::name);
  BURNISH_CHECK(found != std::end(kReaders), std::string(name));
  return *found;
}

}  // namespace burnish
