#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/live/live_link.h"
#include "client/model/documents/measuring.h"
#include "client/model/documents/recorder.h"
#include "client/model/documents/scan_noise.h"
#include "client/model/documents/sheet_finder.h"
#include "client/model/tasks/message_log.h"
#include "client/model/tasks/tasks.h"
#include "client/scene/colour_ends.h"
#include "client/surface/paged_surface.h"
#include "client/tools/brush_tool.h"
#include "client/tools/curve_editor.h"
#include "client/tools/mirror_plane.h"
#include "client/tools/presets.h"
#include "client/tools/undo_steps.h"
#include "common/edit/edit.h"
#include "common/service/page_values.h"

namespace burnish {

/// Data fetched in the background before a session is shown.
struct OpenedDocument {
  std::string server;
  std::shared_ptr<Connection> connection;
  SessionInfo session;
  bool is_new = false;  ///< this opening made the session
  ScanDescription scan;
  OpenedPages pages;
  SessionState state;
  std::vector<HistoryEntry> history;
  std::string lacks;  ///< what it lacks of a session of another depth, in words; empty: nothing
};

/// The limits of a document's pictures, and its surroundings.
struct DocumentOptions {
  PageBudget budget;
  bool is_software = false;     ///< pictures are drawn without a graphics card
  std::filesystem::path pages;  ///< folder that keeps fetched pages; empty: none
  std::function<void()> wake;   ///< called from any thread when update() has something to do
  Clock clock = std::chrono::steady_clock::now;
};

/// A preset, and how much of it: above 0 to 1, or 0 while a drag passes it.
struct PresetInForce {
  Preset preset;
  double strength;
};

/// The rims of a scan, and how many of them are held while the controls pin rims.
struct RimCount {
  uint64_t rims = 0;
  uint64_t held = 0;
};

/// The quantity that colours the surface.
enum class ColourBy { kNothing, kBeta, kCurvature, kDisplacement, kScan };

/// An open session as its window sees it: the surface, the state, the people, and the edits that
/// the user makes. Never waits for the network. Used from one thread.
class Document {
 public:
  Document(OpenedDocument opened, Tasks& tasks, MessageLog& log, Recorder& recorder,
           DocumentOptions options);

  const SessionInfo& session() const { return opened_.session; }
  const ScanDescription& scan() const { return opened_.scan; }
  const OpenedDocument& opened() const { return opened_; }
  const PagedSurface& surface() const { return *surface_; }
  const Eigen::AlignedBox3d& box() const { return box_; }  ///< of the scan, file units
  double diagonal() const { return box_.diagonal().norm(); }
  double length_unit() const { return prepared().length_unit; }  ///< L, file units
  double cell_size() const { return prepared().cell_size; }      ///< file units
  int depth() const { return opened_.session.key.depth; }

  /// Empties the renderer for this surface. Call once, first. Fails: as the renderer does.
  Status open(PageRenderer& renderer);

  /// Handles news from the server. Call once per picture; `draws`: otherwise no picture follows.
  void update(bool draws = true);
  /// A picture of this document took so long, from its look() until the card had drawn it.
  /// `surface_ms`: of that, for the surface, where panels take as long as it does.
  void on_picture(double ms, std::optional<double> surface_ms);
  /// Brings what this picture needs to the renderer of open(). `is_unlit`: it shows colours without
  /// light. Fails: as the renderer does.
  Status look(const Camera& camera, const ImageSize& size, bool is_unlit = false);

