#include "tests/client/pages/page_flight.h"

#include <cmath>

#include <gtest/gtest.h>

#include "client/pages/drawn_ranges.h"
#include "tests/common/pages/legal_cut.h"

namespace burnish {

PageFlight::PageFlight(const SyntheticScan& scan, const PageFlightOptions& options)
    : scan_(scan),
      options_(options),
      loader_(scan.directory.head, options.budget, options.is_software),
      link_(scan, options.link),
      card_(options.budget.slots(), kNoPage) {}

void PageFlight::picture(const Camera& camera) {
  link_.deliver(loader_, now_);
  decode();
  PictureQuestion question;
  question.view = make_page_view(camera, kFlightPicture, scan_.directory.head.grid);
  question.surface_moves = surface_moves;
  question.frame_vertices_max = frame_vertices_max;
  question.server_vertices_max = server_vertices_max;
  question.moving_triangles_max = moving_triangles_max;
  question.rests_early = rests_early;
  question.has_values = has_values;
  question.link = options_.link.speed;
  loader_.look(question, now_);
  carry_out();
  check_cut();
  check_budgets();
  check_card();
  now_ += options_.picture_interval;
}

void PageFlight::decode() {
  int left = options_.decodes_per_picture;
  for (const PageId page : loader_.to_decode()) {
    if (left-- == 0) return;
    loader_.on_decoded(page, link_.decode(page, loader_.bytes_of(page)), now_);
  }
}

void PageFlight::carry_out() {
  link_.ask(loader_.requests(), now_);
  for (const PageUpload& upload : loader_.take_uploads()) card_.at(upload.slot) = upload.page;
  given_up_ += loader_.take_given_up().size();
}

void PageFlight::check_cut() {
  const ChosenCut& cut = loader_.cut();
  ASSERT_TRUE(is_legal_cut(scan_.directory, cut.set));
  const bool has_root = cut.set[scan_.directory.head.root()] != 0;
  ASSERT_TRUE(has_root || !had_root_) << "the root was there";
  had_root_ = has_root;
  if (has_root) {
    ASSERT_NEAR(scan_.drawn_area(cut.set), 1, 1e-9) << "a hole, or a surface twice";
  }
}

void PageFlight::check_budgets() {
  const ChosenCut& cut = loader_.cut();
  const bool is_more_than_root = cut.pages.size() > 1;
  if (is_more_than_root) {
    ASSERT_LE(cut.triangles, options_.budget.triangles);
  }
  uint64_t drawn = 0;
  for (const DrawnRange& range : drawn_ranges(cut, loader_.cache())) drawn += range.triangles;
  ASSERT_LE(drawn, cut.triangles);
  ASSERT_LE(loader_.cache().resident_bytes(), options_.budget.resident_bytes);
  ASSERT_LE(loader_.cache().slots().taken(), options_.budget.slots());
  if (loader_.in_flight().count_in_flight() > 1) {
    const double until_next = std::chrono::duration<double>(options_.picture_interval).count();
    ASSERT_LE(loader_.in_flight().bytes_in_flight(),
              bytes_in_flight_max(options_.link.speed, until_next));
  }
}

void PageFlight::check_card() {
  for (const DrawnRange& range : drawn_ranges(loader_.cut(), loader_.cache()))
    ASSERT_EQ(card_.at(range.slot), range.page);
}

double PageFlight::settle(const Camera& camera, double limit_seconds) {
  const auto begin = now_;
  do {
    picture(camera);
    const double seconds = std::chrono::duration<double>(now_ - begin).count();
    if (seconds > limit_seconds) ADD_FAILURE() << "not settled: " << status_text(loader_.status());
    if (seconds > limit_seconds || testing::Test::HasFatalFailure()) return seconds;
  } while (!loader_.is_settled());
  return std::chrono::duration<double>(now_ - begin).count();
}

void PageFlight::fly(const Camera& from, const Camera& to, int pictures) {
  for (int i = 1; i <= pictures && !testing::Test::HasFatalFailure(); ++i) {
    const double part = static_cast<double>(i) / pictures;
    Camera camera = from;
    camera.target = (1 - part) * from.target + part * to.target;
    camera.distance = std::pow(from.distance, 1 - part) * std::pow(to.distance, part);
    picture(camera);
  }
}

}  // namespace burnish
