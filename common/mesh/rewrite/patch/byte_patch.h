#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "common/mesh/output_buffer.h"

namespace burnish {

/// Copies a file with some of its pieces replaced.
class BytePatch {
 public:
  /// Needs: `original` and `output` outlive the patch.
  BytePatch(std::span<const uint8_t> original, OutputBuffer& output);

  /// Copies the bytes before `piece`, and writes `text` in its place. Needs: `piece` lies in the
  /// original, behind the pieces replaced so far.
  void replace(std::string_view piece, std::string_view text);

  /// Copies what follows the last piece. Call last.
  void finish();

 private:
  std::string_view rest_;  // not copied yet
  OutputBuffer& output_;
};

}  // namespace burnish
