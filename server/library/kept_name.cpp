#include "server/library/kept_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <memory>

#include <utf8proc.h>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/service/scan_info.h"

namespace burnish {

namespace {

constexpr size_t kIdDigits = 64;

bool is_blank(char32_t c) {
  return utf8proc_category(static_cast<int32_t>(c)) == UTF8PROC_CATEGORY_ZS;
}

/// Returns whether Unicode says that nothing shows the character, also where it has no meaning yet.
bool is_ignorable(char32_t c) {
  const bool is_tag = c >= 0xe0000 && c <= 0xe007f;
  return is_tag || utf8proc_get_property(static_cast<int32_t>(c))->ignorable;
}

/// Joiners and selectors change how their neighbours look in some scripts.
bool joins(char32_t c) {
  const bool is_mark = utf8proc_category(static_cast<int32_t>(c)) == UTF8PROC_CATEGORY_MN;
  return is_ignorable(c) && (is_mark || c == 0x200c || c == 0x200d);
}

/// Characters without a picture, that change nothing beside them.
bool is_unseen(char32_t c) {
  return is_ignorable(c) && !joins(c);
}

std::u32string characters_of(std::string_view name) {
  std::u32string characters;
  while (!name.empty()) characters += take_character(name).value_or(U'?');
  return characters;
}

std::string as_text(std::u32string_view characters) {
  std::string text;
  for (const char32_t c : characters) {
    std::array<utf8proc_uint8_t, 4> bytes;
    const auto size = utf8proc_encode_char(static_cast<int32_t>(c), bytes.data());
    text.append(bytes.begin(), bytes.begin() + size);
  }
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
  const std::string text = to_valid_utf8(name);
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> look(
      utf8proc_NFKC_Casefold(reinterpret_cast<const utf8proc_uint8_t*>(text.c_str())), &std::free);
  return look ? reinterpret_cast<const char*>(look.get()) : text;
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
