#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/pages/page_loader.h"
#include "client/pages/page_source.h"
#include "client/scene/page_texture.h"
#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/service/scan_sheets.h"

namespace burnish {

/// The sheets behind a surface: what a SheetLoader and a thread that decodes do for it. A browser's
/// core has none yet. Used from one thread.
class TextureSupply {
 public:
  using Time = PageLoader::Time;

  TextureSupply() = default;
  virtual ~TextureSupply() = default;
  TextureSupply(const TextureSupply&) = delete;
  TextureSupply& operator=(const TextureSupply&) = delete;

  /// Chooses the sheets of the pages that a picture draws, and returns what to ask for and to
  /// cancel. `drawn`: each once. The result stays until the next call.
  virtual const PageRequests::Plan& look(const PageLoader& pages, std::span<const PageId> drawn,
                                         const LinkSpeed& link, Time now) = 0;
  /// Takes an item of the sheets that has come or failed.
  virtual void on_arrival(PageSource::Arrival arrival, Time now) = 0;
  /// Takes what was decoded since the last call.
  virtual void take_decoded(Time now) = 0;
  virtual void on_link_made() = 0;

  /// Returns null: the page shows its vertices' colours.
  virtual std::shared_ptr<const PageTexture> texture(PageId page) const = 0;
  /// Returns a number that rises when a texture comes or goes.
  virtual uint64_t changes() const = 0;
  /// Returns whether the last picture has all the sheets that it needs.
  virtual bool is_settled() const = 0;
  /// Returns what was given up, in words, once for a connection; else nothing.
  virtual std::string take_failures() = 0;
};

struct TextureOptions {
  PageHead pages;
  uint64_t pages_fingerprint = 0;  ///< of the pages' encoded head
  uint64_t bytes_max = 0;          ///< of decoded and encoded sheets in memory
  std::function<void()> on_news;   ///< take_decoded() has something; called from any thread
};

/// Opens the sheets of a scan. Fails: failed_precondition (sheets of other pages); data_loss that
/// names the damage; unimplemented (another version).
Result<std::unique_ptr<TextureSupply>> make_texture_supply(const SheetsDescription& description,
                                                           TextureOptions options);

}  // namespace burnish
