#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/edit/edit.h"
#include "common/edit/preview_change.h"

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
  settings.take(PreviewChange(SetTexture{{2, 0.5, 0.25}}));
  const Settings all = settings;
  EXPECT_EQ(all, (Settings{0.5,
                           TransferCurve(8),
                           {.cap = 2},
                           {{{0.5, 2}}},
                           {{{"letters", 0xd04040, TransferCurve(9)}}},
                           {.beta = 0.25},
                           {.strength = 0.5},
                           {2, 0.5, 0.25}}));
  for (const Change& change : {Change(Stroke{}), Change(Protect{}), Change(Undo{}),
                               Change(SetCheckpoint{"a"}), Change(RestoreCheckpoint{"a"})})
    settings.take(change);
  EXPECT_EQ(settings, all);
}

Settings changed_settings() {
  return {0.5,
          TransferCurve(8),
          {.cap = 2},
          {{{0.5, 2}}},
          {{{"letters", 0xd04040, TransferCurve(9)}}},
          {.beta = 0.25},
          {.strength = 0.5},
          {2, 0.5, 0.25}};
}

TEST(Settings, TheirChangesMakeThem) {
  const Settings wanted = changed_settings();
  Settings made;
  for (const Change& change : changes_that_make(wanted)) made.take(change);
  EXPECT_EQ(made, wanted);
}

TEST(Settings, EachHasATextWithAKeyOfItsOwn) {
  std::set<std::string> keys;
  const std::vector<SettingText> before = texts_of({}), after = texts_of(changed_settings());
  for (size_t i = 0; i < after.size(); ++i) {
    keys.insert(after[i].key);
    EXPECT_NE(after[i].text, before[i].text) << after[i].label;
  }
  EXPECT_EQ(keys.size(), changes_that_make({}).size());
}

TEST(Settings, AChangeOfOneHasTheEffectOfItsGesture) {
  const Settings before;
  EXPECT_FALSE(effects_between(before, before).any());
  for (const Change& change : changes_that_make(changed_settings())) {
    Settings after = before;
    after.take(change);
    const EditEffects effects = effects_between(before, after);
    EXPECT_TRUE(effects.any()) << change.index();
    if (const auto shown = preview_of(change)) {
      const EditEffects gesture = effects_of(*shown);
      EXPECT_EQ(gesture.metric, effects.metric) << change.index();
      EXPECT_EQ(gesture.beta, effects.beta) << change.index();
      EXPECT_EQ(gesture.shown, effects.shown) << change.index();
    }
  }
}

}  // namespace burnish
