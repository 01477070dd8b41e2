#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "client/pages/known_pages.h"
#include "client/pages/page_requests.h"
#include "client/pages/page_view.h"
#include "client/sheets/known_sheets.h"
#include "client/sheets/opened_texture.h"
#include "client/sheets/sheet_store.h"

namespace burnish {

/// The textures of one picture.
struct SheetQuestion {
  PageView view;
  float largest_move = 0;         ///< of a vertex, file units
  std::span<const PageId> drawn;  ///< each once
  bool is_at_rest = false;        ///< view and surface are those of the last picture
  bool may_ask = true;            ///< no page of the cut waits for the link
  LinkSpeed link;
};

/// Brings the sheets of the pages that pictures draw. Takes for each page the coarsest sheet that
/// is fine enough. Until it comes, a coarser one stays, or the vertices' colours. Knows no network,
/// threads or renderer. For one thread.
///
/// For each picture: look(), carry out requests(), decode take_jobs(), then draw with texture().
class SheetLoader {
 public:
  using Time = PageRequests::Time;

  /// `version`: of the sheets (SheetsDescription::version); its items are of it.
  SheetLoader(SheetHead head, PageHead pages, uint64_t budget_bytes, uint64_t version = 0)
      : sheets_(std::move(head), std::move(pages)), store_(budget_bytes), version_(version) {}

  /// `pages`: of the same scan; it knows the drawn pages.
  void look(const SheetQuestion& question, const KnownPages& pages, Time now);

  const PageRequests::Plan& requests() const { return requests_.plan(); }
  /// Returns what is to be decoded since the last call. `page_of` returns a decoded page or null.
  template <typename PageOf>
  std::vector<EncodedTexture> take_jobs(const PageOf& page_of);

  /// An item of this version came, asked for or not, or failed to come.
  void on_arrival(PageItem item, Result<std::vector<uint8_t>> bytes, Time now);
  void on_decoded(DecodedTexture decoded, Time now);
  /// A new connection: all that failed is asked for again.
  void on_link_made() { requests_.failures().clear(); }

  /// Returns null: the page shows its vertices' colours.
  std::shared_ptr<const PageTexture> texture(PageId page) const;
  /// Returns a number that rises when a texture comes or goes.
  uint64_t changes() const { return store_.changes(); }
  /// Returns whether another look() with the same question would change nothing.
  bool is_settled() const { return is_fine_ && is_complete_; }
  /// Returns whether the last picture has each texel that one at rest needs.
  bool has_all() const { return is_settled() && !is_coarse_; }
  /// Returns what was given up since the last call.
  std::vector<GivenUpItem> take_given_up() { return requests_.failures().take_news(); }
  const SheetStore& store() const { return store_; }
  uint64_t version() const { return version_; }
  /// Returns what was asked for and has not come.
  std::vector<PageItem> in_flight() const { return requests_.in_flight(); }

 private:
  /// A page that the picture draws, as the directory has it.
  struct Want {
    PageId page = 0;
    uint32_t block = 0;
    SheetFacts facts;
    float needed = 0;   ///< texels per file unit
    float density = 0;  ///< that vertices' colours have; texels per file unit
  };
  struct Job {
    PageItem sheet;
    TexelSize size;
    float density = 0;
  };
  void list_wants(const SheetQuestion& question, const KnownPages& pages);
  float coarseness() const;
  void take_stock_of(const Want& want, float coarseness);
  void miss(PageItem item, uint32_t bytes, float excess);
  void hold(PageItem item, std::vector<uint8_t> bytes, Time now);

  KnownSheets sheets_;
  SheetStore store_;
  uint64_t version_;
  PageRequests requests_;
  std::vector<Want> wants_;
  std::vector<MissingItem> missing_;
  std::set<PageItem> wanted_;  // that the last picture misses, in flight or not
  std::vector<Job> held_;      // that wait to be decoded
  std::set<PageItem> decoding_;
  bool is_fine_ = false;      // the last picture asked for what one at rest needs
  bool is_complete_ = false;  // nothing was missing
  bool is_coarse_ = false;    // some was given up, or does not fit into memory
};

template <typename PageOf>
std::vector<EncodedTexture> SheetLoader::take_jobs(const PageOf& page_of) {
  std::vector<EncodedTexture> jobs;
  for (const Job& job : held_) {
    std::shared_ptr<const Page> page = page_of(job.sheet.number);
    const StoredSheets* stored = store_.find(job.sheet.number);
    if (page == nullptr || stored == nullptr || !decoding_.insert(job.sheet).second) continue;
    jobs.push_back(
        {job.sheet, std::move(page), stored->charts, stored->sheet, job.size, job.density});
  }
  held_.clear();
  return jobs;
}

}  // namespace burnish
