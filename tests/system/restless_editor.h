#pragma once

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "client/connection/session_link.h"
#include "tests/system/fetched_pages.h"

namespace burnish {

/// The session that a restless editor edits.
struct EditorPlace {
  std::string address;  ///< of the server
  std::string session;
  FetchedPages pages;  ///< it shows the root
  int depth = 0;
  std::vector<Vec3d> surface;  ///< points of the scan to paint on, file units
  double brush_radius = 0;     ///< file units
  bool has_bands = false;      ///< else it keeps edges: a session has one of them
};

/// An editor that sends edits of all kinds that are live, undoes and redoes without a pause, and
/// records each sent edit and its answer.
class RestlessEditor {
 public:
  RestlessEditor(const EditorPlace& place, const std::string& user, uint32_t seed);

  /// Sends one edit; the same seed gives the same edits.
  void edit();
  /// Takes the server's news.
  void listen();
  /// Takes news until every edit is acknowledged or refused. Returns false after the patience.
  bool wait_until_answered();

  /// Notes that the server is lost: is_back() now needs a new welcome and a frame after it.
  void lose_server();
  bool is_back() const { return welcomed_ && frames_ > frames_then_; }

  /// Returns the expected history of this author if the server recorded these edits in this order:
  /// ids of the entries in order, true for entries that are on.
  std::vector<std::pair<std::string, bool>> expected_entries(
      const std::vector<std::string>& recorded) const;

  /// Returns the answered edits that must have been refused: there was nothing to undo or redo.
  std::set<std::string> expected_refusals(const std::vector<std::string>& recorded) const;
  std::set<std::string> refused() const;

  size_t applied() const { return sent_.size() - refused_.size(); }
  const std::string& user() const { return user_; }

 private:
  struct Book;
  decltype(Edit::change) next_change();
  Stroke stroke(double value);
  Edit next_edit();
  void take_answer(const std::vector<std::string>& ids, std::set<std::string>& answered);
  bool is_certain(const std::string& edit_id) const;
  Book keep_book(const std::vector<std::string>& recorded) const;

  const EditorPlace place_;
  const std::string user_;
  std::mt19937 random_;
  Connection connection_;
  std::unique_ptr<SessionLink> link_;

  std::vector<Edit> sent_;
  std::set<std::string> acknowledged_, refused_;
  int losses_ = 0;  // losses of the server so far
  std::map<std::string, int> losses_when_sent_, losses_when_answered_;
  bool welcomed_ = false;
  uint64_t frames_ = 0, frames_then_ = 0;
};

}  // namespace burnish
