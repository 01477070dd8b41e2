#include "tests/server/live/simulator.h"

#include <algorithm>
#include <future>

#include "common/grid/morton.h"
#include "server/journal/sqlite_journal.h"

namespace burnish {

namespace fs = std::filesystem;

/// Returns a folder in memory if there is one: a killed process loses none of its files, and
/// thousands of commits need not wait for a disk.
static fs::path quick_folder() {
  return fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path();
}

Simulator::Simulator(TestLibrary& library, const ScanInfo& scan, uint64_t seed)
    : library_(library), scan_(scan), random_(seed), folder_(quick_folder()) {
  const PreparedKey key = {scan.default_depth, 0};
  mesh_ = library.store->open_mesh(scan.id, key, {}).value();
  start_server(folder_ / "journal0.sqlite");
  is_calm_ = chance(0.5);
  const size_t count = 1 + pick(4);
  for (size_t i = 0; i < count; ++i) users_.push_back({"user" + std::to_string(i)});
  const auto opened = manager_->open({scan.id, session_, key}, users_[0].name, {});
  BURNISH_CHECK(opened.is_ok(), opened.status().message());
}

void Simulator::start_server(const fs::path& journal) {
  manager_.reset();
  journal_.reset();
  journal_path_ = journal;
  journal_ = std::move(SqliteJournal::open(journal)).value();
  SessionManagerOptions options;
  options.kept.sessions_max = 1000;
  options.solver = {BackendKind::kCpu, Smoother::kSchwarz, 1};
  manager_ =
      std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
          .value();
}

void Simulator::run() {
  const size_t steps = 20 + pick(is_calm_ ? 300 : 80);
  for (size_t i = 0; i < steps && !testing::Test::HasFailure(); ++i) {
    step();
    if (chance(0.05)) compare();
  }
  compare();
}

void Simulator::step() {
  const size_t user = pick(users_.size());
  const size_t what = pick(is_calm_ && !chance(0.2) ? 80 : 100);
  if (what < 45) return draw_edits(user);
  if (what < 80) return deliver();
  if (what < 85) return network_.clear();
  if (what < 89) return reconnect(user);
  if (what < 91) {
    users_[user].present = !users_[user].present;
    return reconnect(user);
  }
  if (what < 93) return change_role();
  if (what < 95) return fork();
  if (what < 97) return crash();
  ++counts_.spills;
  manager_->spill_idle(std::chrono::seconds(0));
}

void Simulator::draw_edits(size_t user) {
  User& author = users_[user];
  std::vector<Edit> edits;
  for (size_t n = chance(0.3) ? 1 + pick(6) : 1; n > 0; --n)
    edits.push_back({std::to_string(++author.last_id), draw_change()});
  author.unacknowledged.push_back(edits);
  if (author.present) send(user, edits);
}

decltype(Edit::change) Simulator::draw_change() {
  const PreparedMesh& mesh = *mesh_->prepared;
  const auto any_number = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  };
  const auto any_checkpoint = [&] { return std::string(1, char('a' + pick(3))); };
  switch (pick(18)) {
    case 0:
    case 1:
      return SetGradientScale{any_number(0, 3)};
    case 2:
      return SetTransferCurve{TransferCurve(any_number(1, 200))};
    case 3: {
      const MortonKey cell = mesh.cells[pick(mesh.cells.size())];
      return SetCellFields{{{morton_point(cell), any_number(1, 9), any_number(1, 9), 0.5}}};
    }
    case 4:
    case 5:
    case 6:
      return Undo{};
    case 7:
    case 8:
      return Redo{};
    case 9:
      return SwitchEntry{1 + pick(serial_.edits().size() + 2), chance(0.5)};
    case 10:
      return SetCheckpoint{any_checkpoint()};
    case 11:
      return RestoreCheckpoint{any_checkpoint()};
    default: {
      Stroke stroke{{any_number(0.1, 0.8), any_number(0.1, 1), any_number(0, 3),
                     static_cast<FallOff>(pick(4))},
                    {}};
      for (size_t n = 1 + pick(3); n > 0; --n)
        stroke.path.push_back(mesh.vertices[pick(mesh.vertices.size())]);
      return stroke;
    }
  }
}

void Simulator::reconnect(size_t user) {
  std::erase_if(network_, [&](const Message& message) { return message.user == user; });
  if (!users_[user].present) return;
  for (const auto& edits : users_[user].unacknowledged) send(user, edits);
}

void Simulator::deliver() {
  if (network_.empty()) return;
  const size_t which = pick(network_.size());  // in any order
  const Message message = network_[which];
  if (!chance(0.1)) network_.erase(network_.begin() + static_cast<std::ptrdiff_t>(which));
  receive(message);
}

