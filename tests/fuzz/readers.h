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

/// One encoded page. It is compressed and its checksum is made right before it is decoded.
bool read_fuzzed_page(std::span<const uint8_t> bytes);

/// One block of a directory of three, two and one pages, likewise.
bool read_page_block(std::span<const uint8_t> bytes);

/// A page file, with the checksums of its head and blocks made right.
bool read_page_file(std::span<const uint8_t> bytes);

}  // namespace burnish
