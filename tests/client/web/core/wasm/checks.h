#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace burnish {

/// Reads bytes as the client does, and returns what it made of them in a few words: a fingerprint
/// of all values, or the message of the failure. The same in the program and in core.wasm.
///
/// | kind | bytes |
/// |---|---|
/// | page | an encoded page |
/// | head | an encoded head of pages |
/// | frames | bits, depth, kind of frames; pages; frames: each list a count, and sizes before bytes
/// | | message | a v1::ServerMessage | | hash | any | | number | a text |
std::string answer_of(std::string_view kind, std::span<const uint8_t> bytes);

}  // namespace burnish