  /// Shows a value that a drag passes; others see it too, where gestures show its kind.
  void preview(Change change);
  /// Makes the edit of a drag, or one without a drag.
  void commit(Change change);
  /// Makes the edit of a command: a stroke is mirrored, an undo takes a whole step back.
  void edit(Change change);
  /// The values of the session, as the user or the session set them last.
  const Settings& settings() const { return settings_; }
  // During a drag, preview the gradient scale and the curve; at its end, commit.
  double beta() const { return settings_.beta; }
  void preview_beta(double beta) { preview(SetGradientScale{beta}); }
  void commit_beta() { commit(SetGradientScale{beta()}); }
  CurveEditor& curve() { return curve_; }
  const CurveEditor& curve() const { return curve_; }
  void preview_curve() { preview(SetTransferCurve{curve_.curve()}); }
  void commit_curve() { commit(SetTransferCurve{curve_.curve()}); }
  /// Makes the gradient scale, the curve and the bands those of a preset, and keeps edges as it
  /// asks. If it follows the scan's noise, waits until the server has measured that.
  void apply(const Preset& preset, double strength = 1);
  bool waits_for_preset() const { return waiting_preset_.has_value(); }
  /// Has the server measure the noise, so that lengths() know it.
  void measure_noise() { noise_.ask(); }
  /// During a drag of the strength of the preset in force, preview; at its end, commit.
  void preview_strength(const Preset& preset, double strength);
  void commit_strength(const Preset& preset);
  /// Returns whether try_strength() shows all that a strength of this preset changes.
  static bool has_trial(const Preset& preset);
  /// Shows everybody what this strength of the preset in force would be, until end_trial() or until
  /// the user does something. The values stay. Needs: has_trial().
  void try_strength(const Preset& preset, double strength);
  void end_trial();
  bool is_trying() const { return !trial_.empty(); }
  /// Returns whether the newest frame shows the strength that is tried, and has settled.
  bool shows_trial() const;
  /// Returns whether the newest frame may show a strength that is tried, or was.
  bool may_show_trial() const { return is_trying() || is_trial_leaving_; }
  /// Returns the preset that the session's values are of: the one that was applied here last, or
  /// one of these or of presets() at full strength.
  std::optional<PresetInForce> preset_in_force(const std::vector<Preset>& own) const;
  /// Returns what the filter is now, for a preset of the user's own.
  PresetFilter filter() const { return {beta(), curve_.curve(), equaliser()}; }
  ScanLengths lengths() const;

  /// The bands and the palette, as the user or the session set them last. During a drag preview
  /// them; at its end, set them.
  const Equaliser& equaliser() const { return settings_.equaliser; }
  const Palette& palette() const { return settings_.palette; }

  /// How edges are kept, likewise. A drag shows strength and crispness at once, other values at
  /// its end.
  const EdgeFilter& edges() const { return settings_.edges; }
  /// Keeps edges as a preset does, and makes fidelity that of waves of kEdgeWaveEdges.
  void keep_edges(const EdgeFilter& preset);
  /// Keeps none, and takes back the fidelity that keep_edges() has set.
  void keep_no_edges();
  /// Has the server measure the scan's noise, and then keeps edges as it proposes. Changes nothing
  /// if there is no noise to speak of, or if the user sets other edges meanwhile.
  void keep_edges_by_noise();
  bool waits_for_noise() const {
    return waits_for_noise_ || paints_for_noise_ || waits_for_preset();
  }
  /// Returns whether edges are kept as the scan's noise asks, at any strength.
  bool keeps_edges_by_noise() const;
  const ScanNoise& noise() const { return noise_; }
  double mean_edge() const { return opened_.scan.scan.statistics.mean_edge_length; }

  /// How the scan's colours are filtered, likewise. Needs: has_colours().
  const ColourFilter& colour_filter() const { return settings_.colour; }
  /// The texture filter of the scan's colours, likewise.
  const TextureFilter& texture() const { return settings_.texture; }
  /// Returns whether this view shows the scan's pictures.
  bool has_pictures() const { return surface_->textures() != nullptr; }
  /// Returns whether the server levels the seams of pictures, for this view to show them.
  bool levels_seams() const { return finder_.is_finding() && finder_.seams()->amount > 0; }

  /// Bounds on what all edits do: as the user or the session set them last.
  const Controls& controls() const { return settings_.controls; }
  /// Returns how many rims stay; nothing while the controls let them move, or before it is told.
  std::optional<RimCount> rims() const { return controls().pin_rims ? rims_ : std::nullopt; }
  /// Changes the region in which nothing moves.
  void protect(Protect change) { send(std::move(change)); }
  bool is_closed() const { return opened_.scan.scan.statistics.is_closed(); }

