// Writes what core.wasm is asked under Node, and what this program answers, to FOLDER/vectors:
// kind, bytes and answer of each question, each with its size before it (32 bits).
// Usage: write_vectors FOLDER

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "client/live/framed_page.h"
#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "common/packing/checksum.h"
#include "common/page_frames/page_frame_decoder.h"
#include "common/page_frames/page_frame_encoder.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_file.h"
#include "common/sheets/sheet_codec.h"
#include "server/prepare/pages/build_pages.h"
#include "tests/client/web/core/wasm/checks.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<uint8_t>;

class Vectors {
 public:
  explicit Vectors(const fs::path& folder) : out_(folder / "vectors", std::ios::binary) {}

  void add(const std::string& kind, std::span<const uint8_t> bytes) {
    put(kind);
    put({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    put(answer_of(kind, bytes));
  }
  /// Adds damaged copies too: a bit less, a bit changed.
  void add_with_damages(const std::string& kind, const Bytes& bytes) {
    add(kind, bytes);
    for (int i = 0; i < 12; ++i) {
      Bytes damaged = bytes;
      damaged[random_() % damaged.size()] ^= static_cast<uint8_t>(1 + random_() % 255);
      if (i % 3 == 0) damaged.resize(random_() % damaged.size());
      add(kind, damaged);
    }
  }
  void add_text(const std::string& kind, const std::string& text) {
    add(kind, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  }

 private:
  void put(std::string_view text) {
    const auto size = static_cast<uint32_t>(text.size());
    out_.write(reinterpret_cast<const char*>(&size), sizeof size);
    out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  }

  std::ofstream out_;
  std::mt19937 random_{7};
};

void append_number(uint32_t number, Bytes& bytes) {
  uint8_t raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.insert(bytes.end(), raw, raw + sizeof number);
}

void append_list(const std::vector<Bytes>& items, Bytes& bytes) {
  append_number(static_cast<uint32_t>(items.size()), bytes);
  for (const Bytes& item : items) {
    append_number(static_cast<uint32_t>(item.size()), bytes);
    bytes.insert(bytes.end(), item.begin(), item.end());
  }
}

/// Returns a few frames for pages, as a server encodes them.
std::vector<Bytes> frames_for(const ShownPages& shown, PageFrameKind kind) {
  PageFrameEncoder encoder(kind);
  std::vector<Bytes> frames;
  for (int moment = 0; moment < 4; ++moment) {
    std::vector<std::vector<int32_t>> steps;
    for (const ShownPage& page : shown.pages()) {
      auto& values = steps.emplace_back(3 * size_t{page.value_count()});
      for (size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<int32_t>((i * 7 + 31 * static_cast<size_t>(moment)) % 400) - 200;
    }
    std::vector<WantedPage> wanted;
    for (const auto& values : steps) wanted.push_back({.steps = values});
    const StepChoice choice = moment == 2 ? moving_steps(4000) : kStillSteps;
    auto frame = encoder.encode({shown, wanted, 2}, choice);
    encoder.acknowledge(frame.sequence);
    frames.push_back(std::move(frame.bytes));
  }
  return frames;
}

void add_frames(const std::vector<Bytes>& pages, const FrameTerms& terms, Vectors& vectors) {
  PageFrameDecoder decoder(terms.kind);
  PageChange change{.revision = 1};
  for (const Bytes& encoded : pages)
    change.added.push_back(
        frame_page(std::make_shared<const Page>(decode_page(encoded).value()), terms).shown);
  if (!decoder.show(change, kNoPage).is_ok()) std::abort();
  Bytes bytes;
  append_number(static_cast<uint32_t>(terms.kind), bytes);
  append_number(static_cast<uint32_t>(terms.bits), bytes);
  append_number(static_cast<uint32_t>(terms.depth), bytes);
  append_list(pages, bytes);
  append_list(frames_for(decoder.newest_shown(), terms.kind), bytes);
  vectors.add_with_damages("frames", bytes);
}

Status add_scan(const std::string& kind, const fs::path& folder, Vectors& vectors) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, generate_scan({.kind = kind, .vertices = 6000}));
  const MeshStatistics statistics = compute_statistics(mesh);
  const fs::path path = folder / (kind + ".pages");
  RETURN_IF_ERROR(build_pages({mesh.vertices, mesh.triangles, mesh.colours, statistics}, path));
  ASSIGN_OR_RETURN(const PageFile file, PageFile::open(path));
  const PageHead& head = file.directory().head;
  vectors.add_with_damages("head", {file.head_bytes().begin(), file.head_bytes().end()});
  std::vector<Bytes> pages;
  for (PageId page = 0; page < head.page_count(); ++page) {
    ASSIGN_OR_RETURN(Bytes bytes, file.read_page_bytes(page));
    vectors.add_with_damages("page", bytes);
    if (pages.size() < 3) pages.push_back(std::move(bytes));
  }
  for (const auto frames : {PageFrameKind::kVertices, PageFrameKind::kCorners})
    add_frames(pages, {frames, head.grid.bits, 6}, vectors);
  return Status::ok();
}

/// Returns a sheet of this size whose first texel has this alpha.
Result<Bytes> sheet_of(uint16_t width, uint8_t alpha) {
  Sheet sheet{.page = 7, .density = 2, .layout = {width, 17, {{0, 0}, {12, 3}}}, .texels = {}};
  for (size_t i = 0; i < sheet.layout.texels(); ++i)
    sheet.texels.push_back({static_cast<uint8_t>(5 * i), static_cast<uint8_t>(i / 3), 100, 255});
  sheet.texels[0][3] = alpha;
  return encode_sheet(sheet);
}

/// Seals a sheet whose header says another width than its texels have.
Bytes with_width(Bytes bytes, uint16_t width) {
  SheetHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.width = width;
  std::memcpy(bytes.data(), &header, sizeof header);
  header.checksum = sealed_checksum(bytes, offsetof(SheetHeader, checksum), sizeof header);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

// Sheets with and without alpha; texels that are wider than the sheet; a container that is not as
// wide as its frame; a frame that would take a gigabyte.
Status add_sheets(Vectors& vectors) {
  for (const uint8_t alpha : {uint8_t{255}, uint8_t{9}}) {
    ASSIGN_OR_RETURN(const Bytes bytes, sheet_of(24, alpha));
    vectors.add_with_damages("sheet", bytes);
    ASSIGN_OR_RETURN(const Bytes wider, sheet_of(25, alpha));
    vectors.add("sheet", with_width(wider, 24));
    Bytes narrowed = wider;
    const auto canvas = std::ranges::search(narrowed, std::string_view("VP8X")).begin();
    if (canvas != narrowed.end()) canvas[12] = 23;
    vectors.add("sheet", with_width(narrowed, 24));
    Bytes huge = bytes;
    constexpr std::array<uint8_t, 3> kStart = {0x9d, 0x01, 0x2a};  // of a frame, before its size
    const auto start = std::ranges::search(huge, kStart).begin();
    start[3] = 0xff;
    start[4] = 0x3f;
    vectors.add("sheet", with_width(huge, 24));
  }
  return Status::ok();
}

Status write_vectors(const fs::path& folder) {
  Vectors vectors(folder);
  for (const char* kind : {"tablet", "blob", "sheets", "fan", "soup", "part"})
    RETURN_IF_ERROR(add_scan(kind, folder, vectors).with_context(kind));
  RETURN_IF_ERROR(add_sheets(vectors));
  for (const auto& file :
       fs::directory_iterator(fs::path(SOURCE_ROOT) / "tests/fuzz/corpus/server_message")) {
    std::ifstream in(file.path(), std::ios::binary);
    vectors.add_with_damages("message", Bytes(std::istreambuf_iterator<char>(in), {}));
  }
  for (const size_t size : {0, 1, 55, 56, 63, 64, 65, 1000, 100'000})
    vectors.add_text("hash", std::string(size, 'x') + std::to_string(size));
  for (const char* text : {"1", "-0.1", "1e-310", "1e400", "3.", ".5", "+1", " 1", "0x10", "nan",
                           "inf", "1e", "", "-", "1.7976931348623157e308", "123456789.125e-3"})
    vectors.add_text("number", text);
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_vectors FOLDER\n";
    return 2;
  }
  const burnish::Status written = burnish::write_vectors(argv[1]);
  if (written.is_ok()) return 0;
  std::cerr << "write_vectors: " << written.message() << "\n";
  return 1;
}
