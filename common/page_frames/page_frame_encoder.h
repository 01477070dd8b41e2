#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/page_frames/page_frame_header.h"
#include "common/page_frames/page_frame_state.h"
#include "common/page_frames/sent_page_frames.h"

namespace burnish {

/// The wanted values of one shown page.
struct WantedPage {
  std::span<const int32_t> steps;  ///< a PageSample's: all x, then all y, then all z, in 1/256 cell
  uint8_t gain = 0;                ///< 2^gain is at least the largest beta in the page's cells
  HeldVertices held = {};          ///< needs a client that knows of them
};

/// The pages that a client should show.
struct PageMoment {
  const ShownPages& shown;
  std::span<const WantedPage> pages;  ///< one per shown page, in the order of their numbers
  float largest_move = 0;             ///< of the whole surface, cells
};

/// How finely a frame may round: to 2^shift steps of 1/256 cell. The finest shift whose body has at
/// most `bytes_max` before compression is taken, else the coarsest one. A body that has values of
/// at most a quarter of the pages may be larger: a coarser shift would send all pages.
struct StepChoice {
  int finest = 0;
  int coarsest = 0;
  size_t bytes_max = SIZE_MAX;
};

/// The still surface: exactly the sampled displacement.
inline constexpr StepChoice kStillSteps = {};
/// The moving surface: 1/64 cell, on a slow link up to 1/4 cell. After a still frame all pages are
/// sent, since all are rounded anew; so an edit that touches few pages, a dab, begins better with
/// `finest` 0.
constexpr StepChoice moving_steps(size_t bytes_max) {
  return {2, 6, bytes_max};
}

struct EncodedPageFrame {
  uint64_t sequence = 0;
  uint64_t reference = 0;   ///< 0: a key frame
  uint32_t sent_pages = 0;  ///< 0: the reference already has all these values
  uint32_t sent_gains = 0;  ///< 0: the reference already has all these gains
  uint32_t sent_held = 0;   ///< 0: the reference already holds these vertices
  int step_shift = 0;
  std::vector<uint8_t> bytes;
};

/// Makes the frames of one client: each is the difference to the newest frame that this client has
/// acknowledged, or a key frame when there is none. Not thread-safe.
class PageFrameEncoder {
 public:
  /// An encoder that replaces another in the middle of a stream goes on with its numbers.
  explicit PageFrameEncoder(PageFrameKind kind, uint64_t first_sequence = 1)
      : kind_(kind), next_sequence_(first_sequence) {}

  PageFrameKind kind() const { return kind_; }
  uint64_t next_sequence() const { return next_sequence_; }

  /// Encodes the next frame. It is complete: the client then has the wanted values of all shown
  /// pages, rounded to the frame's step. Needs: a revision that is not below the last frame's;
  /// steps within kDisplacementCellsMax; 0 <= finest <= coarsest <= kPageStepShiftMax.
  EncodedPageFrame encode(const PageMoment& moment, const StepChoice& steps);

  /// Notes that the client holds this frame. Ignores unknown and forgotten frames.
  void acknowledge(uint64_t sequence) { sent_.acknowledge(sequence); }

  /// Notes that the client could not decode this frame because it lacks the reference. The next
  /// frame refers to an older acknowledged frame, or is a key frame.
  void refuse(uint64_t sequence) { sent_.refuse(sequence); }

  /// Notes that the client holds nothing: the next frame is a key frame.
  void request_key_frame() { sent_.clear(); }

  /// Returns the client's state after this frame; null if it is forgotten.
  const PageFrameState* sent_state(uint64_t sequence) const;

  /// Returns the bytes of remembered frames.
  uint64_t byte_count() const { return sent_.byte_count(); }

  /// Returns the limit of byte_count() for these pages while displacements are below 128 cells.
  static uint64_t byte_count_max(std::span<const ShownPage> pages);

 private:
  struct Draft;
  Draft draft(const PageMoment& moment, int step_shift, size_t bytes_max) const;
  PageFrameHeader next_header(const PageMoment& moment, const Draft& made);

  PageFrameKind kind_;
  SentPageFrames sent_;
  uint64_t next_sequence_;
  uint32_t revision_ = 0;  // of the last frame
};

}  // namespace burnish
