#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/pages/page_loader.h"
#include "client/pages/page_source.h"
#include "client/scene/page_texture.h"
#include "client/sheets/sheet_loader.h"
#include "client/surface/texture_desk.h"
#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/service/scan_sheets.h"

namespace burnish {

struct TextureOptions {
  PageHead pages;
  uint64_t pages_fingerprint = 0;  ///< of the pages' encoded head
  uint64_t bytes_max = 0;          ///< of decoded and encoded sheets in memory
  std::function<void()> on_news;   ///< take_decoded() has something; called from any thread
};

/// The sheets behind a surface: what a SheetLoader and a desk that decodes do for it. Used from one
/// thread.
class TextureSupply {
 public:
  using Time = PageLoader::Time;

  /// Opens the sheets of a scan. Fails: failed_precondition (sheets of other pages); data_loss that
  /// names the damage; unimplemented (another version).
  static Result<std::unique_ptr<TextureSupply>> open(const SheetsDescription& description,
                                                     TextureOptions options);

  /// Chooses the sheets of the pages that a picture draws, and returns what to ask for and to
  /// cancel. `drawn`: each once. The result stays until the next call.
  const PageRequests::Plan& look(const PageLoader& pages, std::span<const PageId> drawn,
                                 const LinkSpeed& link, Time now);
  /// Takes an item of these sheets that has come or failed.
  void on_arrival(PageSource::Arrival arrival, Time now);
  /// Takes what was decoded since the last call.
  void take_decoded(Time now);
  void on_link_made();

  /// Returns which sheets of the scan they are: SheetsDescription::version.
  uint64_t version() const { return loader_.version(); }
  /// Returns what was asked for and has not come.
  std::vector<PageItem> in_flight() const { return loader_.in_flight(); }

  /// Returns null: the page shows its vertices' colours.
  std::shared_ptr<const PageTexture> texture(PageId page) const { return loader_.texture(page); }
  /// Returns a number that rises when a texture comes or goes.
  uint64_t changes() const { return loader_.changes(); }
  /// Returns whether the last picture has all the sheets that it needs.
  bool is_settled() const { return loader_.is_settled(); }
  /// Returns whether it has each texel that a picture at rest needs.
  bool has_all() const { return loader_.has_all(); }
  /// Returns what was given up, in words, once for a connection; else nothing.
  std::string take_failures();

 private:
  TextureSupply(SheetHead head, uint64_t version, TextureOptions options);

  SheetLoader loader_;
  bool has_told_ = false;  // of failures over this connection
  std::unique_ptr<TextureDesk> desk_;
};

}  // namespace burnish