  // Draw a stroke from point to point of the original surface.
  BrushTool& brush() { return brush_; }
  const BrushTool& brush() const { return brush_; }
  /// While there is a plane, each stroke is also painted on its other side.
  std::optional<MirrorPlane> mirror;
  // A pen's pressure is 0 to 1. A gesture is several strokes where the pressure changes. A stroke
  // of kept edges takes the filter that the scan's noise asks for, until somebody chooses one.
  void begin_stroke(BrushMode mode, const Vec3d& point, double pressure = 1);
  void extend_stroke(const Vec3d& point, double pressure = 1);
  void end_stroke();
  /// Paints a whole stroke.
  void paint(const Stroke& stroke);
  void cancel_stroke();
  void move_ring(const std::optional<BrushRing>& ring) { live_->move_brush(ring); }

  /// Undo and redo take all edits of a preset at once, and all strokes of a gesture.
  void undo();
  void redo();
  const UndoSteps& undo_steps() const { return undo_steps_; }
  void switch_entry(uint64_t number, bool on) { send(SwitchEntry{number, on}); }
  void set_checkpoint(const std::string& name) { send(SetCheckpoint{name}); }
  void restore_checkpoint(const std::string& name) { send(RestoreCheckpoint{name}); }
  void set_role(const std::string& user, SessionRole role);

  /// A scan with colours of its own shows them at first.
  void set_colour(ColourBy colour);
  bool has_colours() const { return opened_.scan.scan.has_colours; }
  ColourBy colour() const { return colour_; }
  /// Sets the ends of the colours of curvature, as parts of the histogram's range.
  void set_curvature_ends(const ColourEnds& ends) { curvature_ends_ = ends; }

  /// Shows the protected region, and the colours of the palette's curves where they rule. A stroke
  /// shows the region too.
  void show_over(bool protection, bool curves);

  Measuring& measuring() { return measuring_; }
  const Measuring& measuring() const { return measuring_; }
  /// Returns the state that measuring() follows.
  Measuring::Shown shown() const { return {edits_known_, is_settled()}; }
  /// Names the unit of the scan's coordinates for everybody.
  void name_unit(const std::string& unit);
  const std::string& unit() const { return opened_.scan.scan.unit; }

  const std::vector<HistoryEntry>& history() const { return history_; }
  /// Returns whether the history has every edit that is known here.
  bool has_newest_history() const {
    return unacknowledged_ == 0 && told_.edits >= edits_known_ && !history_fetch_->running;
  }
  const SessionPeople& people() const { return people_; }
  const Welcome& welcome() const { return welcome_; }
  const LinkStats& stats() const { return stats_; }
  LinkState link() const { return link_; }
  const std::string& link_reason() const { return link_reason_; }
  /// Returns whether the link was lost because another server has the session, and goes on there.
  bool is_moving() const { return is_moving_; }
  uint64_t edits_known() const { return edits_known_; }  ///< of the session, on disk
  size_t unacknowledged() const { return unacknowledged_; }
  uint64_t refusals() const { return refusals_; }            ///< of edits and previews, so far
  double shown_after_ms() const { return shown_after_ms_; }  ///< delay of our last edit; 0: none
  const ProgressReport& progress() const { return progress_; }
  bool is_viewer() const { return welcome_.role == SessionRole::kViewer; }

  /// Returns a number that rises when look() changes the picture.
  uint64_t picture_changes() const { return surface_->changes(); }

  /// Returns true if every edit is applied and shown, in the surface, the values and the history.
  bool is_settled() const;
  /// Returns true if the picture of the last look() is as fine as it will become.
  bool is_picture_fine() const;
  /// Returns true if it also shows the session's values, and no trial.
  bool is_picture_settled() const { return is_picture_fine() && !may_show_trial(); }
  /// Returns what the picture of the last look() lacks, in the words of mark_picture(); empty:
  /// nothing.
  std::string picture_lack() const;
  /// Returns true if the session has ended.
  bool has_ended() const { return link_ == LinkState::kEnded; }

 private:
  // Lies over the surface.
  struct Over {
    bool protection = false;
    bool curves = false;
    bool operator==(const Over&) const = default;
  };
  void send(Change change);
  void send_as(const std::string& id, Change change);
  void send_together(const std::vector<Edit>& edits);
  TransferCurve curve_for_edges() const;
  void commit_together(std::vector<Change> changes);
  void count_step(const Change& change);
  void send_stroke(const std::string& id, const Stroke& stroke);
  void tint_dab(const Brush& brush, const Vec3d& centre);

