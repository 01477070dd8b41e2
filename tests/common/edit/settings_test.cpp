#include "common/edit/settings.h"

#include <gtest/gtest.h>

namespace burnish {

TEST(Settings, TheLastEditOfAKindCountsAndStrokesSetNothing) {
  Settings settings;
  settings.take(Change(SetGradientScale{0.25}));
  settings.take(Change(SetGradientScale{0.5}));
  settings.take(PreviewChange(SetTransferCurve{TransferCurve(8)}));
  settings.take(Change(SetControls{{.cap = 2}}));
  settings.take(Change(SetEqualiser{{{{0.5, 2}}}}));
  settings.take(Change(SetPalette{{{{"letters", 0xd04040, TransferCurve(9)}}}}));
  settings.take(PreviewChange(SetColour{{.beta = 0.25}}));
  settings.take(Change(SetEdges{{.strength = 0.5}}));
  const Settings all = settings;
  EXPECT_EQ(all, (Settings{0.5,
                           TransferCurve(8),
                           {.cap = 2},
                           {{{0.5, 2}}},
                           {{{"letters", 0xd04040, TransferCurve(9)}}},
                           {.beta = 0.25},
                           {.strength = 0.5}}));
  for (const Change& change : {Change(Stroke{}), Change(Protect{}), Change(Undo{}),
                               Change(SetCheckpoint{"a"}), Change(RestoreCheckpoint{"a"})})
    settings.take(change);
  EXPECT_EQ(settings, all);
}

}  // namespace burnish
