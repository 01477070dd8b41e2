// What a picture's cut costs: from the known directory to the list of what is drawn, on synthetic
// directories, at several distances. One core.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "client/pages/drawn_ranges.h"
#include "client/pages/page_loader.h"
#include "tests/bench/timing.h"
#include "tests/client/pages/synthetic_scan.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;

constexpr int kRepeats = 101;
constexpr double kDistances[] = {8, 3, 1, 0.3, 0.1, 0.03, 0.01};

/// Hands in everything that the picture asks for, at once.
void load_all(PageLoader& loader, const SyntheticScan& scan, const PictureQuestion& question) {
  const PageLoader::Time now = {};
  for (int picture = 0; picture < 1000 && !loader.is_settled(); ++picture) {
    loader.look(question, now);
    for (const PageItem item : loader.requests().ask) {
      if (item.kind == PageItem::Kind::kBlock)
        loader.on_block(item.number, scan.block(item.number), now);
      else
        loader.on_page(item.number, std::vector<uint8_t>(scan.directory.entries[item.number].bytes),
                       now);
    }
    for (const PageId page : loader.to_decode()) loader.on_decoded(page, scan.page(page), now);
    loader.take_uploads();
  }
}

ordered_json measure(const SyntheticScan& scan, double distance) {
  PageLoader loader(scan.directory.head, {}, false);
  for (uint32_t block = 0; block < loader.known().block_count(); ++block)
    loader.on_block(block, scan.block(block), {});
  PictureQuestion question;
  question.link = {1e9, 1};
  question.view =
      make_page_view(camera_over(0.5, 0.5, distance), kFlightPicture, scan.directory.head.grid);
  load_all(loader, scan, question);
  const double look = median_milliseconds(kRepeats, 5, [&] { loader.look(question, {}); });
  size_t ranges = 0;
  const double draw = median_milliseconds(
      kRepeats, 5, [&] { ranges = drawn_ranges(loader.cut(), loader.cache()).size(); });
  const uint32_t known = scan.directory.head.page_count();
  std::printf(
      "%8u pages known%8.2f away%7zu in the cut%10lu triangles%8zu ranges%8.3f ms look"
      "%8.3f ms list\n",
      known, distance, loader.cut().pages.size(),
      static_cast<unsigned long>(loader.cut().triangles), ranges, look, draw);
  return {{"known_pages", known},
          {"distance", distance},
          {"cut_pages", loader.cut().pages.size()},
          {"triangles", loader.cut().triangles},
          {"ranges", ranges},
          {"look_ms", look},
          {"list_ms", draw}};
}

int main_of(const std::vector<std::string>& arguments) {
  if (!arguments.empty() && (arguments.size() != 2 || arguments[0] != "--json")) {
    std::cerr << "usage: page_cut_bench [--json FILE]\n";
    return 2;
  }
  ordered_json report;
  for (const int side : {16, 32, 64, 128}) {
    const SyntheticScan scan = make_synthetic_scan({.side = side, .triangles_per_page = 3000});
    for (const double distance : kDistances) report["cuts"].push_back(measure(scan, distance));
  }
  if (!arguments.empty()) std::ofstream(arguments[1]) << report.dump(2) << "\n";
  return 0;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(std::vector<std::string>(argv + 1, argv + argc));
}