  const PreparedDescription& prepared() const { return *opened_.scan.prepared; }
  void handle(const LiveEvent& event);
  void follow_server();
  void show_begun_stroke();
  void show_new_points();
  void forget_strokes();
  void add_dabs(const std::vector<Vec3d>& points);
  void refresh_history();
  void take_rims(const SessionState& state);
  void take_noise();
  void apply_now(const Preset& preset, double strength);
  std::optional<EdgeFilter> filter_for_paint() const;
  bool has_textures() const { return has_colours() && surface_->texture_bytes_max() > 0; }
  SeamsOfSession seams_now() const;
  bool has_newest_seams() const { return !finder_.seams() || *finder_.seams() == seams_now(); }
  bool has_all_colours() const;
  SheetFinder::Describe describe_sheets() const;
  void find_textures();
  void take_textures(const Result<SheetsDescription>& found);
  void retry_textures();
  void renew_textures();
  void show_textures(const SheetsDescription& description);
  void renew_pages();
  Over over_now() const;
  void forget_over();
  void fetch_over();
  void take_over(const Over& over, const Result<std::vector<PageValues>>& held,
                 const Result<std::vector<PageValues>>& ruled);
  void forget_values();
  void fetch_values();
  void take_values(const Result<std::vector<PageValues>>& first,
                   const Result<std::vector<PageValues>>& second);

  OpenedDocument opened_;
  Eigen::AlignedBox3d box_;
  Tasks& tasks_;
  MessageLog& log_;
  Recorder& recorder_;

  Settings settings_;  // as the user or the session set them last
  CurveEditor curve_;
  TransferCurve curve_before_edges_{kAlphaDefault};
  std::optional<Preset> last_preset_;
  std::optional<RimCount> rims_;  // absent until a state with pinned rims has come
  BrushTool brush_;
  Vec3d last_dab_ = Vec3d::Zero();
  std::string gesture_;            // id of the edit of the running drag or stroke; else empty
  std::string trial_;              // id of the preview of try_strength(); else empty
  bool is_trial_leaving_ = false;  // frames may still show it
  bool shows_previews_ = true;     // as LiveNews has it, and nothing was previewed since
  UndoSteps undo_steps_;
  bool goes_on_ = false;             // the stroke continues the last step's gesture
  std::vector<std::string> tinted_;  // strokes that no frame shows yet

  ColourBy colour_ = ColourBy::kNothing;
  ColourEnds curvature_ends_, fetched_ends_;  // that are wanted, and those of the values
  bool is_renewing_pages_ = false;
  uint64_t values_version_ = 0;  // counts forget_values()
  bool is_fetching_values_ = false;
  std::set<PageId> fetched_;  // pages whose values of this version were asked for

  Over over_wish_;
  Over over_;  // fetched or being fetched
  uint64_t over_version_ = 0;
  bool is_fetching_over_ = false;
  std::set<PageId> fetched_over_;

  std::vector<HistoryEntry> history_;
  SessionPeople people_;
  Welcome welcome_;
  LinkStats stats_;
  LinkState link_ = LinkState::kConnecting;
  std::string link_reason_;
  bool is_moving_ = false;
  ProgressReport progress_;
  size_t unacknowledged_ = 0;
  uint64_t refusals_ = 0;
  uint64_t edits_known_ = 0;  // the session's edits on disk
  HistoryState told_;         // the newest values of the session
  bool is_told_taken_ = true;
  double shown_after_ms_ = 0;

  // Fetches run one at a time; `again` asks for one more.
  struct Fetch {
    bool running = false;
    bool again = false;
  };
  std::shared_ptr<Fetch> history_fetch_ = std::make_shared<Fetch>();
  Measuring measuring_;
  ScanNoise noise_;
  bool waits_for_noise_ = false;                 // the edges that it proposes will be kept
  std::optional<PresetInForce> waiting_preset_;  // it follows the noise, and will be applied
  bool paints_for_noise_ = false;  // a stroke of kept edges came before the noise was known
  SheetFinder finder_;
  bool has_no_textures_yet_ = false;  // the last finding failed
  bool renews_textures_ = false;      // the sheets are found again though they are the same
  int texture_renewals_left_ = 0;     // of the sheets that are shown
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // completions may outlive us
  std::unique_ptr<LiveLink> live_;                              // its thread calls the wake
  std::unique_ptr<PagedSurface> surface_;                       // last: it uses live_
};

}  // namespace burnish
