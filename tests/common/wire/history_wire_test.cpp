#include "common/wire/history_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

/// A page of an entry of each kind that entries have.
HistoryPage page_of_all_kinds() {
  HistoryPage page;
  for (size_t i = 0; i < std::variant_size_v<Change>; ++i) {
    const auto kind = static_cast<EditKind>(i);
    if (makes_fields(kind) || kind == EditKind::kSetCheckpoint || kind == EditKind::kDamaged)
      page.entries.push_back(
          {i + 1, "id", "ann", 123, kind, "what", false, "name", "details", 0.5});
  }
  return page;
}

TEST(HistoryWire, APageComesBackUnchanged) {
  HistoryPage page = page_of_all_kinds();
  page.complete = false;
  const HistoryPage back = from_wire(to_wire(page)).value();
  EXPECT_FALSE(back.complete);
  ASSERT_EQ(back.entries.size(), 13u);
  for (size_t i = 0; i < back.entries.size(); ++i) {
    EXPECT_EQ(back.entries[i].number, page.entries[i].number);
    EXPECT_EQ(back.entries[i].kind, page.entries[i].kind);
    EXPECT_EQ(back.entries[i].author, "ann");
    EXPECT_FALSE(back.entries[i].enabled);
    EXPECT_EQ(back.entries[i].summary, "what");
    EXPECT_EQ(back.entries[i].name, "name");
    EXPECT_EQ(back.entries[i].details, "details");
    EXPECT_EQ(back.entries[i].radius, 0.5);
  }
}

TEST(HistoryWire, OlderClientsGetTheKindsThatTheyKnow) {
  const v1::GetHistoryResponse message = to_wire(page_of_all_kinds());
  for (const v1::HistoryEntry& entry : message.entries()) {
    EXPECT_GE(entry.kind(), v1::ENTRY_KIND_GRADIENT_SCALE);
    EXPECT_LE(entry.kind(), v1::ENTRY_KIND_DAMAGED);
  }
}

TEST(HistoryWire, EntriesOfOlderAndNewerServersAreUnderstood) {
  v1::GetHistoryResponse message;
  message.add_entries()->set_kind(v1::ENTRY_KIND_STROKE);
  EXPECT_EQ(from_wire(message).value().entries[0].kind, EditKind::kStroke);
  message.mutable_entries(0)->set_kind(v1::ENTRY_KIND_CELL_FIELDS);
  message.mutable_entries(0)->set_exact_kind(static_cast<v1::EntryKind>(99));
  EXPECT_EQ(from_wire(message).value().entries[0].kind, EditKind::kCellFields);
}

TEST(HistoryWire, APageAboveTheLimitIsRefused) {
  v1::GetHistoryRequest message;
  EXPECT_EQ(from_wire(message).value().count, kHistoryPageEntriesMax);
  message.set_count(1001);
  EXPECT_THAT(from_wire(message).status().message(), HasSubstr("limit of 1000"));
}

TEST(HistoryWire, AForkEndsAtANumberOrACheckpoint) {
  EXPECT_EQ(from_wire(to_wire(ForkWish{"s", "n", 7, ""})).value().number, 7u);
  EXPECT_EQ(from_wire(to_wire(ForkWish{"s", "n", 0, "c"})).value().checkpoint, "c");
  EXPECT_EQ(from_wire(to_wire(ForkWish{"s", "n", 0, "", 7})).value().depth, 7);
  v1::ForkSessionRequest message;
  message.set_depth(kDepthMax + 1);
  EXPECT_THAT(from_wire(message).status().message(), HasSubstr("depth 13"));
  message.set_depth(0);
  message.set_number(0);
  EXPECT_THAT(from_wire(message).status().message(), HasSubstr("numbered from 1"));
}

TEST(HistoryWire, PeopleComeBackUnchanged) {
  const SessionPeople people{
      SessionRoles({{"", SessionRole::kViewer}, {"ann", SessionRole::kOwner}}),
      {{3, "ann", 0xE69F00, BrushRing{Vec3d(1, 2, 3), 0.5}}, {4, "bob", 0x56B4E9, {}}}};
  const SessionPeople back = from_wire(to_wire(people)).value();
  EXPECT_EQ(back.roles.by_user(), people.roles.by_user());
  EXPECT_EQ(back.present, people.present);
}

TEST(HistoryWire, UnknownRolesAndRingsWithoutARadiusAreRefused) {
  EXPECT_FALSE(from_wire(v1::ROLE_UNSPECIFIED).is_ok());
  EXPECT_FALSE(from_wire(static_cast<v1::Role>(4)).is_ok());
  v1::BrushRing ring;
  EXPECT_FALSE(from_wire(ring).is_ok());
  ring.set_radius(1);
  EXPECT_TRUE(from_wire(ring).is_ok());
}

}  // namespace
}  // namespace burnish
