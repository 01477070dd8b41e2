#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "client/model/documents/document.h"
#include "client/scene/null_page_renderer.h"
#include "tests/bench/view_case.h"
#include "tests/system/link.h"

namespace burnish {

/// A window of 1280x720 pixels without pictures: it does everything else that a window does between
/// two pictures, every 16 ms.
class Viewer {
 public:
  /// Needs: `link` outlives this. Fails: as fetch_document() and PagedSurface::open().
  static Result<std::unique_ptr<Viewer>> open(const Link& link, const SessionWish& wish);

  /// Prepares one picture. Fails: as Document::look().
  Status picture();
  /// Takes pictures until what() holds. Fails: unavailable after two minutes.
  Status pictures_until(const std::function<bool()>& what);
  Status pictures_for(std::chrono::duration<double> length);

  /// Takes pictures until one shows any surface. Returns what came since the call.
  Result<ViewArrival> first_picture();
  /// Takes pictures until the prompt view is there: the camera trembles by less than a pixel, so
  /// that full detail does not begin. Returns what came since the call.
  Result<ViewArrival> prompt_view();
  /// Takes pictures until the view is as fine as it will become. Returns what came since the call.
  Result<ViewArrival> full_view();

  Document& document() { return *document_; }
  const NullPageRenderer& renderer() const { return renderer_; }
  /// Returns the point of the scan in the middle of the picture.
  Result<Vec3d> middle();
  uint64_t pictures() const { return pictures_; }

  Camera camera;
  ViewArrival described;  ///< from the answer of OpenSession until this was open
  static constexpr ImageSize kSize{1280, 720};
  static constexpr std::chrono::milliseconds kInterval{16};

 private:
  explicit Viewer(const Link& link) : link_(link) {}
  ViewArrival arrived_since(std::chrono::steady_clock::time_point start, uint64_t bytes) const;

  const Link& link_;
  NullPageRenderer renderer_;
  Tasks tasks_;
  MessageLog log_;
  Recorder recorder_;
  uint64_t pictures_ = 0;
  std::chrono::steady_clock::time_point next_;
  std::unique_ptr<Document> document_;  // last: it uses the others
};

}  // namespace burnish
