#include "client/scene/picture_mark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace burnish {

namespace {

constexpr int kLetterColumns = 5, kLetterRows = 8;  // of a letter, in dots
constexpr int kMarkMargin = 3;                      // around the words
constexpr int kBarRows = 4;                         // of a scale bar's ends; its line has one
constexpr int kDotRows = 350;                       // rows of a picture whose dots are a pixel
constexpr std::array<uint8_t, 3> kInk = {230, 232, 235}, kPaper = {31, 33, 36};

/// The dots of a letter: a byte for each column, whose lowest bit is above.
using Letter = std::array<uint8_t, kLetterColumns>;

constexpr char kMicro = 1;  // stands for "µ", which has two bytes
constexpr std::string_view kLetterNames =
    " %,.+-/?'\"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ\1";
constexpr std::array<Letter, kLetterNames.size()> kLetters = {{
    {0x00, 0x00, 0x00, 0x00, 0x00}, {0x23, 0x13, 0x08, 0x64, 0x62}, {0x00, 0xa0, 0x60, 0x00, 0x00},
    {0x00, 0x60, 0x60, 0x00, 0x00}, {0x08, 0x08, 0x3e, 0x08, 0x08}, {0x08, 0x08, 0x08, 0x08, 0x08},
    {0x60, 0x10, 0x08, 0x04, 0x03}, {0x02, 0x01, 0x51, 0x09, 0x06}, {0x00, 0x05, 0x03, 0x00, 0x00},
    {0x00, 0x07, 0x00, 0x07, 0x00}, {0x3e, 0x51, 0x49, 0x45, 0x3e}, {0x00, 0x42, 0x7f, 0x40, 0x00},
    {0x42, 0x61, 0x51, 0x49, 0x46}, {0x21, 0x41, 0x45, 0x4b, 0x31}, {0x18, 0x14, 0x12, 0x7f, 0x10},
    {0x27, 0x45, 0x45, 0x45, 0x39}, {0x3c, 0x4a, 0x49, 0x49, 0x30}, {0x01, 0x71, 0x09, 0x05, 0x03},
    {0x36, 0x49, 0x49, 0x49, 0x36}, {0x06, 0x49, 0x49, 0x29, 0x1e}, {0x20, 0x54, 0x54, 0x54, 0x78},
    {0x7f, 0x48, 0x44, 0x44, 0x38}, {0x38, 0x44, 0x44, 0x44, 0x28}, {0x38, 0x44, 0x44, 0x48, 0x7f},
    {0x38, 0x54, 0x54, 0x54, 0x18}, {0x08, 0x7e, 0x09, 0x01, 0x02}, {0x18, 0xa4, 0xa4, 0xa4, 0x7c},
    {0x7f, 0x08, 0x04, 0x04, 0x78}, {0x00, 0x44, 0x7d, 0x40, 0x00}, {0x40, 0x80, 0x84, 0x7d, 0x00},
    {0x7f, 0x10, 0x28, 0x44, 0x00}, {0x00, 0x41, 0x7f, 0x40, 0x00}, {0x7c, 0x04, 0x18, 0x04, 0x78},
    {0x7c, 0x08, 0x04, 0x04, 0x78}, {0x38, 0x44, 0x44, 0x44, 0x38}, {0xfc, 0x24, 0x24, 0x24, 0x18},
    {0x18, 0x24, 0x24, 0x24, 0xfc}, {0x7c, 0x08, 0x04, 0x04, 0x08}, {0x48, 0x54, 0x54, 0x54, 0x20},
    {0x04, 0x3f, 0x44, 0x40, 0x20}, {0x3c, 0x40, 0x40, 0x20, 0x7c}, {0x1c, 0x20, 0x40, 0x20, 0x1c},
    {0x3c, 0x40, 0x30, 0x40, 0x3c}, {0x44, 0x28, 0x10, 0x28, 0x44}, {0x1c, 0xa0, 0xa0, 0xa0, 0x7c},
    {0x44, 0x64, 0x54, 0x4c, 0x44}, {0x7e, 0x11, 0x11, 0x11, 0x7e}, {0x7f, 0x49, 0x49, 0x49, 0x36},
    {0x3e, 0x41, 0x41, 0x41, 0x22}, {0x7f, 0x41, 0x41, 0x22, 0x1c}, {0x7f, 0x49, 0x49, 0x49, 0x41},
    {0x7f, 0x09, 0x09, 0x09, 0x01}, {0x3e, 0x41, 0x41, 0x51, 0x32}, {0x7f, 0x08, 0x08, 0x08, 0x7f},
    {0x00, 0x41, 0x7f, 0x41, 0x00}, {0x20, 0x40, 0x41, 0x3f, 0x01}, {0x7f, 0x08, 0x14, 0x22, 0x41},
    {0x7f, 0x40, 0x40, 0x40, 0x40}, {0x7f, 0x02, 0x04, 0x02, 0x7f}, {0x7f, 0x04, 0x08, 0x10, 0x7f},
    {0x3e, 0x41, 0x41, 0x41, 0x3e}, {0x7f, 0x09, 0x09, 0x09, 0x06}, {0x3e, 0x41, 0x51, 0x21, 0x5e},
    {0x7f, 0x09, 0x19, 0x29, 0x46}, {0x46, 0x49, 0x49, 0x49, 0x31}, {0x01, 0x01, 0x7f, 0x01, 0x01},
    {0x3f, 0x40, 0x40, 0x40, 0x3f}, {0x1f, 0x20, 0x40, 0x20, 0x1f}, {0x7f, 0x20, 0x18, 0x20, 0x7f},
    {0x63, 0x14, 0x08, 0x14, 0x63}, {0x03, 0x04, 0x78, 0x04, 0x03}, {0x61, 0x51, 0x49, 0x45, 0x43},
    {0xfc, 0x40, 0x40, 0x20, 0x7c},
}};

/// Returns whether words have ink in a dot, counted from their upper left corner.
bool has_ink(std::string_view words, int column, int row) {
  if (column < 0 || row < 0 || row >= kLetterRows) return false;
  const size_t number = static_cast<size_t>(column) / (kLetterColumns + 1);
  const int within = column % (kLetterColumns + 1);
  if (number >= words.size() || within == kLetterColumns) return false;
  const size_t letter = kLetterNames.find(words[number]);
  return letter != std::string_view::npos && (kLetters[letter][within] >> row & 1) != 0;
}

/// Returns one byte for each letter: UTF-8 has several for those beyond ASCII.
std::string letters_of(const std::string& words) {
  std::string letters;
  for (size_t i = 0; i < words.size(); ++i) {
    const auto byte = static_cast<unsigned char>(words[i]);
    if ((byte & 0xc0) == 0x80) continue;  // goes on with a letter
    const std::string_view rest = std::string_view(words).substr(i);
    const bool is_micro = rest.starts_with("\u00b5") || rest.starts_with("\u03bc");
    const bool has_shape = kLetterNames.find(words[i]) != std::string_view::npos;
    letters += is_micro ? kMicro : has_shape ? words[i] : '?';
  }
  return letters;
}

int columns_of(const std::string& letters) {
  return static_cast<int>(letters.size()) * (kLetterColumns + 1) - 1;
}

/// A part of a picture, in pixels.
struct Part {
  int left, top, right, bottom;
};

/// Ink of a part, in pixels from the part's corner.
struct PartInk {
  std::string letters;
  int dot;            // pixels of one
  int text_from;      // the left edge of the letters
  int bar_from = 0;   // of the bar below the letters
  int bar_width = 0;  // 0: there is none

