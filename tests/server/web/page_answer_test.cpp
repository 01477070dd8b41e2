#include "server/web/page_answer.h"

#include <array>
#include <zlib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr CarriedFile kTwoFiles[] = {
    {"index.html", "<link href=\"assets/style.css\"><link href=\"assets/style.css\">"},
    {"style.css", "p { color: red }"},
    {"favicon.ico", "icon"}};

std::string header(const PageAnswer& answer, std::string_view name) {
  for (const auto& [key, value] : answer.headers)
    if (key == name) return value;
  return "none";
}

std::string unpacked(std::string_view packed, size_t bytes_max) {
  std::string bytes(bytes_max, '\0');
  z_stream stream = {};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

/// Returns the target of the style in the index.
std::string style_target(const WebFiles& files) {
  for (const auto& [target, file] : files.all())
    if (target.ends_with(".css")) return target;
  return {};
}

TEST(WebFiles, AssetsHaveNamesWithTheirHashAndTheIndexNamesThem) {
  const WebFiles files(kTwoFiles);
  const std::string style = style_target(files);
  EXPECT_THAT(style, testing::MatchesRegex("/assets/style-[0-9a-f]{16}.css"));
  const WebFile* index = files.find("/");
  ASSERT_NE(index, nullptr);
  EXPECT_THAT(index->bytes, Not(HasSubstr("assets/style.css")));
  const std::string link = "<link href=\"" + style.substr(1) + "\">";
  EXPECT_EQ(index->bytes, link + link);
}

TEST(WebFiles, AChangedAssetHasAnotherName) {
  std::array<CarriedFile, 3> changed;
  std::ranges::copy(kTwoFiles, changed.begin());
  changed[1].bytes = "p { color: blue }";
  EXPECT_NE(style_target(WebFiles(kTwoFiles)), style_target(WebFiles(changed)));
}

TEST(WebFiles, NoTargetLeavesTheList) {
  const WebFiles files(kTwoFiles);
  for (const char* target : {"", "//", "/..", "/../etc/passwd", "/assets/../index.html", "/assets/",
                             "/index.html", "/assets/style.css", "/%2e%2e/", "/\x01", "*"})
    EXPECT_EQ(files.find(target), nullptr) << target;
}

TEST(WebFiles, AQueryCountsForNothing) {
  const WebFiles files(kTwoFiles);
  EXPECT_EQ(files.find("/?a=b"), files.find("/"));
}

// A build without the editor carries a page that says so.
TEST(WebFiles, TheCarriedPageIsWhole) {
  const WebFiles files;
  EXPECT_THAT(files.find("/")->bytes, HasSubstr("<title>Burnish</title>"));
  for (const auto& [target, file] : files.all()) {
    EXPECT_FALSE(file.bytes.empty()) << target;
    if (target.starts_with("/assets/")) {
      EXPECT_THAT(files.find("/")->bytes, HasSubstr(target.substr(1)));
    }
    EXPECT_TRUE(unpacked(file.gzipped, file.bytes.size() + 1) == file.bytes) << target;
  }
}

TEST(PageAnswer, AnAssetIsForeverAndTheIndexIsAskedForAgain) {
  const WebFiles files(kTwoFiles);
  const std::string style = style_target(files);
  const PageAnswer asset = answer_page(files, {"GET", style, "", ""});
  EXPECT_EQ(asset.status, 200u);
  EXPECT_EQ(asset.body, kTwoFiles[1].bytes);
  EXPECT_EQ(header(asset, "Cache-Control"), "max-age=31536000, immutable");
  EXPECT_EQ(header(asset, "Content-Type"), "text/css; charset=utf-8");
  const PageAnswer index = answer_page(files, {"GET", "/", "", ""});
  EXPECT_EQ(header(index, "Cache-Control"), "no-cache");
}

TEST(PageAnswer, AKnownTagNeedsNoBody) {
  const WebFiles files(kTwoFiles);
  const std::string tag = header(answer_page(files, {"GET", "/", "", ""}), "ETag");
  const PageAnswer again = answer_page(files, {"GET", "/", tag, ""});
  EXPECT_EQ(again.status, 304u);
  EXPECT_TRUE(again.body.empty());
  EXPECT_EQ(answer_page(files, {"GET", "/", "\"other\"", ""}).status, 200u);
}

TEST(PageAnswer, ABrowserThatUnpacksGetsThePackedForm) {
  const WebFiles files(kTwoFiles);
  const PageAnswer packed = answer_page(files, {"GET", "/", "", "br, gzip, deflate"});
  EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
  EXPECT_EQ(unpacked(packed.body, 100'000), files.find("/")->bytes);
  EXPECT_EQ(header(answer_page(files, {"GET", "/", "", "gzip;q=0"}), "Content-Encoding"), "none");
}

TEST(PageAnswer, ABrowserThatTakesBrotliGetsWhatTheBuildPacked) {
  constexpr CarriedFile kPacked[] = {{"index.html", "assets/style.css"},
                                     {"style.css", "p { color: red }"},
                                     {"style.css.br", "packed"},
                                     {"favicon.ico", "icon"}};
  const WebFiles files(kPacked);
  EXPECT_EQ(files.all().size(), 3u);
  const std::string style = style_target(files);
  const auto encoding = [&](std::string_view accepts) {
    return header(answer_page(files, {"GET", style, "", accepts}), "Content-Encoding");
  };
  EXPECT_EQ(answer_page(files, {"GET", style, "", "gzip, deflate, br"}).body, "packed");
  EXPECT_EQ(encoding("gzip, deflate, br"), "br");
  EXPECT_EQ(encoding("br;q=0.5"), "br");
  EXPECT_EQ(encoding("br;q=0,gzip;q=1"), "gzip");
  EXPECT_EQ(encoding("brx, gzip"), "gzip");
  EXPECT_EQ(encoding("identity"), "none");
  EXPECT_EQ(header(answer_page(files, {"GET", "/", "", "br"}), "Content-Encoding"), "none");
}

TEST(PageAnswer, EveryAnswerHasThePolicy) {
  const WebFiles files(kTwoFiles);
  for (const PageAnswer& answer :
       {answer_page(files, {"GET", "/", "", ""}), answer_page(files, {"GET", "/nothing", "", ""}),
        answer_page(files, {"POST", "/", "", ""}), refuse_page(403, "no")}) {
    EXPECT_THAT(header(answer, "Content-Security-Policy"), HasSubstr("default-src 'none'"));
    EXPECT_THAT(header(answer, "Content-Security-Policy"), HasSubstr("frame-ancestors 'none'"));
    EXPECT_EQ(header(answer, "X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(header(answer, "Referrer-Policy"), "no-referrer");
    EXPECT_EQ(header(answer, "Cross-Origin-Opener-Policy"), "same-origin");
  }
}

TEST(PageAnswer, OtherMethodsAndNamesAreRefused) {
  const WebFiles files(kTwoFiles);
  EXPECT_EQ(answer_page(files, {"HEAD", "/", "", ""}).status, 200u);
  EXPECT_EQ(answer_page(files, {"POST", "/", "", ""}).status, 405u);
  EXPECT_EQ(answer_page(files, {"GET", "/../etc/passwd", "", ""}).status, 404u);
}

}  // namespace
}  // namespace burnish
