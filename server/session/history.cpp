#include "server/session/history.h"

#include <algorithm>

#include "server/fields/paint_checkpoints.h"

namespace burnish {

// Ids are printable: they cannot contain a line break.
static std::string id_key(const std::string& author, const std::string& edit_id) {
  return edit_id + '\n' + author;
}

static bool can_be_switched(const History::Entry& entry) {
  return kind_of(entry.made_by->edit) != EditKind::kSetCheckpoint;
}

namespace {

constexpr uint64_t kBytesOfAnyEdit = 640;  // the edit itself, its step, entry, id and their nodes

/// The bytes of a change beyond its own struct.
struct BytesBeside {
  uint64_t operator()(const SetTransferCurve& change) const {
    return change.curve.points().size() * (sizeof(TransferCurve::Point) + sizeof(double));
  }
  uint64_t operator()(const Stroke& change) const { return change.path.capacity() * sizeof(Vec3d); }
  uint64_t operator()(const SetCellFields& change) const {
    return change.cells.capacity() * sizeof(SetCellFields::Cell);
  }
  uint64_t operator()(const Protect& change) const {
    const auto* lasso = std::get_if<LassoRegion>(&change.way);
    return lasso ? lasso->polygon.capacity() * sizeof(Eigen::Vector2d) : 0;
  }
  uint64_t operator()(const SetCheckpoint& change) const { return 2 * change.name.size(); }
  uint64_t operator()(const RestoreCheckpoint& change) const { return change.name.size(); }
  template <typename Change>
  uint64_t operator()(const Change&) const {
    return 0;
  }
};

}  // namespace

uint64_t bytes_in_history(const AuthoredEdit& edit) {
  return kBytesOfAnyEdit + 3 * (edit.author.size() + edit.edit.id.size()) +
         std::visit(BytesBeside{}, edit.edit.change);
}

uint64_t History::byte_count(const Step& step) {
  return bytes_in_history(*step.edit) +
         (step.switched.size() + step.not_redoable.size()) * sizeof(uint64_t);
}

bool History::knows(const std::string& author, const std::string& edit_id) const {
  return ids_.contains(id_key(author, edit_id));
}

Result<uint64_t> History::apply(AuthoredEdit edit) {
  RETURN_IF_ERROR(check_switch(edit.edit));
  return enter({std::make_shared<const AuthoredEdit>(std::move(edit)), {}, {}});
}

Status History::check_switch(const Edit& edit) const {
  const auto* change = std::get_if<SwitchEntry>(&edit.change);
  const Entry* entry = change ? find(change->entry) : nullptr;
  if (!entry || !entry->is_damaged() || !change->enabled) return Status::ok();
  return invalid_argument("entry " + std::to_string(change->entry) + " is damaged and stays off");
}

bool History::restore(AuthoredEdit edit) {
  const bool is_damaged = kind_of(edit.edit) == EditKind::kDamaged;
  const auto shared = std::make_shared<const AuthoredEdit>(std::move(edit));
  if (enter({shared, {}, {}}).is_ok()) return !is_damaged;
  ids_.insert(id_key(shared->author, shared->edit.id));
  steps_.push_back({shared, {}, {}});
  return false;
}

Result<uint64_t> History::enter(Step step) {
  ASSIGN_OR_RETURN(const uint64_t number,
                   std::visit([&](const auto& change) { return apply_change(change, step); },
                              step.edit->edit.change));
  ids_.insert(id_key(step.edit->author, step.edit->edit.id));
  byte_count_ += byte_count(step);
  steps_.push_back(std::move(step));
  return number;
}

void History::take_back() {
  const Step step = std::move(steps_.back());
  steps_.pop_back();
  byte_count_ -= byte_count(step);
  const AuthoredEdit& edit = *step.edit;
  Author& author = authors_[edit.author];
  if (kind_of(edit.edit) == EditKind::kUndo && !step.switched.empty()) author.undone.pop_back();
  author.undone.insert(author.undone.end(), step.not_redoable.begin(), step.not_redoable.end());
  for (const uint64_t number : step.switched) toggle(number);
  if (const auto* change = std::get_if<SetCheckpoint>(&edit.edit.change))
    checkpoints_[change->name].pop_back();
  if (!entries_.empty() && entries_.back().made_by == step.edit) {
    author.enabled.erase(entries_.back().number);
    entries_.pop_back();
  }
  ids_.erase(id_key(edit.author, edit.edit.id));
}

Result<uint64_t> History::checkpoint(const std::string& name) const {
  const auto found = checkpoints_.find(name);
  if (found == checkpoints_.end() || found->second.empty())
    return not_found("no checkpoint has the name '" + name + "'");
  return found->second.back();
}

/// Returns the hash of what the change paints; 0 if it paints nothing.
static uint64_t paint_hash(const Change& change) {
  if (!painted_layer(change)) return 0;
  const auto* stroke = std::get_if<Stroke>(&change);
  return stroke ? hash_of(*stroke) : hash_of(std::get<SetCellFields>(change));
}

uint64_t History::add_entry(Step& step) {
  const uint64_t number = size() + 1;
  entries_.push_back({number, step.edit, true, paint_hash(step.edit->edit.change)});
  Author& author = authors_[step.edit->author];
  author.enabled.insert(number);
  step.not_redoable = std::exchange(author.undone, {});
  return number;
}

Result<uint64_t> History::apply_change(const Undo&, Step& step) {
  Author& author = authors_[step.edit->author];
  if (author.enabled.empty()) return failed_precondition("you have no edit to undo");
  step.switched = {*author.enabled.rbegin()};
  author.undone.push_back(step.switched.front());
  toggle(step.switched.front());
  return step.switched.front();
}

Result<uint64_t> History::apply_change(const Redo&, Step& step) {
  std::vector<uint64_t>& undone = authors_[step.edit->author].undone;
  // Somebody may have switched an undone entry on again.
  const auto last = std::find_if(undone.rbegin(), undone.rend(),
                                 [&](uint64_t number) { return !find(number)->enabled; });
  if (last == undone.rend()) return failed_precondition("you have no edit to redo");
  const auto first_dropped = last.base() - 1;
  step.switched = {*first_dropped};
  step.not_redoable.assign(first_dropped, undone.end());
  undone.erase(first_dropped, undone.end());
  toggle(step.switched.front());
  return step.switched.front();
}

Result<uint64_t> History::apply_change(const SwitchEntry& change, Step& step) {
  const Entry* entry = find(change.entry);
  if (!entry) return not_found("the history has no entry " + std::to_string(change.entry));
  if (!can_be_switched(*entry))
    return invalid_argument("entry " + std::to_string(change.entry) +
                            " is a checkpoint, which is always on");
  if (entry->enabled == change.enabled) return change.entry;
  step.switched = {change.entry};
  toggle(change.entry);
  return change.entry;
}

Result<uint64_t> History::apply_change(const SetCheckpoint& change, Step& step) {
  entries_.push_back({size() + 1, step.edit, true});
  checkpoints_[change.name].push_back(size() + 1);
  return size() + 1;
}

Result<uint64_t> History::apply_change(const RestoreCheckpoint& change, Step& step) {
  ASSIGN_OR_RETURN(const uint64_t then, checkpoint(change.name));
  // An entry differs from then if it is new or was switched an odd number of times.
  std::set<uint64_t> differ;
  for (size_t i = then; i < steps_.size(); ++i)
    for (const uint64_t number : steps_[i].switched)
      if (number < then && !differ.insert(number).second) differ.erase(number);
  for (auto entry = entries_.rbegin(); entry != entries_.rend() && entry->number > then; ++entry)
    if (entry->enabled && can_be_switched(*entry)) differ.insert(entry->number);
  step.switched.assign(differ.begin(), differ.end());
  for (const uint64_t number : step.switched) toggle(number);
  return uint64_t{0};
}

void History::toggle(uint64_t number) {
  Entry& entry = entries_[static_cast<size_t>(find(number) - entries_.data())];
  entry.enabled = !entry.enabled;
  std::set<uint64_t>& enabled = authors_[entry.made_by->author].enabled;
  if (entry.enabled) {
    enabled.insert(number);
  } else {
    enabled.erase(number);
  }
}

const History::Entry* History::find(uint64_t number) const {
  const auto found =
      std::lower_bound(entries_.begin(), entries_.end(), number,
                       [](const Entry& entry, uint64_t n) { return entry.number < n; });
  return found == entries_.end() || found->number != number ? nullptr : &*found;
}

}  // namespace burnish