  bool is_at(int x, int y) const {
    const int row = y / dot - kMarkMargin;
    if (x >= text_from && has_ink(letters, (x - text_from) / dot, row)) return true;
    const int bar_row = row - kLetterRows - 1, at = x - bar_from;
    if (bar_row < 0 || bar_row >= kBarRows || at < 0 || at >= bar_width) return false;
    return bar_row == kBarRows - 1 || at < dot || at >= bar_width - dot;
  }
};

void paint_part(Image& image, const Part& part, const PartInk& ink) {
  const auto [width, height] = image.size;
  for (int y = std::max(part.top, 0); y < std::min(part.bottom, height); ++y)
    for (int x = std::max(part.left, 0); x < std::min(part.right, width); ++x) {
      const auto& colour = ink.is_at(x - part.left, y - part.top) ? kInk : kPaper;
      std::copy(colour.begin(), colour.end(),
                image.rgb.begin() + 3 * (static_cast<ptrdiff_t>(y) * width + x));
    }
}

/// Returns how many pixels a dot of a mark has.
int mark_dot(const ImageSize& size, int columns) {
  return std::max(std::min(size.height / kDotRows, size.width / columns), 1);
}

/// Returns the place of a mark.
Part mark_place(const ImageSize& size, const std::string& words) {
  const int columns = columns_of(words) + 2 * kMarkMargin, dot = mark_dot(size, columns);
  return {0, size.height - (kLetterRows + 2 * kMarkMargin) * dot, columns * dot, size.height};
}

}  // namespace

void mark_picture(Image& image, const std::string& words) {
  image.note = words;
  const int dot = mark_dot(image.size, columns_of(words) + 2 * kMarkMargin);
  paint_part(image, mark_place(image.size, words), {words, dot, kMarkMargin * dot});
}

void draw_scale_bar(Image& image, const ScaleBar& bar, const std::string& words) {
  const auto [width, height] = image.size;
  const std::string letters = letters_of(words);
  const int columns = columns_of(letters);
  const int of_screen = static_cast<int>(2 * bar.pixel_ratio);
  const int dot = std::max(std::min(of_screen, width / (columns + 2 * kMarkMargin)), 1);
  const int length = static_cast<int>(std::lround(bar.pixels)), margin = kMarkMargin * dot;
  const int wide = std::max(columns * dot, length), left = width - wide - 2 * margin;
  const Part note = mark_place(image.size, image.note);
  const int bottom = !image.note.empty() && note.right > left ? note.top : height;
  const int top = bottom - (kLetterRows + 1 + kBarRows) * dot - 2 * margin;
  paint_part(
      image, {left, top, width, bottom},
      {letters, dot, margin + (wide - columns * dot) / 2, margin + (wide - length) / 2, length});
}

}  // namespace burnish
