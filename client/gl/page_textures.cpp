#include "client/gl/page_textures.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "client/gl/capabilities.h"
#include "client/gl/gl_error.h"

namespace burnish {

static constexpr int kLayerSide = 1024;  // texels
static constexpr int kLayersMax = 32;
static constexpr int kLayersMaxSoftware = 8;
static constexpr double kFilledPart = 0.7;  // shelves leave gaps
static constexpr int kSheetUnit = 1;

/// A chart as the shader has it.
using CardChart = std::array<Eigen::Vector4f, 3>;  // u and v, to texels of the layer; the layer, 1

PageTextures::PageTextures()
    : layers_max_(card_capabilities().is_software ? kLayersMaxSoftware : kLayersMax),
      shelves_(kLayerSide, 0) {
  glGenTextures(1, &array_);
}

PageTextures::~PageTextures() {
  glDeleteTextures(1, &array_);
}

uint64_t PageTextures::bytes_max() const {
  const double layer = kLayerSide * kLayerSide * sizeof(Rgba8) * (1 + 1 / 4.0 + 1 / 16.0);
  return static_cast<uint64_t>(kFilledPart * layer * layers_max_);
}

void PageTextures::clear() {
  slots_.clear();
  is_full_ = false;
  shelves_ = SheetShelves(kLayerSide, shelves_.layers());
}

Status PageTextures::put(uint32_t number, std::shared_ptr<const PageTexture> texture,
                         ChartOrder order) {
  if (number >= slots_.size()) slots_.resize(number + 1);
  Slot& slot = slots_[number];
  release(slot);
  slot.texture = std::move(texture);
  slot.runs = std::move(order.runs);
  if (slot.texture == nullptr) return Status::ok();
  if (!take_place(slot)) return is_full_ ? Status::ok() : pack_anew();
  upload(slot);
  return check_gl("texture of a page");
}

static CardChart on_card(const TextureChart& chart, const ShelfPlace& place) {
  CardChart made{chart.u, chart.v, Eigen::Vector4f(static_cast<float>(place.layer), 1, 0, 0)};
  made[0].w() += static_cast<float>(place.x);
  made[1].w() += static_cast<float>(place.y);
  return made;
}

void PageTextures::draw(const ShaderProgram& program, std::span<const PatchRange> patches,
                        const std::function<void(const PatchRange&)>& draw_part) const {
  glActiveTexture(GL_TEXTURE0 + kSheetUnit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, array_);
  glActiveTexture(GL_TEXTURE0);
  program.set("sheets", kSheetUnit);
  const GLint chart = program.place("chart");
  for (const PatchRange& patch : patches) {
    if (patch.slot >= slots_.size() || !slots_[patch.slot].place) {
      program.set(chart, CardChart{Eigen::Vector4f::Zero(), Eigen::Vector4f::Zero(),
                                   Eigen::Vector4f::Zero()});
      draw_part(patch);
      continue;
    }
    const Slot& slot = slots_[patch.slot];
    auto run = std::ranges::lower_bound(slot.runs, patch.first, {}, &ChartRun::first);
    for (; run != slot.runs.end() && run->first < patch.first + patch.count; ++run) {
      program.set(chart, on_card(slot.texture->charts[run->chart], *slot.place));
      draw_part({patch.slot, run->first, run->count});
    }
  }
}

void PageTextures::release(Slot& slot) {
  if (slot.place) shelves_.give_back(*slot.place);
  if (slot.place) is_full_ = false;
  slot = {};
}

bool PageTextures::take_place(Slot& slot) {
  const TextureLevel& finest = slot.texture->levels[0];
  slot.place = shelves_.take(finest.width, finest.height);
  return slot.place.has_value();
}

void PageTextures::upload(const Slot& slot) const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, array_);
  for (int i = 0; i < static_cast<int>(kTextureLevels); ++i) {
    const TextureLevel& level = slot.texture->levels[i];
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, i, slot.place->x >> i, slot.place->y >> i,
                    slot.place->layer, level.width, level.height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                    level.texels.data());
  }
}

// The highest first leaves the fewest gaps. More layers are made where there were too few.
Status PageTextures::pack_anew() {
  std::vector<Slot*> all;
  for (Slot& slot : slots_)
    if (slot.texture) all.push_back(&slot);
  std::ranges::stable_sort(all, std::ranges::greater(),
                           [](const Slot* slot) { return slot->texture->levels[0].height; });
  for (int layers = std::max(shelves_.layers(), 1);; layers = std::min(2 * layers, layers_max_)) {
    shelves_ = SheetShelves(kLayerSide, layers);
    bool fit = true;
    for (Slot* slot : all) fit &= take_place(*slot);
    is_full_ = !fit;
    if (fit || layers == layers_max_) break;
  }
  RETURN_IF_ERROR(make_layers());
  for (const Slot* slot : all)
    if (slot->place) upload(*slot);
  return check_gl("textures of pages");
}

Status PageTextures::make_layers() const {
  glBindTexture(GL_TEXTURE_2D_ARRAY, array_);
  for (int i = 0; i < static_cast<int>(kTextureLevels); ++i)
    glTexImage3D(GL_TEXTURE_2D_ARRAY, i, GL_RGBA8, kLayerSide >> i, kLayerSide >> i,
                 shelves_.layers(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kTextureLevels - 1);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return check_gl(std::to_string(shelves_.layers()) + " layers of textures");
}

}  // namespace burnish
