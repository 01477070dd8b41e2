#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "client/model/documents/document.h"
#include "client/model/view/viewport.h"
#include "client/scene/image.h"

namespace burnish {

/// Small pictures are of this size, or of the picture's if that is smaller.
inline constexpr ImageSize kStrengthPictureSize{240, 180};

/// Returns three rising strengths, this one among them: half and one and a half of it, at most 1;
/// of 1 a third and two thirds. Needs: above 0 to 1.
std::array<double, 3> strengths_beside(double strength);

/// Three small pictures of what the user looks at, at three strengths of the preset in force. The
/// session shows each strength until its picture has settled, as a drag would; so a picture shows
/// what its strength gives, whatever else moves the surface. Closes by itself when the user does
/// something else or looks elsewhere, when anybody edits, when an edit of the user is refused, and
/// when the link is lost.
class StrengthStrip {
 public:
  struct Picture {
    double strength = 0;
    uint64_t number = 0;  ///< 0: not there yet; else of this image, and of no other of this strip
    Image image;
  };

  /// Begins once the document has settled. Fails: failed_precondition for a viewer, and for a
  /// preset whose strengths cannot be tried.
  Status open(const PresetInForce& in_force, Document& document);
  /// Ends what the session shows. Pictures that are there go.
  void close(Document* document);
  bool is_open() const { return preset_.has_value(); }

  /// Goes on, or closes. Call it once per picture, behind the updates of both.
  void follow(Document& document, Viewport& viewport);
  /// Returns whether what is drawn now is to be kept. Needs: the last picture is at rest.
  bool wants_picture(const Document& document) const;
  /// Keeps the picture that was drawn. Returns the one that was made of it.
  const Picture& take(const Image& drawn, Document& document);

  /// Sets the strength of a picture. The pictures stay if all of them are there.
  /// Fails: invalid_argument for a number that is not 0 to 2; failed_precondition without pictures.
  Status choose(int number, Document& document);

  /// By strength. Needs: is_open().
  const std::array<Picture, 3>& pictures() const { return pictures_; }
  const std::string& preset() const { return preset_->name; }
  /// Says that the view shows something else than the session's values: "trying strength 0.33";
  /// empty: it does not.
  std::string trial_text() const;

 private:
  /// Decides what the pictures show, but for the session.
  struct Seen {
    Camera camera;
    ImageSize size;
    ViewOptions options;
    ColourBy colour = ColourBy::kNothing;
    bool is_original = false;
    bool operator==(const Seen&) const = default;
  };
  static Seen seen_in(const Document& document, const Viewport& viewport);
  bool is_complete() const { return !next_; }
  bool has_begun() const { return seen_.has_value(); }
  bool is_tried() const { return next_ && *next_ != in_force_; }
  bool may_begin(const Document& document) const;
  bool may_go_on(const Document& document, const Viewport& viewport) const;
  void begin(const Document& document, const Viewport& viewport);
  void go_to_next(Document& document);

  std::optional<Preset> preset_;  // absent: closed
  std::array<Picture, 3> pictures_;
  size_t in_force_ = 0;         // the picture of the session's values, which comes first
  std::optional<size_t> next_;  // the picture that is waited for
  std::optional<Seen> seen_;    // absent: waits until the document has settled
  uint64_t edits_ = 0;          // of the session, that the pictures have seen or do not depend on
  uint64_t refusals_ = 0;       // of the user's edits, before the pictures
  uint64_t last_number_ = 0;
};

}  // namespace burnish
