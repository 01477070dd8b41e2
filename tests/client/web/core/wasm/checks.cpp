#include "tests/client/web/core/wasm/checks.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "client/live/framed_page.h"
#include "client/scene/page_mesh.h"
#include "common/base/text_lines.h"
#include "common/page_frames/page_frame_decoder.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/transfer/chunk.h"
#include "common/transfer/content_hash.h"
#include "common/wire/live_wire.h"

namespace burnish {

namespace {

/// FNV-1a of the bits of values.
class Fingerprint {
 public:
  template <typename Value>
  void add(const Value& value) {
    uint8_t bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    for (const uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3;
  }
  template <typename Values>
  void add_all(const Values& values) {
    add(static_cast<uint64_t>(values.size()));
    for (const auto& value : values) add(value);
  }
  std::string text() const {
    char digits[20];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

 private:
  uint64_t hash_ = 0xcbf29ce484222325;
};

void add_vectors(const std::vector<Vec3f>& vectors, Fingerprint& all) {
  for (const Vec3f& vector : vectors)
    for (int axis = 0; axis < 3; ++axis) all.add(vector[axis]);
}

std::string page_answer(std::span<const uint8_t> bytes) {
  const auto page = decode_page(bytes);
  if (!page.is_ok()) return page.status().to_string();
  Fingerprint all;
  for (const Vec3i& position : page->positions)
    for (int axis = 0; axis < 3; ++axis) all.add(position[axis]);
  all.add_all(page->triangles);
  all.add_all(page->colours);
  const PageMesh mesh = make_page_mesh(*page, {Vec3d(0.1, 0.2, 0.3), 3, 16});
  add_vectors(mesh.positions, all);
  add_vectors(mesh.normals, all);
  all.add_all(mesh.ridges);
  return std::to_string(page->triangles.size()) + " triangles " + all.text();
}

std::string head_answer(std::span<const uint8_t> bytes) {
  const auto head = decode_head(bytes);
  if (!head.is_ok()) return head.status().to_string();
  return std::to_string(head->page_count()) + " pages " + std::to_string(pages_fingerprint(bytes));
}

/// Takes parts from the front; an empty part where too few bytes are left.
class Parts {
 public:
  explicit Parts(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  uint32_t number() {
    uint32_t value = 0;
    const auto taken = take(sizeof value);
    std::memcpy(&value, taken.data(), taken.size());
    return value;
  }
  std::span<const uint8_t> take(size_t count) {
    const auto taken = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }
  std::vector<std::span<const uint8_t>> list() {
    std::vector<std::span<const uint8_t>> items;
    for (uint32_t left = number(); left > 0 && !bytes_.empty(); --left)
      items.push_back(take(number()));
    return items;
  }

 private:
  std::span<const uint8_t> bytes_;
};

std::string values_text(const PageFrameState& state) {
  Fingerprint all;
  for (const PageTile& tile : state.tiles) {
    std::vector<int32_t> values(tile.value_count());
    tile.read(values);
    all.add_all(values);
  }
  return all.text();
}

std::string frames_answer(std::span<const uint8_t> bytes) {
  Parts parts(bytes);
  const FrameTerms terms{static_cast<PageFrameKind>(parts.number() % 2),
                         static_cast<int>(parts.number() % 22),
                         static_cast<int>(parts.number() % 15)};
  PageFrameDecoder decoder(terms.kind);
  PageChange change{.revision = 1};
  Fingerprint layouts;
  for (const auto& encoded : parts.list()) {
    auto page = decode_page(encoded);
    if (!page.is_ok()) return page.status().to_string();
    const FramedPage framed = frame_page(std::make_shared<const Page>(std::move(*page)), terms);
    const PageLayout& layout = *framed.shown.layout;
    for (uint32_t value = 0; value < layout.value_count(); ++value)
      layouts.add_all(layout.predictors[value]);
    change.added.push_back(framed.shown);
  }
  const Status shown = decoder.show(change, kNoPage);
  if (!shown.is_ok()) return shown.to_string();
  std::string answer = "layouts " + layouts.text();
  for (const auto& frame : parts.list()) {
    const auto decoded = decoder.decode(frame);
    answer +=
        "\n" + (decoded.is_ok() ? values_text(decoder.state()) : decoded.status().to_string());
  }
  return answer;
}

std::string sheet_answer(std::span<const uint8_t> bytes) {
  const auto record = open_sheet(bytes);
  if (!record.is_ok()) return record.status().to_string();
  const SheetHeader& header = record->header;
  const auto webp = opaque_webp(record->webp, header.width, header.height, header.codec);
  if (!webp.is_ok()) return webp.status().to_string();
  Fingerprint all;
  for (const TexelPlace& place : record->layout.places) {
    all.add(place.x);
    all.add(place.y);
  }
  all.add_all(*webp);
  return std::to_string(header.width) + "x" + std::to_string(header.height) + " texels " +
         all.text();
}

std::string message_answer(std::span<const uint8_t> bytes) {
  v1::ServerMessage message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return "no message";
  const auto heard = from_wire(std::move(message));
  if (!heard.is_ok()) return heard.status().to_string();
  return *heard ? "kind " + std::to_string((*heard)->index()) : "unknown kind";
}

std::string hash_answer(std::string_view bytes) {
  ContentHash hash;
  hash.update(bytes.substr(0, bytes.size() / 3));
  hash.update(bytes.substr(bytes.size() / 3));
  return hash.finish() + " " + std::to_string(chunk_crc32(bytes));
}

std::string number_answer(std::string_view text) {
  const auto number = parse_real(text);
  if (!number.is_ok()) return number.status().to_string();
  Fingerprint bits;
  bits.add(*number);
  return bits.text();
}

}  // namespace

std::string answer_of(std::string_view kind, std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (kind == "page") return page_answer(bytes);
  if (kind == "head") return head_answer(bytes);
  if (kind == "sheet") return sheet_answer(bytes);
  if (kind == "frames") return frames_answer(bytes);
  if (kind == "message") return message_answer(bytes);
  if (kind == "hash") return hash_answer(text);
  if (kind == "number") return number_answer(text);
  return "no check has this name";
}

}  // namespace burnish
