#include "client/gl/page_textures.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "client/gl/capabilities.h"
#include "client/gl/dialect.h"
#include "client/gl/gl_error.h"
#include "client/gl/shaders.h"
#include "client/gl/sheet_shelves.h"

namespace burnish {
namespace {

constexpr int kLayerSide = 1024;  // texels
constexpr int kLayersMax = 32;
constexpr int kLayersMaxSoftware = 8;
constexpr double kFilledPart = 0.7;  // shelves leave gaps
constexpr int kSheetUnit = 1, kChartUnit = 2, kNumberUnit = 3;

/// A chart as the shader reads it: three texels of four floats.
struct CardChart {
  Eigen::Vector4f u, v;  // to texels of the layer
  Eigen::Vector4f layer;
};
static_assert(sizeof(CardChart) == 48);

/// A list of items in a buffer that a shader reads as a texture. Items are appended; what is gone
/// leaves a gap until all are written anew.
class BufferTexture {
 public:
  explicit BufferTexture(GLenum format) : format_(format) {
    glGenBuffers(1, &buffer_);
    glGenTextures(1, &texture_);
  }
  ~BufferTexture() {
    glDeleteTextures(1, &texture_);
    glDeleteBuffers(1, &buffer_);
  }
  BufferTexture(const BufferTexture&) = delete;
  BufferTexture& operator=(const BufferTexture&) = delete;

  bool has_room(size_t bytes) const { return used_ + bytes <= room_; }
  /// Empties the list, with room for so many bytes.
  void reset(size_t room) {
    used_ = 0;
    room_ = room;
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(room), nullptr, GL_DYNAMIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, texture_);
    glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_);
  }
  /// Returns where the bytes begin. Needs: room for them.
  size_t append(const void* bytes, size_t count) {
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(used_), static_cast<GLsizeiptr>(count),
                    bytes);
    return std::exchange(used_, used_ + count);
  }
  void bind(int unit) const {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_);
  }

 private:
  GLenum format_;
  GLuint buffer_ = 0;
  GLuint texture_ = 0;
  size_t used_ = 0;
  size_t room_ = 0;
};

class ArrayTextures final : public PageTextures {
 public:
  ArrayTextures() : layers_max_(card_capabilities().is_software ? kLayersMaxSoftware : kLayersMax) {
    glGenTextures(1, &array_);
  }
  ~ArrayTextures() override { glDeleteTextures(1, &array_); }

  Result<ShaderProgram> make_program() const override {
    const std::string define = "#define TEXTURES\n";
    return ShaderProgram::create("textured page", (define + kPageVertexShader).c_str(),
                                 (define + page_fragment_shader()).c_str());
  }

  uint64_t bytes_max() const override {
    const double layer = kLayerSide * kLayerSide * sizeof(Rgba8) * (1 + 1 / 4.0 + 1 / 16.0);
    return static_cast<uint64_t>(kFilledPart * layer * layers_max_);
  }

  void clear() override {
    slots_.clear();
    is_full_ = false;
    shelves_ = SheetShelves(kLayerSide, shelves_.layers());
  }

  Status put(uint32_t slot, std::shared_ptr<const PageTexture> texture) override {
    if (slot >= slots_.size()) slots_.resize(slot + 1);
    release(slots_[slot]);
    slots_[slot].texture = std::move(texture);
    if (slots_[slot].texture == nullptr) return Status::ok();
    if (!take_place(slots_[slot])) return is_full_ ? Status::ok() : pack_anew();
    upload(slots_[slot]);
    RETURN_IF_ERROR(list(slots_[slot]));
    return check_gl("texture of a page");
  }

  void bind(const ShaderProgram& program) const override {
    charts_.bind(kChartUnit);
    numbers_.bind(kNumberUnit);
    glActiveTexture(GL_TEXTURE0 + kSheetUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array_);
    glActiveTexture(GL_TEXTURE0);
    program.set("sheets", kSheetUnit);
    program.set("charts", kChartUnit);
    program.set("chart_numbers", kNumberUnit);
  }

  void choose(const ShaderProgram& program, const PatchRange& patch) const override {
    const bool is_here = patch.slot < slots_.size() && slots_[patch.slot].is_listed;
    program.set("is_textured", is_here);
    if (!is_here) return;
    const Slot& slot = slots_[patch.slot];
    program.set("first_triangle", static_cast<int>(slot.first_number + patch.first));
    program.set("first_chart", static_cast<int>(slot.first_chart));
  }

