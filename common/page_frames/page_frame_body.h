#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/packing/group_packing.h"
#include "common/page_frames/held_vertices.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

/// Collects what one frame sends. Pages are named by their place among the shown ones, and come in
/// rising order.
class PageFrameBodyWriter {
 public:
  explicit PageFrameBodyWriter(size_t pages) : flags_(pages, 0) {}

  void add_gain(size_t page, uint8_t gain);
  /// Shapes: a bit for each of `vertices`. Null: none is held any more.
  void add_held(size_t page, const HeldVertices& held, size_t vertices);
  /// Shapes: all x, then all y, then all z.
  void add_values(size_t page, std::span<const uint32_t> residuals);

  uint32_t sent_pages() const { return sent_pages_; }
  uint32_t sent_gains() const { return static_cast<uint32_t>(gains_.size()); }
  uint32_t sent_held() const { return sent_held_; }
  size_t byte_count() const;  ///< of bytes()
  std::vector<uint8_t> bytes() const;

 private:
  std::vector<uint8_t> flags_;
  std::vector<uint8_t> gains_;
  std::vector<uint8_t> held_;
  uint32_t sent_pages_ = 0;
  uint32_t sent_held_ = 0;
  GroupPacker groups_;
};

/// Reads it back in rising order. Keeps spans of the bytes given to open().
class PageFrameBodyReader {
 public:
  /// Fails: data_loss if the bytes are not a body for these pages that sends `sent_pages` of them.
  static Result<PageFrameBodyReader> open(std::span<const ShownPage> pages, uint32_t sent_pages,
                                          std::span<const uint8_t> bytes);

  bool has_gain(size_t page) const;
  bool has_held(size_t page) const;
  bool has_values(size_t page) const;
  /// Needs, as the next two: one call for each page that has one, in rising order.
  uint8_t read_gain();
  HeldVertices read_held(size_t vertices);
  /// Needs: one call for each page that has values, in rising order, with 3 × its values.
  void read_values(std::span<uint32_t> residuals);

 private:
  PageFrameBodyReader() = default;
  Status check_held(std::span<const ShownPage> pages) const;

  std::span<const uint8_t> flags_;
  std::span<const uint8_t> gains_;
  std::span<const uint8_t> held_;
  GroupUnpacker groups_;
};

/// Returns the largest size in bytes of a body for these pages.
uint64_t page_body_bytes_max(std::span<const ShownPage> pages);

}  // namespace burnish
