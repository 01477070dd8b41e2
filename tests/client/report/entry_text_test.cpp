#include "client/report/entry_text.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

HistoryEntry stroke() {
  HistoryEntry entry;
  entry.summary = "stroke of 2 points, radius 0.00469196, beta 0";
  entry.name = "Smooth stroke";
  entry.details = "β 0";
  entry.radius = 0.00469196;
  return entry;
}

TEST(EntryText, GivesTheRadiusInTheScansUnit) {
  EXPECT_EQ(entry_name(stroke()), "Smooth stroke");
  EXPECT_EQ(entry_details(stroke(), "m"), "radius 0.00469 m, β 0");
  EXPECT_EQ(entry_details(stroke(), ""), "radius 0.00469, β 0");
}

TEST(EntryText, OfAnOlderServerIsTheSummary) {
  HistoryEntry entry;
  entry.summary = "beta 0.25";
  EXPECT_EQ(entry_name(entry), "beta 0.25");
  EXPECT_EQ(entry_details(entry, "mm"), "");
}

}  // namespace
}  // namespace burnish
