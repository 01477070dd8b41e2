#include "common/service/kept_name.h"

#include <algorithm>
#include <cctype>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/service/scan_info.h"

namespace burnish {

namespace {

constexpr size_t kIdDigits = 64;

bool is_blank(char32_t c) {
  return c == U' ' || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f ||
         c == 0x205f || c == 0x3000;
}

/// Characters without a picture, that change nothing beside them.
bool is_unseen(char32_t c) {
  return c == 0xad || c == 0x115f || c == 0x1160 || c == 0x180e || c == 0x200b ||
         (c >= 0x2060 && c <= 0x2064) || c == 0x3164 || c == 0xfeff || c == 0xffa0 ||
         (c >= 0xe0000 && c <= 0xe007f);
}

/// Joiners and selectors change how their neighbours look in some scripts.
bool joins(char32_t c) {
  return c == 0x200c || c == 0x200d || (c >= 0xfe00 && c <= 0xfe0f);
}

std::u32string characters_of(std::string_view name) {
  std::u32string characters;
  while (!name.empty()) characters += take_character(name).value_or(U'?');
  return characters;
}

char32_t lower(char32_t c) {
  if (c >= 0xff01 && c <= 0xff5e) c -= 0xff01 - 0x21;  // wide letters, then their case
  const bool is_capital = (c >= U'A' && c <= U'Z') || (c >= 0xc0 && c <= 0xde && c != 0xd7) ||
                          (c >= 0x391 && c <= 0x3a9) || (c >= 0x410 && c <= 0x42f);
  if (is_capital) return c + 0x20;
  if (c >= 0x400 && c <= 0x40f) return c + 0x50;
  const bool is_pair = (c >= 0x100 && c <= 0x137) || (c >= 0x14a && c <= 0x177) ||
                       (c >= 0x460 && c <= 0x481) || (c >= 0x48a && c <= 0x4bf);
  return is_pair ? c | 1 : c;
}

void append(std::string& text, char32_t c) {
  const auto put = [&](char32_t bits) { text += static_cast<char>(bits); };
  if (c < 0x80) return put(c);
  if (c < 0x800) return put(0xc0 | c >> 6), put(0x80 | (c & 0x3f));
  if (c < 0x10000) {
    put(0xe0 | c >> 12);
  } else {
    put(0xf0 | c >> 18);
    put(0x80 | (c >> 12 & 0x3f));
  }
  put(0x80 | (c >> 6 & 0x3f));
  put(0x80 | (c & 0x3f));
}

std::string as_text(std::u32string_view characters) {
  std::string text;
  for (const char32_t c : characters) append(text, c);
  return text;
}

bool is_without_picture(char32_t c) {
  return is_blank(c) || joins(c);
}

/// Returns the name as check_kept_name() wants it; perhaps nothing.
std::u32string trimmed(std::string_view name) {
  std::u32string characters = characters_of(name);
  std::erase_if(characters, [](char32_t c) { return is_unseen(c) || is_control(c); });
  while (!characters.empty() && is_blank(characters.back())) characters.pop_back();
  const auto begin = std::ranges::find_if_not(characters, is_blank);
  return {begin, characters.end()};
}

}  // namespace

Status check_kept_name(std::string_view what, std::string_view name) {
  RETURN_IF_ERROR(check_name(what, name));
  const std::u32string characters = characters_of(name);
  const std::string subject(what);
  if (is_blank(characters.front()) || is_blank(characters.back()))
    return invalid_argument(subject + " '" + std::string(name) +
                            "' begins or ends with a blank; choose one without");
  if (std::ranges::any_of(characters, is_unseen))
    return invalid_argument(subject + " has a character that nobody sees; choose one without");
  if (std::ranges::all_of(characters, is_without_picture))
    return invalid_argument(subject + " has no character that can be seen");
  return Status::ok();
}

static bool could_begin_an_id(std::string_view name) {
  const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  return name.size() >= kIdBeginDigits && name.size() <= kIdDigits &&
         std::ranges::all_of(name, is_digit);
}

Status check_scan_name(std::string_view name) {
  RETURN_IF_ERROR(check_kept_name("the scan's name", name));
  if (!could_begin_an_id(name)) return Status::ok();
  return invalid_argument("the scan's name '" + std::string(name) +
                          "' could be the beginning of an id: " + std::to_string(kIdBeginDigits) +
                          " to " + std::to_string(kIdDigits) +
                          " hexadecimal digits; choose another");
}

std::string look_of_name(std::string_view name) {
  std::u32string look;
  for (const char32_t c : characters_of(name)) {
    if (is_unseen(c) || joins(c)) continue;
    look += is_blank(c) ? U' ' : lower(c);
  }
  return as_text(look);
}

std::string numbered_scan_name(std::string_view name, int number) {
  std::u32string characters = trimmed(name);
  if (std::ranges::all_of(characters, is_without_picture)) characters = U"scan";
  const bool is_plain = number == 1 && !could_begin_an_id(as_text(characters)) &&
                        as_text(characters).size() <= kNameBytesMax;
  if (is_plain) return as_text(characters);
  const std::string suffix = " (" + std::to_string(number) + ")";
  while (as_text(characters).size() + suffix.size() > kNameBytesMax) characters.pop_back();
  return as_text(characters) + suffix;
}

}  // namespace burnish
