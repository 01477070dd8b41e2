#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// How the surface is lit. Screen space: curvature is that of the picture, from pixel to pixel.
enum class LightKind {
  kClay,      ///< a lamp, the sky and a weak second lamp
  kRadiance,  ///< clay whose light follows curvature in screen space (Vergne et al. 2010)
  kCavity,    ///< clay with bright ridges and dark valleys, in screen space
  kRaking,    ///< one hard lamp: long shades on relief
  kCeramic,   ///< matcap: white glaze with bright windows
  kBronze,    ///< matcap: dark metal
  kSlopes,    ///< matcap: each direction of a slope has its own tone
  kUnlit,     ///< the colour of the surface alone
};

inline constexpr int kLightKinds = 8;
inline constexpr double kCavityMax = 2.5;
inline constexpr double kRadianceMax = 2;

/// The light of a picture. Directions turn with the camera.
struct Lighting {
  LightKind kind = LightKind::kClay;
  double azimuth_degrees = 137;   ///< of the lamp: 0 is the picture's right, 90 its upper edge
  double elevation_degrees = 25;  ///< of the lamp over the picture's plane; 90: from the eye
  double specular = 0.06;         ///< strength of the lamp's highlight, 0 to 1
  double occlusion = 0;           ///< how dark ambient occlusion makes hollows, 0 to 1
  double radiance = 1;            ///< of kRadiance: how strongly curvature acts, 0 to kRadianceMax
  double ridge = 1;               ///< of kCavity: 0 to kCavityMax
  double valley = 1;              ///< of kCavity: 0 to kCavityMax

  bool operator==(const Lighting&) const = default;
};

/// Fails: invalid_argument that names the value and its limit.
Status check_lighting(const Lighting& lighting);

/// Returns the word for a kind, e.g. "radiance".
std::string_view name_of(LightKind kind);

/// Returns the words of all kinds, in the order of LightKind, with commas between.
std::string light_kind_names();

/// Fails: invalid_argument that names all kinds.
Result<LightKind> parse_light_kind(std::string_view name);

/// Returns the direction to the lamp: x right, y up, z towards the eye. Unit length.
Vec3f to_lamp(const Lighting& lighting);

/// Returns the lighting with its lamp where a ball of radius 1 shows this point: its middle is the
/// lamp at the eye, its rim the picture's plane. Points beyond lie on the rim.
Lighting with_lamp_at(Lighting lighting, const Eigen::Vector2d& on_ball);

/// Returns where the ball of with_lamp_at() shows the lamp.
Eigen::Vector2d lamp_on_ball(const Lighting& lighting);

/// Returns true if the light of a pixel depends on pixels around it.
bool needs_surroundings(const Lighting& lighting);

/// Returns the lines of a script that set this lighting.
std::vector<std::string> script_lines(const Lighting& lighting);

}  // namespace burnish
