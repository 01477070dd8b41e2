#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace burnish {

/// A reader of data from a user, a file or a peer, for any bytes. Ends the program when the reader
/// breaks a promise. Returns whether the bytes were accepted.
struct FuzzedReader {
  std::string_view name;  ///< its corpus is tests/fuzz/corpus/NAME
  bool (*read)(std::span<const uint8_t> bytes);
};

/// Returns all except those of mesh files and frames, which have their own programs.
std::span<const FuzzedReader> fuzzed_readers();

/// Needs: a name in fuzzed_readers().
const FuzzedReader& fuzzed_reader(std::string_view name);

/// Reads messages of clients of a live session. Each is two bytes of length, low first, and then
/// that many bytes of a burnish.v1.ClientMessage. They go through the wire's checks to the fields
/// of a small scan, edits and gestures alike.
bool read_live_messages(std::span<const uint8_t> bytes);

/// Reads one message of the server in a live session: the bytes of a burnish.v1.ServerMessage.
bool read_server_message(std::span<const uint8_t> bytes);

/// One encoded page. It is compressed and its checksum is made right before it is decoded.
bool read_fuzzed_page(std::span<const uint8_t> bytes);

/// One block of a directory of three, two and one pages, likewise.
bool read_page_block(std::span<const uint8_t> bytes);

/// A page file, with the checksums of its head and blocks made right.
bool read_page_file(std::span<const uint8_t> bytes);

/// The charts of a page of eight triangles. They are compressed and their checksum is made right
/// before they are decoded.
bool read_fuzzed_charts(std::span<const uint8_t> bytes);

/// One encoded sheet, with its checksum made right.
bool read_fuzzed_sheet(std::span<const uint8_t> bytes);

/// One block of the directory of a sheet file, compressed first, with its checksum made right.
bool read_sheet_block(std::span<const uint8_t> bytes);

/// A sheet file of six pages, with the checksums of its head and blocks made right.
bool read_sheet_file(std::span<const uint8_t> bytes);

/// The hierarchy file of a sliver, with the checksums of its header and sections made right.
bool read_fuzzed_hierarchy(std::span<const uint8_t> bytes);

/// Frames by page for one decoder, and the changes of its shown pages. Each begins with a byte for
/// its kind and two bytes of length, low first:
///   0  a frame, unchanged;
///   1  a frame whose header is sealed again, so that its checksum is right;
///   2  a frame whose body is compressed first, then sealed;
///   3  a change: each byte is a page to add, or to remove if its highest bit is set.
/// A refused frame must not change the decoder's state.
bool read_page_frames(std::span<const uint8_t> bytes);

/// Frames of a client of the web gateway. Each begins with a byte for its kind and two bytes of
/// length, low first:
///   0  a text frame;
///   1  a binary frame;
///   2  a binary frame of 1024 times that length, without bytes;
///   3  the call's end, if one runs, without bytes.
bool read_web_frames(std::span<const uint8_t> bytes);

/// The headers Host and Origin of a request to the web gateway, a line each.
bool read_web_request(std::span<const uint8_t> bytes);

}  // namespace burnish
