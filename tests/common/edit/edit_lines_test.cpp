#include "common/edit/edit_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/text_lines.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<std::string> words_behind(const std::string& line) {
  const auto lines = split_lines(line);
  return {lines.at(0).words.begin() + 1, lines.at(0).words.end()};
}

Result<Change> change_of(const std::string& line, const Settings& now = {}) {
  return parse_edit(split_lines(line).at(0).words[0], words_behind(line), now);
}

TEST(EditLines, EachKindThatAScriptSaysComesBackFromItsLine) {
  const char* const lines[] = {"beta 0.5",
                               "curve -1:5,2:50",
                               "stroke 2 0.5 0 linear band:1 through 1 2 3 4 5 6",
                               "controls on 0.25 off",
                               "protect curvature -1 20",
                               "bands 2:1.5 8:0",
                               "palette 0:5 ff0000 hard",
                               "colours 0.5 20",
                               "edges edges 0.5 20 3 0.25",
                               "texture 2 0.5 0.25",
                               "undo",
                               "redo",
                               "switch 3 on",
                               "checkpoint first draft",
                               "restore first draft"};
  for (const char* const line : lines) {
    const auto change = change_of(line);
    ASSERT_TRUE(change.is_ok()) << line << ": " << change.status().to_string();
    EXPECT_EQ(line_of(*change), line);
  }
  EXPECT_EQ(edit_commands().size(), std::size(lines));
}

TEST(EditLines, CellsAndDamagedEditsHaveNone) {
  EXPECT_EQ(line_of(SetCellFields{}), "");
  EXPECT_EQ(line_of(Damaged{"torn"}), "");
}

TEST(EditLines, WhatAColourLineLeavesOutStays) {
  Settings now;
  now.colour.alpha = 33;
  EXPECT_EQ(line_of(*change_of("colours 0.5", now)), "colours 0.5 33");
  now.texture = {1, 0.5, 1};
  EXPECT_EQ(line_of(*change_of("texture 2", now)), "texture 2 0.5 1");
  EXPECT_EQ(line_of(*change_of("texture 2 0", now)), "texture 2 0 1");
}

TEST(EditLines, AWholeLineIsAnEditOfTheScanOrSaysWhichAre) {
  EXPECT_EQ(line_of(*parse_edit_line("  beta   0.5 ", {})), "beta 0.5");
  for (const char* const line : {"", "undo", "cells 1"})
    EXPECT_THAT(parse_edit_line(line, {}).status().message(),
                HasSubstr("is no edit of a scan: it is one of beta, curve, stroke, controls"))
        << line;
}

TEST(EditLines, AWrongValueIsNamedWithItsLimit) {
  const auto message = [](const std::string& line) { return change_of(line).status().message(); };
  EXPECT_THAT(message("beta 11"), HasSubstr("11"));
  EXPECT_THAT(message("beta 1 2"), HasSubstr("2 words after 'beta'; write beta VALUE"));
  EXPECT_THAT(message("switch -1 on"), HasSubstr("numbered from 1"));
  EXPECT_THAT(message("controls on 0 maybe"), HasSubstr("'maybe' is neither on nor off"));
  EXPECT_THAT(message("edges off 1"), HasSubstr("STRENGTH"));
  EXPECT_THAT(message("stroke 1 1 0 smooth 1 2 3 4"), HasSubstr("three numbers"));
  EXPECT_THAT(message("cells 1"), HasSubstr("'cells' changes no session"));
}

}  // namespace
}  // namespace burnish
