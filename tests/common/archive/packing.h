#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/archive/archive_writer.h"

namespace burnish {

inline std::span<const uint8_t> as_bytes(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

inline std::string as_string(const std::vector<uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// Returns an archive of texts, in their order.
inline std::vector<uint8_t> packed(const NamedTexts& files) {
  std::vector<FileToPack> to_pack;
  for (const auto& [name, text] : files) to_pack.push_back({name, as_bytes(text)});
  Result<std::vector<uint8_t>> archive = pack_archive(to_pack);
  EXPECT_TRUE(archive.is_ok()) << archive.status().message();
  return archive.is_ok() ? std::move(archive).value() : std::vector<uint8_t>();
}

/// Replaces each occurrence of some bytes. Needs: both have the same length.
inline std::vector<uint8_t> patched(const std::vector<uint8_t>& bytes, const std::string& from,
                                    const std::string& to) {
  std::string text = as_string(bytes);
  EXPECT_NE(text.find(from), std::string::npos) << from;
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return {text.begin(), text.end()};
}

}  // namespace burnish
