#include "server/manager/presence.h"

#include <set>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Presence, ShowsWhoIsThereAndWhereTheirBrushIs) {
  Presence presence;
  const uint64_t ann = presence.join("ann");
  const uint64_t bob = presence.join("bob");
  const BrushRing ring{Vec3d(1, 2, 3), 0.5};
  presence.move_brush(bob, ring);
  ASSERT_EQ(presence.list().size(), 2u);
  EXPECT_EQ(presence.list()[0].user, "ann");
  EXPECT_FALSE(presence.list()[0].ring);
  EXPECT_EQ(presence.list()[1].ring, ring);
  presence.leave(ann);
  ASSERT_EQ(presence.list().size(), 1u);
  EXPECT_EQ(presence.list()[0].user, "bob");
}

TEST(Presence, ColoursAreToldApartAsLongAsThereAreAny) {
  Presence presence;
  std::set<uint32_t> colours;
  for (int i = 0; i < 7; ++i) presence.join("user");
  for (const PresentUser& user : presence.list()) colours.insert(user.colour);
  EXPECT_EQ(colours.size(), 7u);
  presence.join("eighth");
}

TEST(Presence, TheVersionGrowsWithChangesOnly) {
  Presence presence;
  const uint64_t ann = presence.join("ann");
  const uint64_t version = presence.version();
  presence.move_brush(ann, std::nullopt);
  presence.leave(ann + 1);
  EXPECT_EQ(presence.version(), version);
  presence.leave(ann);
  EXPECT_GT(presence.version(), version);
}

}  // namespace
}  // namespace burnish
