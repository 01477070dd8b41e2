#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/live/page_frame_reader.h"
#include "client/live/surface_frame.h"
#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/service/live.h"

namespace burnish {

/// The pages and the session that frames are of.
struct FrameSource {
  PageHead head;
  int depth = 0;                   ///< of the session
  uint64_t pages_fingerprint = 0;  ///< of the pages that are here; 0: not checked
};

/// Turns the frames of one live session, over any number of streams, into surfaces, and keeps what
/// is to be answered about them. Not thread-safe.
class FrameReceiver {
 public:
  explicit FrameReceiver(const FrameSource& source);

  /// A stream begins: it shows no page.
  void restart();
  /// Fails: failed_precondition when the stream is of other pages, or of a session of another
  /// depth.
  Status welcome(const Welcome& welcome) const;
  /// A change that the server is about to hear. Needs: `added` has the pages of the change.
  /// Fails: as PageFrameDecoder::show().
  Status show(const ShowPages& change, const std::vector<std::shared_ptr<const Page>>& added);

  /// Returns where the surface is now. Returns null if it has not moved, or if the frame could not
  /// be decoded: then the server is asked for a better one.
  /// Fails: unimplemented, invalid_argument (no frame of this session will ever do).
  Result<std::shared_ptr<const SurfaceFrame>> receive(const std::string& data);

  /// Returns the revision of the shown pages that the stream's newest frame has.
  uint32_t shown_revision() const { return reader_.shown_revision(); }

  /// Returns what the server has to know about the frames since the last call.
  FrameCredit take_answers();
  bool has_answers() const;

 private:
  Result<DecodedPageFrame> decode(std::span<const uint8_t> bytes);
  std::shared_ptr<const SurfaceFrame> surface_of(const DecodedPageFrame& frame);

  const FrameSource source_;
  PageFrameReader reader_;
  std::shared_ptr<const SurfaceFrame> surface_ = std::make_shared<const SurfaceFrame>();
  FrameCredit answers_;
};

}  // namespace burnish
