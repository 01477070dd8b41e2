// Draws the frames of the README's film: in the real window a scan's noise goes, and then its
// letters stand out. window_film OUT

#include <cmath>
#include <cstdio>

#include "common/base/limits.h"
#include "tests/system/picture_studio.h"

namespace burnish {
namespace {

// As in deploy/demo.
const GeneratedScan kScan{.kind = "tablet", .vertices = 320'000, .noise = 0.3};
const std::vector<std::string> kEdges = {"--keep-edges", "machined", "--crispness",     "0.5",
                                         "--wavelength", "40",       "--edge-strength", "0"};
constexpr double kBeta = 2.2;

constexpr const char* kStrength = "Keep edges/Strength of kept edges";
constexpr double kLeftEnd = 0.01, kRightEnd = 0.99;  // of a slider, beyond its track
constexpr Box kFrame{0, 0, 900, 560};                // the left column, and most of the picture

/// Returns the part of a slider's width for a part of its track, which ends half a handle earlier.
double on_track(double place) {
  constexpr double kHalfHandle = 0.037;
  return kHalfHandle + place * (1 - 2 * kHalfHandle);
}

/// Returns the part of the slider's track where this β is. Needs: β >= 1.
double place_of_beta(double beta) {
  return 0.5 + 0.5 * std::sqrt((beta - 1) / (kBetaMax - 1));
}

class Film {
 public:
  explicit Film(const std::filesystem::path& out) : studio_(out, 1, false) {
    studio_.open_scan(kScan, "inscription", kEdges);
    studio_.toggle_figures();
    studio_.key({"1"});  // from the front
    for (int i = 0; i < 4; ++i) studio_.click(560, 520, kWheelUp);
    for (const char* const closed : {"Limits", "Brush", "Transfer curve α(κ)"})
      studio_.click_on(closed);
    studio_.click_on("Keep edges");
    filter_normals();
    take();
  }

  /// Drags a slider between two places in steps, and takes a frame after each. Lets go at each: a
  /// drag shows less detail.
  void drag(const std::string& slider, double from, double to, int steps) {
    double last = from;
    for (int step = 1; step <= steps; ++step) {
      const double next = from + (to - from) * step / steps;
      studio_.slide(slider, on_track(last), on_track(next));
      last = next;
      take();
    }
  }

 private:
  /// Lets the server filter normals, so that the strength moves the surface at once.
  void filter_normals() {
    const Image noisy = settled();
    studio_.slide(kStrength, kLeftEnd, kRightEnd);
    while (settled().rgb == noisy.rgb) Studio::pause(1000);
    studio_.slide(kStrength, kRightEnd, kLeftEnd);
    while (settled().rgb != noisy.rgb) Studio::pause(1000);
  }

  /// Returns the surface when it has been still for longer than pages take to come.
  Image settled() {
    for (Image last = surface();;) {
      Studio::pause(5000);
      studio_.settle();
      Image now = surface();
      if (now.rgb == last.rgb) return now;
      last = std::move(now);
    }
  }

  Image surface() { return studio_.crop(studio_.middle()); }

  void take() {
    settled();
    char name[16];
    std::snprintf(name, sizeof name, "film-%02d", frames_++);
    studio_.save(name, kFrame);
  }

  Studio studio_;
  int frames_ = 0;
};

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: window_film OUT\n");
    return 2;
  }
  burnish::Film film(std::filesystem::absolute(words[1]));
  film.drag(burnish::kStrength, 0, 1, 5);
  film.drag("Filter/Gradient scale β", 0.5, burnish::place_of_beta(burnish::kBeta), 6);
}
