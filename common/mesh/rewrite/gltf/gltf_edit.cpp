#include "common/mesh/rewrite/gltf/gltf_edit.h"

#include <algorithm>
#include <string_view>

#include "common/base/check.h"
#include "common/gltf/base64.h"
#include "common/gltf/data_uri.h"
#include "common/mesh/rewrite/gltf/gltf_view_range.h"

namespace burnish {

static constexpr size_t kChunkAlignment = 4;

GltfEdit::GltfEdit(const GltfDocument& document, std::span<const uint8_t> original)
    : document_(document), original_(original), json_(document.json) {}

std::vector<uint8_t>& GltfEdit::edited(uint64_t index) {
  const auto [found, is_new] = edited_.try_emplace(index);
  if (is_new) {
    const auto bytes = document_.buffers[index].bytes;
    found->second.assign(bytes.begin(), bytes.end());
  }
  return found->second;
}

/// Returns the first buffer that has bytes. There is one: without bytes there is no surface.
uint64_t GltfEdit::buffer_to_extend() const {
  const auto has_bytes = [](const GltfBuffer& b) { return b.home != GltfBuffer::Home::kNowhere; };
  const auto found = std::ranges::find_if(document_.buffers, has_bytes);
  BURNISH_CHECK(found != document_.buffers.end(), "a surface has bytes");
  return static_cast<uint64_t>(found - document_.buffers.begin());
}

uint64_t GltfEdit::append_view(std::span<const uint8_t> bytes, uint64_t stride) {
  const uint64_t index = buffer_to_extend();
  std::vector<uint8_t>& buffer = edited(index);
  buffer.resize((buffer.size() + kChunkAlignment - 1) / kChunkAlignment * kChunkAlignment);
  GltfJson view = {{"buffer", index}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
  if (stride != 0) view["byteStride"] = stride;
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  json_["buffers"][index]["byteLength"] = buffer.size();
  json_["bufferViews"].push_back(std::move(view));
  return json_["bufferViews"].size() - 1;
}

/// Moves a view, or what an extension says of its packed bytes.
static void move_if_behind(GltfJson& view, const GltfViewRange& grown, uint64_t bytes) {
  const GltfViewRange range(view);
  if (range.buffer == grown.buffer && range.begin >= grown.end)
    view["byteOffset"] = range.begin + bytes;
}

void GltfEdit::replace_view(uint64_t index, std::span<const uint8_t> bytes) {
  constexpr uint64_t kViewAlignment = 8;  // of the largest numbers, for the views behind
  GltfJson& views = json_["bufferViews"];
  const GltfViewRange range(views[index]);
  std::vector<uint8_t>& buffer = edited(range.buffer);
  const uint64_t room = range.end - range.begin;
  if (bytes.size() > room) {
    const uint64_t lack = (bytes.size() - room + kViewAlignment - 1) & ~(kViewAlignment - 1);
    for (GltfJson& view : views) {
      move_if_behind(view, range, lack);
      if (!view.contains("extensions")) continue;
      for (GltfJson& extension : view["extensions"]) move_if_behind(extension, range, lack);
    }
    buffer.insert(buffer.begin() + static_cast<ptrdiff_t>(range.end), lack, 0);
    json_["buffers"][range.buffer]["byteLength"] = buffer.size();
  }
  views[index]["byteLength"] = bytes.size();
  std::ranges::copy(bytes, buffer.begin() + static_cast<ptrdiff_t>(range.begin));
}

void GltfEdit::put_data_uris() {
  for (const auto& [index, bytes] : edited_) {
    if (document_.buffers[index].home != GltfBuffer::Home::kText) continue;
    GltfJson& uri = json_["buffers"][index]["uri"];
    const std::string before = uri.get<std::string>();
    uri = before.substr(0, find_base64(before)) + to_base64(bytes);
  }
}

/// Returns the original's text if nothing changed in it, else one that is indented as it is.
std::string GltfEdit::json_text() const {
  const std::string_view text =
      document_.is_binary
          ? document_.parts.json
          : std::string_view(reinterpret_cast<const char*>(original_.data()), original_.size());
  if (json_ == document_.json) return std::string(text);
  const size_t line = text.find('\n');
  const size_t begin =
      line == std::string_view::npos ? line : text.find_first_not_of(" \t", line + 1);
  const std::string_view end = text.substr(text.find_last_not_of(" \t\r\n") + 1);
  const bool is_one_line = begin == std::string_view::npos || line > text.size() - end.size();
  const int width = is_one_line ? -1 : static_cast<int>(begin - line - 1);
  return json_.dump(width, width > 0 ? text[line + 1] : ' ').append(end);
}

Status GltfEdit::write(OutputBuffer& output, std::vector<GltfFileBeside>& beside) {
  put_data_uris();
  for (auto& [index, bytes] : edited_) {
    const GltfBuffer& buffer = document_.buffers[index];
    if (buffer.home == GltfBuffer::Home::kBeside) beside.push_back({buffer.path, std::move(bytes)});
  }
  if (document_.is_binary) return write_binary(output);
  output.put_text(json_text());
  return Status::ok();
}

static std::string_view text_of_bytes(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Status GltfEdit::write_binary(OutputBuffer& output) {
  const GlbParts& parts = document_.parts;
  std::string json = json_text();
  json.append((kChunkAlignment - json.size() % kChunkAlignment) % kChunkAlignment, ' ');
  std::vector<uint8_t> bin(parts.bin.begin(), parts.bin.end());
  if (edited_.contains(0) && document_.buffers[0].home == GltfBuffer::Home::kChunk) {
    const std::vector<uint8_t>& bytes = edited_.at(0);
    const size_t padded = (bytes.size() + kChunkAlignment - 1) / kChunkAlignment * kChunkAlignment;
    bin.resize(std::max(bin.size(), padded));
    std::ranges::copy(bytes, bin.begin());
  }
  const uint64_t bytes = kGlbHeaderBytes + kGlbChunkHeaderBytes + json.size() +
                         (parts.has_bin ? kGlbChunkHeaderBytes + bin.size() : 0) +
                         parts.rest.size();
  if (bytes > UINT32_MAX)
    return invalid_argument("a GLB file of " + std::to_string(bytes) + " bytes: the limit is " +
                            std::to_string(UINT32_MAX));
  const auto put_word = [&](uint64_t word) { output.put_bytes(static_cast<uint32_t>(word)); };
  for (const uint64_t word : {uint64_t{kGlbMagic}, uint64_t{2}, bytes - parts.bytes_behind,
                              uint64_t{json.size()}, uint64_t{kGlbJsonChunk}})
    put_word(word);
  output.put_text(json);
  if (parts.has_bin) {
    put_word(bin.size());
    put_word(kGlbBinChunk);
    output.put_text(text_of_bytes(bin));
  }
  output.put_text(text_of_bytes(parts.rest));
  return Status::ok();
}

}  // namespace burnish