 private:
  struct Slot {
    std::shared_ptr<const PageTexture> texture;
    std::optional<ShelfPlace> place;
    bool is_listed = false;   // the shader finds it
    size_t first_number = 0;  // of its triangles
    size_t first_chart = 0;
  };

  void release(Slot& slot) {
    if (slot.place) shelves_.give_back(*slot.place);
    if (slot.place) is_full_ = false;
    slot = {};
  }

  bool take_place(Slot& slot) {
    const TextureLevel& finest = slot.texture->levels[0];
    slot.place = shelves_.take(finest.width, finest.height);
    return slot.place.has_value();
  }

  void upload(const Slot& slot) const {
    glBindTexture(GL_TEXTURE_2D_ARRAY, array_);
    for (int i = 0; i < static_cast<int>(kTextureLevels); ++i) {
      const TextureLevel& level = slot.texture->levels[i];
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, i, slot.place->x >> i, slot.place->y >> i,
                      slot.place->layer, level.width, level.height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                      level.texels.data());
    }
  }

  // The highest first leaves the fewest gaps. More layers are made where there were too few.
  Status pack_anew() {
    std::vector<Slot*> all;
    for (Slot& slot : slots_)
      if (slot.texture) all.push_back(&slot);
    std::ranges::stable_sort(all, std::greater<>(),
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
    RETURN_IF_ERROR(list_all());
    return check_gl("textures of pages");
  }

  Status make_layers() const {
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

  static size_t number_bytes(const Slot& slot) {
    return slot.texture->chart_of_triangle.size() * sizeof(uint16_t);
  }
  static size_t chart_bytes(const Slot& slot) {
    return slot.texture->charts.size() * sizeof(CardChart);
  }

  Status list(Slot& slot) {
    if (!numbers_.has_room(number_bytes(slot)) || !charts_.has_room(chart_bytes(slot)))
      return list_all();
    append(slot);
    return Status::ok();
  }

  void append(Slot& slot) {
    std::vector<CardChart> charts;
    for (const TextureChart& chart : slot.texture->charts) {
      charts.push_back(
          {chart.u, chart.v, Eigen::Vector4f(static_cast<float>(slot.place->layer), 0, 0, 0)});
      charts.back().u.w() += static_cast<float>(slot.place->x);
      charts.back().v.w() += static_cast<float>(slot.place->y);
    }
    slot.first_chart = charts_.append(charts.data(), chart_bytes(slot)) / sizeof(CardChart);
    slot.first_number =
        numbers_.append(slot.texture->chart_of_triangle.data(), number_bytes(slot)) /
        sizeof(uint16_t);
    slot.is_listed = true;
  }

  // Leaves as much room again. A driver that reads no such long lists shows vertices' colours.
  Status list_all() {
    size_t numbers = 1, charts = 1;
    for (const Slot& slot : slots_) {
      if (!slot.place) continue;
      numbers += number_bytes(slot);
      charts += chart_bytes(slot);
    }
    GLint texels_max = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels_max);
    const auto most = static_cast<size_t>(texels_max);
    numbers_.reset(std::min(2 * numbers, most * sizeof(uint16_t)));
    charts_.reset(std::min(2 * charts, most * sizeof(Eigen::Vector4f)));
    for (Slot& slot : slots_) {
      slot.is_listed = false;
      const bool has_room = slot.place && numbers_.has_room(number_bytes(slot)) &&
                            charts_.has_room(chart_bytes(slot));
      if (has_room) append(slot);
    }
    return check_gl("charts of pages");
  }

  const int layers_max_;
  bool is_full_ = false;  // some slot found no place since one was given back
  GLuint array_ = 0;
  SheetShelves shelves_{kLayerSide, 0};
  BufferTexture charts_{GL_RGBA32F};
  BufferTexture numbers_{GL_R16UI};
  std::vector<Slot> slots_;
};

}  // namespace

std::unique_ptr<PageTextures> make_page_textures() {
  if (is_embedded()) return nullptr;
  return std::make_unique<ArrayTextures>();
}

}  // namespace burnish
