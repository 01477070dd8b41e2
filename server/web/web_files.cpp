#include "server/web/web_files.h"

#include <cstdio>
#include <utility>
#include <xxhash.h>
#include <zlib.h>

#include "common/base/check.h"

namespace burnish {
namespace {

constexpr std::string_view kIndex = "index.html";
constexpr std::string_view kFavicon = "favicon.ico";
constexpr std::string_view kBrotli = ".br";

constexpr std::pair<std::string_view, const char*> kTypes[] = {
    {".html", "text/html; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".svg", "image/svg+xml"},
    {".ico", "image/x-icon"},
};

std::string hash_of(std::string_view bytes) {
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx",
                static_cast<unsigned long long>(XXH3_64bits(bytes.data(), bytes.size())));
  return text;
}

std::string gzip(std::string_view bytes) {
  constexpr int kGzipWindow = 15 + 16;  // 16 asks for gzip's header
  z_stream stream = {};
  BURNISH_CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, 8,
                             Z_DEFAULT_STRATEGY) == Z_OK,
                "zlib lacks memory");
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int end = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  BURNISH_CHECK(end == Z_STREAM_END, "a page's file is not packed whole");
  return packed;
}

std::string type_of(std::string_view name) {
  for (const auto& [ending, type] : kTypes)
    if (name.ends_with(ending)) return type;
  BURNISH_CHECK(false, "a page's file of an unknown kind");
  return {};
}

WebFile made_of(std::string_view name, std::string bytes, bool is_immutable) {
  WebFile file{type_of(name), std::move(bytes), {}, {}, {}, is_immutable};
  file.gzipped = gzip(file.bytes);
  file.etag = "\"" + hash_of(file.bytes) + "\"";
  return file;
}

std::string name_with_hash(const CarriedFile& file) {
  const size_t dot = file.name.rfind('.');
  return "assets/" + std::string(file.name.substr(0, dot)) + "-" + hash_of(file.bytes) +
         std::string(file.name.substr(dot));
}

/// Returns what the build packed of a file; empty if it did not.
std::string_view brotli_of(std::span<const CarriedFile> files, std::string_view name) {
  for (const CarriedFile& file : files)
    if (file.name.starts_with(name) && file.name.substr(name.size()) == kBrotli) return file.bytes;
  return {};
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

WebFiles::WebFiles() : WebFiles(carried_files()) {}

WebFiles::WebFiles(std::span<const CarriedFile> files) {
  std::string index;
  for (const CarriedFile& file : files)
    if (file.name == kIndex) index = file.bytes;
  for (const CarriedFile& file : files) {
    if (file.name == kIndex || file.name == kFavicon || file.name.ends_with(kBrotli)) continue;
    const std::string name = name_with_hash(file);
    replace_all(index, "assets/" + std::string(file.name), name);
    WebFile made = made_of(file.name, std::string(file.bytes), true);
    made.brotli = brotli_of(files, file.name);
    files_.emplace("/" + name, std::move(made));
  }
  for (const CarriedFile& file : files)
    if (file.name == kFavicon)
      files_.emplace("/favicon.ico", made_of(kFavicon, std::string(file.bytes), false));
  files_.emplace("/", made_of(kIndex, index, false));
}

const WebFile* WebFiles::find(std::string_view target) const {
  const auto found = files_.find(target.substr(0, target.find('?')));
  return found == files_.end() ? nullptr : &found->second;
}

}  // namespace burnish
