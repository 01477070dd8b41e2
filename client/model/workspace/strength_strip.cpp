#include "client/model/workspace/strength_strip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/model/workspace/session_pictures.h"

namespace burnish {

std::array<double, 3> strengths_beside(double strength) {
  if (strength >= 1) return {1.0 / 3, 2.0 / 3, 1};
  return {strength / 2, strength, std::min(1.0, 1.5 * strength)};
}

Status StrengthStrip::open(const PresetInForce& in_force, Document& document) {
  close(&document);
  if (document.is_viewer()) return failed_precondition("a viewer cannot try strengths");
  if (!Document::has_trial(in_force.preset))
    return failed_precondition("the strengths of preset '" + in_force.preset.name +
                               "' cannot be tried: it has no β and no bands, or both");
  if (!(in_force.strength > 0)) return failed_precondition("strength 0 has no pictures beside it");
  preset_ = in_force.preset;
  const std::array<double, 3> strengths = strengths_beside(in_force.strength);
  for (size_t i = 0; i < strengths.size(); ++i) pictures_[i].strength = strengths[i];
  in_force_ = in_force.strength >= 1 ? 2 : 1;
  next_ = in_force_;
  return Status::ok();
}

void StrengthStrip::close(Document* document) {
  if (document && is_open()) document->end_trial();
  preset_.reset();
  pictures_ = {};
  next_.reset();
  seen_.reset();
}

StrengthStrip::Seen StrengthStrip::seen_in(const Document& document, const Viewport& viewport) {
  return {viewport.camera, viewport.size(), viewport.options, document.colour(),
          viewport.hold_original};
}

// Values go through a file or a message, which round them.
bool StrengthStrip::may_begin(const Document& document) const {
  constexpr double kRounding = 1e-5;
  const auto strength = strength_of(*preset_, document.filter(), document.lengths());
  return strength && std::abs(*strength - pictures_[in_force_].strength) < kRounding;
}

bool StrengthStrip::may_go_on(const Document& document, const Viewport& viewport) const {
  if (document.link() != LinkState::kLive || document.is_viewer()) return false;
  if (!has_begun()) return true;
  return document.edits_known() <= edits_ && document.refusals() == refusals_ &&
         *seen_ == seen_in(document, viewport) && document.is_trying() == is_tried();
}

void StrengthStrip::begin(const Document& document, const Viewport& viewport) {
  seen_ = seen_in(document, viewport);
  edits_ = document.edits_known();
  refusals_ = document.refusals();
}

void StrengthStrip::follow(Document& document, Viewport& viewport) {
  if (is_open() && !may_go_on(document, viewport)) close(&document);
  if (is_open() && !has_begun() && document.is_settled())
    may_begin(document) ? begin(document, viewport) : close(&document);
  viewport.hides_rings = has_begun() && !is_complete();
}

bool StrengthStrip::wants_picture(const Document& document) const {
  if (!has_begun() || is_complete()) return false;
  return is_tried() ? document.shows_trial() : document.is_settled();
}

const StrengthStrip::Picture& StrengthStrip::take(const Image& drawn, Document& document) {
  Picture& picture = pictures_[*next_];
  const ImageSize& size = kStrengthPictureSize;
  const bool is_large = drawn.size.width >= size.width && drawn.size.height >= size.height;
  picture.image = is_large ? shrunk(drawn, size) : drawn;
  picture.number = ++last_number_;
  go_to_next(document);
  return picture;
}

void StrengthStrip::go_to_next(Document& document) {
  const auto missing = std::ranges::find(pictures_, 0U, &Picture::number);
  if (missing == pictures_.end()) {
    next_.reset();
    return document.end_trial();
  }
  next_ = static_cast<size_t>(missing - pictures_.begin());
  document.try_strength(*preset_, missing->strength);
}

Status StrengthStrip::choose(int number, Document& document) {
  if (!is_open()) return failed_precondition("there are no pictures of strengths");
  if (number < 0 || number > 2)
    return invalid_argument("picture " + std::to_string(number) + " is outside 0 to 2");
  const Preset preset = *preset_;
  const double strength = pictures_[static_cast<size_t>(number)].strength;
  // This edit does not change what the pictures show.
  is_complete() ? void(++edits_) : close(&document);
  document.preview_strength(preset, strength);
  document.commit_strength(preset);
  return Status::ok();
}

std::string StrengthStrip::trial_text() const {
  if (!is_tried()) return {};
  char text[48];
  std::snprintf(text, sizeof text, "trying strength %.2f", pictures_[*next_].strength);
  return text;
}

}  // namespace burnish
