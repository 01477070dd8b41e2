// The lines that wait, or that need more than the model.

#include <utility>

#include "client/script/script_runner.h"
#include "client/script/script_view.h"
#include "common/base/text_lines.h"

namespace burnish {

Status ScriptRunner::run_fork(const ScriptLine& line) {
  RETURN_IF_ERROR(save_edits());
  const std::string source = workspace_.document()->session().id;
  workspace_.fork(line.rest(), "");
  return update_until(
      [&] {
        const Document* const document = workspace_.document();
        return document && document->session().id != source;
      },
      "forking");
}

// A camera that a script has placed by its distance stays where it is when the size changes.
Status ScriptRunner::run_view(const ScriptLine& line) {
  const std::string& command = line.command;
  if (command == "scale_bar") {
    ASSIGN_OR_RETURN(has_scale_bar_, parse_switch(line.words[0]));
    return Status::ok();
  }
  RETURN_IF_ERROR(change_view(line, workspace_));
  if (command == "camera") is_camera_placed_ = line.words.size() > 2;
  if (command == "up" || command == "view" || command == "frame") is_camera_placed_ = false;
  return command == "colour" ? finish_picture() : Status::ok();
}

Status ScriptRunner::run_size(const ScriptLine& line) {
  ASSIGN_OR_RETURN(const ImageSize size, parse_image_size(line.words[0]));
  workspace_.viewport.set_size(size);
  if (!is_camera_placed_) workspace_.viewport.frame_all();
  return Status::ok();
}

Status ScriptRunner::run_pointer(const ScriptLine& line) {
  ASSIGN_OR_RETURN(const std::vector<double> numbers, parse_numbers(line.words, 0));
  if (numbers.size() % 2 != 0) return invalid_argument("a pixel must be two numbers");
  RETURN_IF_ERROR(finish_picture());  // the same points on every run
  Viewport& viewport = workspace_.viewport;
  const auto button = line.command == "drag" ? PointerButton::kLeft : PointerButton::kMiddle;
  const bool axes = std::exchange(viewport.options.axes, false);  // they would take the press
  viewport.press(button, {}, {numbers[0], numbers[1]});
  viewport.options.axes = axes;
  for (size_t i = 0; i < numbers.size(); i += 2) {
    viewport.move({numbers[i], numbers[i + 1]});
    RETURN_IF_ERROR(update());
  }
  viewport.release(button);
  RETURN_IF_ERROR(update());
  viewport.leave();
  return wait_for_noise();
}

Status ScriptRunner::take_screenshot(const std::filesystem::path& path) {
  RETURN_IF_ERROR(finish_picture());
  RETURN_IF_ERROR(workspace_.viewport.draw(renderer_, *workspace_.document()));
  const Viewport& viewport = workspace_.viewport;
  const ImageSize& size = viewport.size();
  const auto bar = has_scale_bar_ ? scale_bar(viewport.camera, size, pixel_ratio_of(size))
                                  : std::optional<ScaleBar>();
  ASSIGN_OR_RETURN(const Image image, workspace_.read_picture(bar));
  RETURN_IF_ERROR(host_.keep_picture(image, path));
  if (!image.note.empty()) workspace_.log.warning("saved " + path.string() + ": " + image.note);
  return Status::ok();
}

}  // namespace burnish
