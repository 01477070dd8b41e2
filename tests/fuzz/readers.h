#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace burnish {

/// Something that reads what a user, a file or a peer has made, fed with any bytes. Ends the
/// program when the reader breaks a promise. Returns whether the bytes were taken.
struct FuzzedReader {
  std::string_view name;  ///< of its corpus too: tests/fuzz/corpus/NAME
  bool (*read)(std::span<const uint8_t> bytes);
};

/// All but those of mesh files and frames, which have programs of their own.
std::span<const FuzzedReader> fuzzed_readers();

/// Needs: a name of the above.
const FuzzedReader& fuzzed_reader(std::string_view name);

/// Messages of a live session as clients send them: each two bytes of length, low first, and then
/// so many bytes of a burnish.v1.ClientMessage. They go through the wire's checks to the fields of
/// a small scan, edits and gestures alike.
bool read_live_messages(std::span<const uint8_t> bytes);

/// One message of a live session as the server sends it: the bytes of a burnish.v1.ServerMessage.
bool read_server_message(std::span<const uint8_t> bytes);

/// Frames by page for one decoder, and the changes of its shown pages. Each begins with a byte for
/// its kind and two bytes of length, low first:
///   0  a frame, unchanged;
///   1  a frame whose header is sealed again, so that its checksum is right;
///   2  a frame whose body is compressed first, then sealed;
///   3  a change: each byte is a page to add, or to remove if its highest bit is set.
/// A refused frame must not change the decoder's state.
bool read_page_frames(std::span<const uint8_t> bytes);

}  // namespace burnish
