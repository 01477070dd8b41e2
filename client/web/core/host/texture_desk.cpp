#include "client/surface/texture_desk.h"

#include <cstring>
#include <deque>
#include <map>
#include <utility>

#include "client/web/core/host/exports.h"
#include "client/web/core/host/imports.h"

namespace burnish {
namespace {

/// So many pictures are decoded at once. The rest waits, so that a turn opens few sheets.
constexpr int kImagesMax = 4;
constexpr const char* kNoPixels =
    "the browser cannot decode the WebP, or hides its pixels (Firefox: "
    "privacy.resistFingerprinting)";

/// The browser decodes the texels, which are opaque: open_texture() has checked all else.
class HostDesk final : public TextureDesk {
 public:
  HostDesk(const PageGrid& grid, std::function<void()> on_news)
      : grid_(grid), on_news_(std::move(on_news)) {}
  ~HostDesk() override {
    std::erase_if(in_work(), [this](const auto& each) { return each.second.desk == this; });
  }

  void put(EncodedTexture encoded) override {
    jobs_.push_back(std::move(encoded));
    begin();
  }
  std::vector<DecodedTexture> take() override { return std::exchange(done_, {}); }

  /// `rgba`: null if the browser cannot decode it.
  static void on_image(int image, const uint8_t* rgba) {
    auto found = in_work().extract(image);
    if (!found.empty()) found.mapped().desk->finish(std::move(found.mapped().opened), rgba);
  }

 private:
  struct Work {
    HostDesk* desk;
    OpenedTexture opened;
  };
  static std::map<int, Work>& in_work() {
    static auto* const the = new std::map<int, Work>();  // lives as long as the page
    return *the;
  }

  void begin() {
    while (images_ < kImagesMax && !jobs_.empty()) {
      const EncodedTexture encoded = std::move(jobs_.front());
      jobs_.pop_front();
      PageItem damaged;
      Result<OpenedTexture> opened = open_texture(encoded, grid_, damaged);
      if (opened.is_ok())
        decode(std::move(*opened));
      else
        add({encoded.sheet, nullptr, opened.status(), damaged});
    }
  }

  void decode(OpenedTexture opened) {
    const std::vector<uint8_t> webp = std::move(opened.webp);
    const SheetLayout& layout = opened.sheet.layout;
    const int image = host_image_decode(webp.data(), webp.size(), layout.width, layout.height);
    in_work().emplace(image, Work{this, std::move(opened)});
    ++images_;
  }

  void finish(OpenedTexture opened, const uint8_t* rgba) {
    --images_;
    begin();
    if (rgba == nullptr) return add(finish_texture(std::move(opened), data_loss(kNoPixels), grid_));
    std::vector<Rgba8> texels(opened.sheet.layout.texels());
    std::memcpy(texels.data(), rgba, texels.size() * sizeof(Rgba8));
    add(finish_texture(std::move(opened), std::move(texels), grid_));
  }

  void add(DecodedTexture decoded) {
    done_.push_back(std::move(decoded));
    on_news_();
  }

  const PageGrid grid_;
  const std::function<void()> on_news_;
  std::deque<EncodedTexture> jobs_;
  int images_ = 0;  // that the browser decodes
  std::vector<DecodedTexture> done_;
};

}  // namespace

std::unique_ptr<TextureDesk> make_texture_desk(const PageGrid& grid,
                                               std::function<void()> on_news) {
  return std::make_unique<HostDesk>(grid, std::move(on_news));
}

}  // namespace burnish

void core_image_decoded(int image, uint8_t* rgba) {
  burnish::HostDesk::on_image(image, rgba);
  core_free(rgba);
}
