#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <jpeglib.h>
#include <span>

#include "common/picture/picture_rows.h"

namespace burnish {

/// Private to this folder: the state of one decoding. libjpeg leaves by longjmp, so no frame
/// between has a destructor.
struct JpegDecoding {
  explicit JpegDecoding(const PictureTaker& hears);
  ~JpegDecoding() { jpeg_destroy_decompress(&jpeg); }
  JpegDecoding(const JpegDecoding&) = delete;
  JpegDecoding& operator=(const JpegDecoding&) = delete;

  /// Asks the taker, and counts scans: a small file may ask for thousands. Leaves by longjmp if the
  /// reading ends.
  void check();
  Status failure() const;

  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX] = "";
  bool is_cut = false;
  const PictureTaker& taker;
  bool is_cancelled = false;
};

/// Returns false where libjpeg failed; failure() then says why. `keeps_markers`: the decoder keeps
/// comments and what programs have added.
bool read_jpeg_header(JpegDecoding& decoding, std::span<const uint8_t> bytes,
                      bool keeps_markers = false);

/// Returns the memory of all coefficients of a picture.
uint64_t jpeg_coefficient_bytes(const jpeg_decompress_struct& jpeg);

/// Returns the memory of a decoder that keeps none.
uint64_t jpeg_row_bytes(const jpeg_decompress_struct& jpeg);

}  // namespace burnish
