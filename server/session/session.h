#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/mesh/textures/texel_change.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/prepared_mesh.h"
#include "server/session/colour_change.h"
#include "server/session/edited_fields.h"
#include "server/session/previews.h"
#include "server/solver/solver.h"

namespace burnish {

/// A session is settled at this estimated distance. It is well below the bar of 1e-4
/// (docs/solver.md, "How exact"), because the estimate is not a bound.
inline constexpr double kSettledDistance = 3e-5;

/// The end of a solve: after a fixed number of cycles, or when the estimated distance to the
/// converged surface is below a bar.
struct SolveOptions {
  /// To the bar of exports (docs/solver.md), and from the scan itself: the same edits on the same
  /// scan give the same bits, whatever the session showed before. Else to that of settled sessions.
  bool exact = false;
  int cycles = 0;  ///< > 0: exactly this many
};

/// The moves of vertices beside the displacement of their corners, while edges are kept.
struct VertexLayer {
  std::span<const Vec3f> moves;  ///< one per vertex of the scan, cells; empty: none moves
  double cap = 0;                ///< cells; bounds a vertex's whole move; 0: none

  bool is_there() const { return !moves.empty() || cap > 0; }
};

/// One editing state of a prepared mesh: edits in, fields, solver, surface out. Not thread-safe:
/// its owner serialises calls.
class Session {
 public:
  /// `initial` counts until an edit sets others. Fails: failed_precondition (no such backend
  /// here); resource_exhausted (not enough memory); as `room` says.
  static Result<std::unique_ptr<Session>> open(const Multigrid& on, const SolverOptions& options,
                                               const Controls& initial = {},
                                               const Solver::RoomOnProcessors& room = {});
  ~Session();

  /// Takes edits in, all of a batch or none. The next step shows them to the solver once, as new
  /// matrices or only as a new constraint.
  EditedFields& edited();
  const EditedFields& edited() const;

  /// Applies one edit without an author.
  Status apply(const Edit& edit);

  /// The gestures that are shown before they become edits.
  Previews& previews();

  /// Returns whether there are edits or previews that the solver has not seen.
  bool is_changed() const;

  /// Brings the system up to date with the edits and the previews.
  void update();

  /// Does update() if needed, and one cycle: of the solver, or of a band once the solver has
  /// settled. Once only the filter of kept edges is missing, waits for it for some milliseconds.
  /// Returns the solver's last report.
  StepReport step();

  /// Returns a number that rises when the surface may have changed otherwise than by a cycle of the
  /// solver.
  uint64_t surface_revision() const;

  /// Returns the first failure of what solves. After it the surface has no meaning.
  Status status() const;

  /// Returns whether a surface is at the bar of settled sessions, or as near as this solver comes.
  /// Then nothing is left to do until something changes.
  bool is_settled(const StepReport& last) const;

  /// Returns whether it is even at the bar of exports.
  bool is_exact(const StepReport& last) const;

  /// Solves, without the previews, until the end in `options`. Fails: cancelled.
  Result<SolveReport> solve(const SolveOptions& options, const Progress& progress = {});

  /// Returns the displacement of every corner that is shown, with controls and previews, valid
  /// until the next call. Units: cells.
  std::span<const Vec3f> displacement();

  /// Returns whether corners alone do not say where vertices are: layer() does.
  bool has_layer() const;

  /// Returns what vertices do beside a displacement, valid until the next call. Once settled it
  /// leaves out the triangles that exports leave out.
  VertexLayer layer(std::span<const Vec3f> displacement);

  /// Returns the volume of the last displacement() or surface() over the scan's; nothing unless the
  /// controls keep it. While the surface moves it may be some frames old.
  std::optional<double> kept_volume() const;

  /// Returns the change of colour, valid until the next call. Units: linear light, 0 to 1.
  ColourChange colour_change() const;

  /// Returns the present surface: same triangles, moved vertices, filtered colours.
  TriangleMesh surface();
  /// Returns what the texels at the vertices of surface() do. Shapes: one per vertex; empty: none
  /// changes.
  std::vector<TexelChange> texels() const;
  /// Returns how much of the seams of the scan's pictures is levelled by the edits that are in the
  /// fields: nothing of what is protected.
  SeamLevelling seams() const;

  const PreparedMesh& prepared() const;
  const Fields& fields() const { return edited().fields(); }
  /// Returns the fields with the previews, as the last update() saw them.
  const Fields& shown_fields() const;
  const Solver& solver() const;
  uint64_t byte_count() const;  ///< of this session alone

 private:
  std::vector<Vec3d> moved_vertices();  // of the edits, without the previews
  std::vector<Vec3d> evaluated_vertices();
  Status solve_bands(const Progress& progress);
  Status solve_colour(const Progress& progress);

  struct State;
  explicit Session(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
