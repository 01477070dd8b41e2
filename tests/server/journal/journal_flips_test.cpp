// Single bits of a closed journal flip. Each later read must return what was written, or report
// damage. BURNISH_FLIPS=20000 tries more bits than the default.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "common/wire/edit_bytes.h"
#include "server/journal/sqlite_journal.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

constexpr int kSessions = 3;
constexpr uint64_t kFlippedEdits = 100;

std::string id_of(int session) {
  return "0123456789abcde" + std::string(1, static_cast<char>('0' + session));
}

AuthoredEdit edit_of(uint64_t number) {
  Edit edit{"edit-" + std::to_string(number), SetGradientScale{0.001 * double(number)}};
  if (number % 3 == 0)
    edit.change =
        Stroke{{1, 1, 2, FallOff::kSmooth}, {Vec3d(1, 2, 3), Vec3d(4, 5, double(number))}};
  if (number % 7 == 0) edit.change = Undo{};
  return {number % 2 ? "ann" : "bob", 1'700'000'000'000 + static_cast<int64_t>(number), edit};
}

void write_journal(const std::filesystem::path& path) {
  const auto journal = std::move(SqliteJournal::open(path)).value();
  for (int session = 0; session < kSessions; ++session)
    ASSERT_TRUE(journal
                    ->create_session({id_of(session),
                                      "session-" + std::to_string(session),
                                      std::string(64, 'a'),
                                      {7, 0.5},
                                      1234,
                                      {},
                                      false,
                                      "ann"},
                                     SessionRoles::of_new_session("ann"))
                    .is_ok());
  for (uint64_t number = 1; number <= kFlippedEdits; ++number)
    for (int session = 0; session < kSessions; ++session)
      ASSERT_TRUE(journal->append(id_of(session), number, {edit_of(number)}).is_on_disk());
}

/// Everything that an opener of the journal learns.
struct Told {
  bool of_damage = false;
  std::map<std::string, std::string> values;
};

void read_session(Journal& journal, const SessionRecord& record, Told& told) {
  told.of_damage |= record.is_damaged || !record.maker;  // each session in the test has one
  told.values[record.id] = record.name + record.scan_id + std::to_string(record.key.depth) +
                           std::to_string(record.key.curvature_radius) +
                           std::to_string(record.created_unix_seconds) +
                           std::to_string(record.controls.pin_rims) + record.maker.value_or("");
  const auto edits = journal.edits(record.id);
  const auto roles = journal.roles(record.id);
  told.of_damage |= !edits.is_ok() || !roles.is_ok();
  if (told.of_damage) return;
  for (const AuthoredEdit& edit : *edits) {
    told.of_damage |= kind_of(edit.edit) == EditKind::kDamaged;
    told.values[record.id] +=
        "\n" + edit.author + std::to_string(edit.unix_ms) + edit_to_bytes(edit.edit);
  }
  // Nobody in the test is a viewer, so this role stands for a damaged one.
  for (const auto& [user, role] : roles->by_user()) {
    told.of_damage |= role == SessionRole::kViewer;
    told.values[record.id] += "\n" + user + session_role_name(role);
  }
}

Told read_journal(const std::filesystem::path& path) {
  Told told;
  const auto journal = SqliteJournal::open(path);
  if (!journal.is_ok()) return {true, {}};
  const auto sessions = journal.value()->sessions();
  if (!sessions.is_ok()) return {true, {}};
  for (const SessionRecord& record : *sessions) read_session(**journal, record, told);
  return told;
}

TEST(JournalFlips, AFlippedBitIsHarmlessOrTold) {
  const char* wanted = std::getenv("BURNISH_FLIPS");
  const int flips = wanted ? std::atoi(wanted) : 100;
  const auto level = spdlog::get_level();
  spdlog::set_level(spdlog::level::off);
  const TemporaryFolder folder;
  write_journal(folder / "good.sqlite");
  const std::string good = content_of(folder / "good.sqlite");
  const Told before = read_journal(folder / "good.sqlite");
  ASSERT_FALSE(before.of_damage);

  std::mt19937 random(1);
  int told = 0, wrong = 0;
  for (int i = 0; i < flips; ++i) {
    std::string bad = good;
    const size_t at = random() % bad.size();
    bad[at] = static_cast<char>(bad[at] ^ (1 << (random() % 8)));
    const TemporaryFolder trial;
    const Told after = read_journal(trial.write("bad.sqlite", bad));
    told += after.of_damage ? 1 : 0;
    if (after.of_damage || after.values == before.values) continue;
    ++wrong;
    std::cout << "byte " << at << " of " << bad.size() << " was changed without a word\n";
  }
  std::cout << flips << " flips: " << told << " told, " << flips - told - wrong << " harmless, "
            << wrong << " wrong\n";
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(told, flips / 10);
  spdlog::set_level(level);
}

}  // namespace
}  // namespace burnish