void Simulator::receive(const Message& message) {
  const User& user = users_[message.user];
  std::vector<AuthoredEdit> fresh;
  for (const Edit& edit : message.edits) {
    const auto same = [&](const AuthoredEdit& other) {
      return other.author == user.name && other.edit.id == edit.id;
    };
    if (std::none_of(serial_.edits().begin(), serial_.edits().end(), same))
      fresh.push_back({user.name, 0, edit});
  }
  SerialReplay longer = serial_;
  const bool possible = !user.is_viewer && longer.apply(fresh);

  if (possible && chance(0.05)) {  // killed before the disk's answer
    EXPECT_TRUE(
        manager_->submit(session_, user.name, message.edits, {}, [](const Status&) {}).is_ok());
    serial_ = longer;
    return crash();
  }
  const auto outcome = manager_->apply(session_, user.name, message.edits, {});
  ASSERT_EQ(outcome.is_ok(), possible) << outcome.status().message();
  if (!possible) {
    ++counts_.refused;
    return acknowledge(message.user, message.edits);  // sending it again does not help
  }
  EXPECT_EQ(outcome.value().applied, fresh.size());
  counts_.edits += fresh.size();
  counts_.known += outcome.value().known;
  serial_ = std::move(longer);
  acknowledged_ = serial_.edits().size();
  if (!chance(0.1)) acknowledge(message.user, message.edits);  // else the answer was lost
}

void Simulator::acknowledge(size_t user, const std::vector<Edit>& edits) {
  std::erase_if(users_[user].unacknowledged, [&](const std::vector<Edit>& batch) {
    return batch.front().id == edits.front().id;
  });
}

// A killed process leaves its files as they are at that moment.
void Simulator::crash() {
  ++counts_.crashes;
  const fs::path left = folder_ / ("journal" + std::to_string(counts_.crashes) + ".sqlite");
  fs::copy_file(journal_path_, left);
  const auto log = [](const fs::path& path) { return path.string() + "-wal"; };
  if (fs::exists(log(journal_path_))) fs::copy_file(log(journal_path_), log(left));
  start_server(left);
  network_.clear();
  adopt_what_survived();
  for (size_t user = 0; user < users_.size(); ++user) reconnect(user);
}

void Simulator::adopt_what_survived() {
  std::string id;
  for (const SessionInfo& session : manager_->list())
    if (session.name == session_) id = session.id;
  const auto edits = journal_->edits(id);
  ASSERT_TRUE(edits.is_ok()) << edits.status().message();
  const std::vector<AuthoredEdit>& had = serial_.edits();
  ASSERT_GE(edits.value().size(), acknowledged_) << "an acknowledged edit is lost";
  ASSERT_LE(edits.value().size(), had.size());
  for (size_t i = 0; i < edits.value().size(); ++i) {
    ASSERT_EQ(edits.value()[i].author, had[i].author);
    ASSERT_EQ(edits.value()[i].edit.id, had[i].edit.id);
  }
  counts_.lost += had.size() - edits.value().size();
  SerialReplay survived;
  ASSERT_TRUE(survived.apply({had.begin(), had.begin() + std::ptrdiff_t(edits.value().size())}));
  serial_ = std::move(survived);
}

// Everybody continues in the fork.
void Simulator::fork() {
  const std::vector<AuthoredEdit>& edits = serial_.edits();
  if (edits.empty()) return;
  const size_t end = 1 + pick(edits.size());
  const std::string name = "fork" + std::to_string(++counts_.forks);
  const auto forked = manager_->fork({session_, name, end, ""}, users_[0].name, {});
  ASSERT_TRUE(forked.is_ok()) << forked.status().message();
  EXPECT_EQ(forked.value().session.edits, end);
  compare();  // the source is unchanged
  SerialReplay shorter;
  ASSERT_TRUE(shorter.apply({edits.begin(), edits.begin() + static_cast<std::ptrdiff_t>(end)}));
  serial_ = std::move(shorter);
  acknowledged_ = end;
  session_ = name;
  for (User& user : users_) user.is_viewer = false;
  compare();
}

void Simulator::change_role() {
  if (users_.size() == 1) return;
  User& user = users_[1 + pick(users_.size() - 1)];
  user.is_viewer = !user.is_viewer;
  const SessionRole role = user.is_viewer ? SessionRole::kViewer : SessionRole::kEditor;
  EXPECT_TRUE(manager_->set_role(session_, users_[0].name, user.name, role, {}).is_ok());
}

void Simulator::compare() {
  const auto expected = serial_.items();
  const auto cells = SerialReplay::cells(expected, *mesh_->prepared);
  const auto compare_with = [&](Session& session) {
    const auto& entries = session.edited().history().entries();
    EXPECT_EQ(entries.size(), expected.size());
    for (size_t i = 0; i < std::min(entries.size(), expected.size()); ++i) {
      EXPECT_EQ(entries[i].number, expected[i].number);
      EXPECT_EQ(entries[i].made_by->author, expected[i].author);
      EXPECT_EQ(entries[i].enabled, expected[i].on) << "entry " << entries[i].number;
    }
    EXPECT_EQ(cells.alphas, session.fields().alphas());
    EXPECT_TRUE(std::ranges::equal(cells.beta, session.fields().view().beta));
    return Status::ok();
  };
  EXPECT_TRUE(manager_->visit(session_, {}, compare_with).is_ok());
}

}  // namespace burnish
