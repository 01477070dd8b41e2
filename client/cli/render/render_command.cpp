#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "client/cli/command.h"
#include "client/cli/commands.h"
#include "client/cli/in_range.h"
#include "client/cli/print_json.h"
#include "client/cli/render/scan_picture.h"
#include "client/pictures/picture.h"
#include "client/report/length_text.h"
#include "client/scene/picture_mark.h"
#include "client/scene/png_writer.h"
#include "client/scene/scale_bar.h"
#include "common/mesh/mesh_format.h"

namespace burnish {
namespace {

struct RenderOptions {
  std::string scan;
  std::string out;
  PictureOptions picture;
  std::optional<std::string> scale_bar;  // the unit of its length; none: there is no bar
  bool colours = false;
  bool clay = false;
  bool json = false;
};

// Both return the usage message that CLI11 expects from a check: empty if the text is right.

std::string parse_size(const std::string& text, ImageSize& size) {
  const Result<ImageSize> parsed = parse_image_size(text);
  if (parsed.is_ok()) size = *parsed;
  return usage_message(parsed.status());
}

std::string parse_view(const std::string& text, PictureOptions& picture) {
  int end = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%n", &picture.azimuth_degrees, &picture.elevation_degrees,
                  &end) != 2 ||
      static_cast<size_t>(end) != text.size() || !std::isfinite(picture.azimuth_degrees) ||
      !(std::abs(picture.elevation_degrees) <= 90))
    return "'" + text + "' is not AZIMUTH,ELEVATION in degrees, the elevation within -90..90";
  return {};
}

std::string parse_light(const std::string& text, Lighting& lighting) {
  const Result<LightKind> kind = parse_light_kind(text);
  if (kind.is_ok()) lighting.kind = *kind;
  return usage_message(kind.status());
}

std::string parse_up(const std::string& text, std::optional<UpAxis>& up) {
  const Result<UpAxis> axis = parse_up_axis(text);
  if (axis.is_ok()) up = *axis;
  return usage_message(axis.status());
}

/// Parses two numbers that check_lighting() allows.
std::string parse_pair(const std::string& text, double& first, double& second,
                       const Lighting& lighting) {
  int end = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%n", &first, &second, &end) != 2 ||
      static_cast<size_t>(end) != text.size())
    return "'" + text + "' is not two numbers with a comma between";
  return usage_message(check_lighting(lighting));
}

Status check_picture_name(const std::filesystem::path& path) {
  if (path.extension() == ".png") return Status::ok();
  return invalid_argument(path.string() + ": extension '" + path.extension().string() +
                          "' is not a picture format; use .png");
}

ScanColours colours_of(const RenderOptions& options) {
  if (options.clay) return ScanColours::kNone;
  return options.colours ? ScanColours::kNeeded : ScanColours::kIfAny;
}

void add_scale_bar(ScanPicture& drawn, const std::string& unit) {
  const ImageSize& size = drawn.image.size;
  const auto bar = scale_bar(drawn.camera, size, pixel_ratio_of(size));
  if (bar) draw_scale_bar(drawn.image, *bar, length_text(bar->length, unit));
}

Status render(const RenderOptions& options) {
  RETURN_IF_ERROR(check_picture_name(options.out));
  ASSIGN_OR_RETURN(ScanPicture drawn,
                   draw_scan_picture(options.scan, options.picture, colours_of(options)));
  for (const std::string& warning : drawn.warnings) std::cerr << "warning: " << warning << "\n";
  if (options.scale_bar) add_scale_bar(drawn, *options.scale_bar);
  const Image& image = drawn.image;
  RETURN_IF_ERROR(write_png(image, options.out));
  if (options.json) {
    print_json({{"out", options.out},
                {"width", image.size.width},
                {"height", image.size.height},
                {"textured", drawn.is_textured}});
    return Status::ok();
  }
  std::printf("%s: %dx%d pixels\n", options.out.c_str(), image.size.width, image.size.height);
  return Status::ok();
}

}  // namespace

