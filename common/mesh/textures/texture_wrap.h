#pragma once

namespace burnish {

/// Says how a texture goes on beyond its borders.
enum class TextureWrap { kRepeat, kMirror, kClamp };

/// The wrap along each coordinate.
struct TextureWraps {
  TextureWrap u = TextureWrap::kRepeat;
  TextureWrap v = TextureWrap::kRepeat;
};

}  // namespace burnish
