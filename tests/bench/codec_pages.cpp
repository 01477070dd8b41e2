#include "tests/bench/codec_pages.h"

#include <filesystem>
#include <unistd.h>

#include "common/page_frames/page_frame_decoder.h"
#include "common/page_frames/page_frame_encoder.h"
#include "common/page_frames/page_sample.h"
#include "common/pages/page_file.h"
#include "server/prepare/pages/build_pages.h"
#include "tests/bench/timing.h"

namespace burnish {

namespace {

constexpr int kLevelStride = 2;
constexpr int kRepeats = 7;

PageLevel read_level(const PageFile& file, int level) {
  const PageHead& head = file.directory().head;
  PageLevel read{level, head.grid.bits, {}};
  for (PageId page = head.level_begin(level); page < head.level_begin(level + 1); ++page)
    read.pages.push_back(file.read_page(page).value());
  return read;
}

/// One client that shows all pages of a level.
class PageClient {
 public:
  PageClient(const PageLevel& level, const SparseGrid& grid, PageFrameKind kind)
      : grid_(grid), encoder_(kind), decoder_(kind) {
    PageChange change{.revision = 1};
    for (const Page& page : level.pages) {
      evaluations_.push_back(std::make_shared<const PageEvaluation>(
          make_page_evaluation(page, level.bits, grid, kind)));
      change.added.push_back(evaluations_.back()->shown);
      values_ += evaluations_.back()->points.size();
    }
    BURNISH_CHECK(decoder_.show(change, kPagesMax).is_ok(), "too many pages");
    shown_ = shown_.changed(change);
  }

  uint64_t values() const { return values_; }

  void sample(std::span<const Vec3f> displacement) {
    samples_ = sample_pages(grid_, evaluations_, displacement).value();
  }
  EncodedPageFrame encode(int step_shift) {
    std::vector<WantedPage> wanted;
    for (const PageSample& sample : samples_) wanted.push_back({.steps = sample.steps});
    return encoder_.encode({shown_, wanted}, {.finest = step_shift, .coarsest = step_shift});
  }
  void decode(const EncodedPageFrame& frame) {
    PageFrameDecoder decoder = decoder_;
    BURNISH_CHECK(decoder.decode(frame.bytes).is_ok(), "our own frame");
    decoded_ = std::move(decoder);
  }
  void take(const EncodedPageFrame& frame) {
    decode(frame);
    decoder_ = decoded_;
    encoder_.acknowledge(frame.sequence);
  }

 private:
  const SparseGrid& grid_;
  std::vector<std::shared_ptr<const PageEvaluation>> evaluations_;
  std::vector<PageSample> samples_;
  uint64_t values_ = 0;
  ShownPages shown_;
  PageFrameEncoder encoder_;
  PageFrameDecoder decoder_;
  PageFrameDecoder decoded_ = decoder_;
};

}  // namespace

std::vector<PageLevel> build_page_levels(const PreparedMesh& prepared) {
  const auto path =
      std::filesystem::temp_directory_path() / ("burnish-codec-bench-" + std::to_string(getpid()));
  const Status built = build_pages(
      {prepared.vertices, prepared.triangles, prepared.colours, prepared.statistics}, path);
  BURNISH_CHECK(built.is_ok(), built.message());
  const PageFile file = PageFile::open(path).value();
  std::filesystem::remove(path);  // the mapping stays
  std::vector<PageLevel> levels;
  for (int level = 0; level < file.directory().head.level_count(); level += kLevelStride)
    levels.push_back(read_level(file, level));
  return levels;
}

PageFrameCost page_frame_cost(const PageLevel& level, const SparseGrid& grid, PageFrameKind kind,
                              int step_shift, std::span<const Vec3f> before,
                              std::span<const Vec3f> after) {
  PageClient client(level, grid, kind);
  PageFrameCost cost{.kind = kind, .step_shift = step_shift, .values = client.values()};
  client.sample(before);
  const EncodedPageFrame key = client.encode(step_shift);
  cost.key_bytes = key.bytes.size();
  client.take(key);
  cost.sample_ms = median_milliseconds(kRepeats, 1, [&] { client.sample(after); });
  EncodedPageFrame change;
  cost.encode_ms = median_milliseconds(kRepeats, 1, [&] { change = client.encode(step_shift); });
  cost.change_bytes = change.bytes.size();
  cost.decode_ms = median_milliseconds(kRepeats, 1, [&] { client.decode(change); });
  return cost;
}

}  // namespace burnish