static void add_light_options(CLI::App& command, Lighting& lighting) {
  const auto add = [&](const char* name, const char* help, const char* type, auto check) {
    command
        .add_option_function<std::string>(
            name, [](const std::string&) {}, help)
        ->type_name(type)
        ->check(check);
  };
  add("--light", ("How it is lit: " + light_kind_names() + " (default clay)").c_str(), "KIND",
      [&lighting](const std::string& text) { return parse_light(text, lighting); });
  add("--light-direction",
      "Of the lamp, in degrees: azimuth from the picture's right to its upper edge, elevation over "
      "the picture's plane (default 137,25)",
      "AZIMUTH,ELEVATION", [&lighting](const std::string& text) {
        return parse_pair(text, lighting.azimuth_degrees, lighting.elevation_degrees, lighting);
      });
  add("--cavity", "With --light cavity: how bright ridges and how dark valleys are (default 1,1)",
      "RIDGE,VALLEY", [&lighting](const std::string& text) {
        return parse_pair(text, lighting.ridge, lighting.valley, lighting);
      });
  command.add_option("--radiance", lighting.radiance, "With --light radiance: how strongly")
      ->check(in_range(0.0, kRadianceMax))
      ->capture_default_str();
  command.add_option("--specular", lighting.specular, "Strength of the lamp's highlight")
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--occlusion", lighting.occlusion, "How dark hollows are, in any light")
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
}

static void add_camera_options(CLI::App& command, PictureOptions& picture) {
  command
      .add_option_function<std::string>(
          "--up", [](const std::string&) {},
          "Axis that points up: x, y, z, -x, -y or -z (default y; z for land as surveyors store "
          "it)")
      ->type_name("AXIS")
      ->check([&picture](const std::string& text) { return parse_up(text, picture.up); });
  command.add_flag("--orthographic", picture.orthographic, "Draw without perspective");
}

void add_render_command(CommandTable& commands) {
  const auto options = std::make_shared<RenderOptions>();
  PictureOptions& picture = options->picture;
  CLI::App* command = commands.add("render", "Draw a picture of a scan, without a window",
                                   [options] { return render(*options); });
  command->add_option("SCAN", options->scan, "Mesh file: " + extensions_text())->required();
  command->add_option("OUT", options->out, "Picture to write: .png")->required();
  command
      ->add_option_function<std::string>(
          "--size", [](const std::string&) {}, "Size in pixels (default 1280x960)")
      ->type_name("WxH")
      ->check([&picture](const std::string& text) { return parse_size(text, picture.size); });
  command
      ->add_option_function<std::string>(
          "--view", [](const std::string&) {},
          "Camera angles in degrees: azimuth from +z towards +x, elevation towards +y "
          "(default 25,20)")
      ->type_name("AZIMUTH,ELEVATION")
      ->check([&picture](const std::string& text) { return parse_view(text, picture); });
  command->add_option("--zoom", picture.zoom, "Magnification; 1 shows the whole scan")
      ->check(in_range(0.01, 1000.0))
      ->capture_default_str();
  add_camera_options(*command, picture);
  add_light_options(*command, picture.style.lighting);
  CLI::Option* const clay = command->add_flag("--clay", options->clay, "Show the shape alone");
  command
      ->add_flag(
          "--colours", options->colours,
          "Show the scan's own colours, and the texels of its pictures; the default for scans that "
          "have some")
      ->excludes(clay);
  command
      ->add_option_function<std::string>(
          "--scale-bar", [options](const std::string& unit) { options->scale_bar = unit; },
          "Draw a bar of a round length at the middle's distance. UNIT is that of the scan's "
          "coordinates, for example mm; \"\" for none")
      ->type_name("UNIT");
  command->add_flag("--flat", picture.style.flat, "Give each triangle one shade");
  command->add_flag("--json", options->json, "Print the result as JSON");
  command->add_flag("--wireframe", picture.style.wireframe, "Draw the triangles' edges");
}

}  // namespace burnish
