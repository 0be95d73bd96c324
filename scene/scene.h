// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/fields.h"
#include "scene/function.h"
#include "scene/options.h"
#include "scene/problem/problem.h"
#include "scene/problem/refine.h"
#include "scene/problem/rigid_motion.h"
#include "scene/quantity.h"

/// The mechanical problem: geometry, mesh, materials, supports, loads and contact pairs; reading and checking them.
/// Start with read_scene(), then build_mesh(), then fix_data(); the `Problem` that results is all that the two
/// formulations see.
namespace bracket::scene {

/// A built-in rectangle of cells[0] × cells[1] squares, each cut in two by the diagonal from its lower left, or, in
/// space, a box of cuboids, each cut in six along the diagonal from its lowest corner (Kuhn). Its boundary parts are
/// "body.left", ".right" along x, ".bottom" and ".top" along y, in space ".back" and ".front" along z: the front is
/// where z is larger. Blocks of one body share whole sides, cut alike; they are one piece, and parts of one name one
/// part.
template <int dim> struct Block {
  std::string body;
  std::array<std::array<double, 2>, dim> range;  ///< {x from, to}, {y from, to}
  std::array<int, dim> cells;
  std::string where = {};  ///< "file:line:column", for messages; so below
  std::string name = {};   ///< not empty: its parts are "body.name.left", …
};

/// Triangles or tetrahedra of one's own, in place of blocks and mesh files. They are treated as those of a file:
/// clockwise ones, or those that are inside out, are turned, vertices without a cell left out, bodies that share
/// vertices joined or, along the sides of a contact pair, separated.
template <int dim> struct GivenMesh {
  std::vector<Vector<dim>> vertices;
  std::vector<std::array<int, dim + 1>> cells;                          ///< places in `vertices`
  std::map<std::string, std::vector<int>> bodies;                       ///< places in `cells`; empty: one body, "body"
  std::map<std::string, std::vector<std::array<int, dim>>> parts = {};  ///< facets, by places in `vertices`
};

/// What is prescribed on one boundary part. `value`: `dim` functions for fixed (displacement) and traction (force per
/// area), one for sliding (displacement along the outward normal) and pressure (traction −p n).
template <int dim> struct Condition {
  ConditionKind kind;
  std::vector<Function<dim>> value;
  std::string where = {};
};

struct Circle {
  Vector<2> center = Vector<2>::Zero();
  double radius = 0;
};

/// Obstacles that do not move. Contact with them acts along one direction for each facet of the first mesh: against the
/// line's normal, or along the facet's own.
struct LineObstacle {
  Vector<2> point;
  Vector<2> normal;  ///< to the side of the bodies, of any length
};
struct CircleObstacle {
  Circle circle;
  bool inside = false;  ///< whether the bodies are in it
};
/// In space. Contact acts against its normal.
struct PlaneObstacle {
  Vector<3> point;
  Vector<3> normal;  ///< to the side of the bodies, of any length
};

/// One side of a contact: boundary parts, by name. As a second side also "rigid" alone, a wall along the first, or an
/// obstacle.
struct Side {
  std::vector<std::string> parts;
  std::variant<std::monostate, LineObstacle, CircleObstacle, PlaneObstacle> obstacle = {};

  Side() = default;
  Side(const char* part) : parts{part} {}
  Side(std::string part) : parts{std::move(part)} {}
  Side(std::vector<std::string> of) : parts(std::move(of)) {}
  Side(LineObstacle of) : obstacle(std::move(of)) {}
  Side(CircleObstacle of) : obstacle(std::move(of)) {}
  Side(PlaneObstacle of) : obstacle(std::move(of)) {}
};
bool is_rigid(const Side& side);
bool is_wall(const Side& side);  ///< "rigid" or an obstacle
bool contains(const Side& side, const std::string& part);
std::string name(const Side& side);  ///< "a", "a, b", "a rigid wall", "a line", "a circle", "a plane"

/// A contact pair. The sides need not be cut alike, coincide or be equally long: what does not face the
/// other side is free. The gap is measured from the first side to the second, ≥ 0 open, < 0 interference, and its
/// function taken at points of the first. One part as both sides is a crack.
template <int dim> struct ContactPair {
  Side first;
  Side second;
  std::optional<Function<dim>> gap;  ///< nothing: as drawn, between the sides or to the obstacle; none to a wall
  std::string where = {};
  std::string name = {};        ///< for quantities and reports; empty: its first part
  int zones = 0;                ///< stretches of it, equally long, whose forces are wanted as intervals; 0: none
  Law law = Law::frictionless;  ///< any but bonded, which is a Bond
  /// Of law: winkler: k > 0; tresca: g_T ≥ 0; linear on each facet of the first mesh; coulomb: μ ≥ 0, constant; else
  /// none.
  std::optional<Function<dim>> value = {};
  bool lifts_off = true;  ///< winkler, tresca: whether the sides may part; bilateral ones never do
  /// In place of a gap, of sides that keep together: the displacement of the first less that of the second at which
  /// they do. Bilateral ones keep what it is along the normal; friction resists what there is of slip beside it. A
  /// quadratic on each facet of the first mesh.
  std::optional<std::array<Function<dim>, dim>> jump = {};
};
/// Whether the sides keep together: r = g.
template <int dim> bool is_two_sided(const ContactPair<dim>& pair) {
  return pair.law == Law::bilateral || !pair.lifts_off;
}

/// Two sides that stick to each other, whatever pulls or shears: bodies that are one piece of several materials. They
/// coincide node by node, and build_mesh() joins them.
struct Bond {
  Side first;
  Side second;
  std::string where = {};
};

/// A boundary part that is an arc: vertices that refinement makes are put on it, and the data fixed anew on each mesh,
/// which then is a problem of its own.
struct Curve {
  std::optional<Circle> circle;  ///< nothing: the one through its vertices
  std::string where = {};
};

/// How the mesh is refined, and when a run ends.
struct Refine {
  Strategy strategy = Strategy::none;
  double target = 0;         ///< relative error bound to reach, ≥ 0; 0: none asked
  double bulk = 0.5;         ///< adaptive: the marked cells' share of the width, in (0, 1]
  int max_levels = 30;       ///< meshes, ≥ 1
  int max_cells = 200000;    ///< of a mesh that is solved on, but for the first; ≥ 1
  double max_seconds = 600;  ///< ≥ 1; asked after each level
  std::string goal = {};     ///< the quantity by whose width cells are marked; empty: the energy
  bool all_levels = false;   ///< quantities on all meshes; else on the last and on some of the coarser ones
};

struct Solve {
  int degree = 2;                  ///< of the displacements, 1 to 4; stresses have one less, at least 1
  Dual dual = Dual::hybrid;        ///< in space local, the only one there
  std::optional<int> sweeps = {};  ///< of local stresses, 1 to 100; nothing: sweeps_for() the mesh's common_flatness()
};
template <int dim> Solve default_solve() { return {2, dim == 2 ? Dual::hybrid : Dual::local}; }

/// The degree of displacements that comes to a target at about the least cost, at most 1.3 times that of the best one
/// in what was measured (docs/performance.md). \param target relative error bound; 0: none asked   \param cells of the
/// first mesh: a fine one costs a high degree
///     more than it gains
int degree_for(double target, double cells);
/// How often local stresses are swept where nothing says it: where cells are flat each sweep does less. After so many
/// plates of cells up to 10 : 1 had intervals at most 1.25 times as wide as with the stresses of least S
/// (docs/theory.md §12.5).
int sweeps_for(double flatness);
/// Cells that are flatter need more than one.
inline constexpr double flat = 5;

/// The bulk (see Refine) that does so for a degree.
double bulk_for(int degree);

template <int dim> struct Scene {
  std::string file;  ///< where it was read from; empty if built in code
  std::string title;
  std::string units;
  Plane plane = Plane::strain;
  std::vector<Block<dim>> blocks;
  std::filesystem::path mesh_file;      ///< empty: blocks, or
  std::optional<GivenMesh<dim>> given;  ///< a mesh in code
  std::string mesh_where;
  double merge = 0;  ///< of a mesh file or a given one: nodes as close, a length, become one; 0: none
  std::map<std::string, Body<dim>> bodies;
  std::map<std::string, Condition<dim>> boundary;
  std::map<std::string, Curve> curves;  ///< by boundary part
  std::vector<ContactPair<dim>> contact;
  std::vector<Bond> bonds;
  std::vector<Quantity<dim>> quantities;
  Refine refine;
  Solve solve = default_solve<dim>();
};

/// Reads and checks a scene file (TOML). `overrides` are "key=value" lines that replace or add keys before checking.
/// \throw Error (input), with file, line and column and, for a misspelt key, the nearest known one
template <int dim>
Scene<dim> read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// 2 or 3: as a scene file says by `dim`, else as its mesh file does, which has tetrahedra or has none; 2 where neither
/// tells. \throw Error (input) as read_scene() for what is no scene file, or another dim
int dimension_of(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// Of a mesh file: 3 if it has tetrahedra. \throw Error as read_mesh()
int dimension_of_mesh(const std::filesystem::path& file);

/// Checks all that can be said of a scene without its mesh: that it has blocks, a mesh file or a given one, and one
/// block for each body; that materials are made for its plane; as many functions as each condition needs; contact pairs
/// of two parts, each in one pair and without a condition; that settings are within the limits of Refine and Solve;
/// that numbers are finite and of a size within those of scene/range.h. build_mesh(), fix_data() and what calls them
/// begin with it, so that nothing goes on with a scene that is not as it should be. \throw Error (input), one line for
/// the first fault
template <int dim> void check(const Scene<dim>& scene);
/// The part of it that concerns the settings alone.
template <int dim = 2> void check_settings(const Refine& refine, const Solve& solve);
/// \throw Error (input) unless displacements of this degree are known: 1 to 4
void check_degree(int degree);

/// How many cells a block is cut into.
template <int dim> double cells_of(const Block<dim>& block) {
  double cells = dim == 2 ? 2 : 6;
  for (const int along : block.cells) cells *= along;
  return cells;
}
/// How many cells the blocks, the mesh file or the given mesh have, but for cuts along contact sides; infinite where
/// the file cannot be read, which build_mesh() then tells.
template <int dim> double cells_of(const Scene<dim>& scene);
/// Whether some contact has Coulomb's friction.
template <int dim> bool has_coulomb(const Scene<dim>& scene);

/// Reads a mesh file: Gmsh, Abaqus or what else libgmsh reads (docs/meshes.md). What it names bodies and boundary parts
/// and what is mended on reading is told in docs/scene-file.md.
/// \throw Error (input: no such file; mesh: truncated, not plane, empty, degenerate cells, …)
template <int dim> Mesh<dim> read_mesh(const std::filesystem::path& file);

/// The scene's blocks as a mesh, its mesh file read, or its given mesh, with the sides of bonds joined. Names that the
/// scene has data for have precedence over others of the same cells or lines; bodies that share nodes are separated
/// along the lines of contact pairs.
/// \throw Error (input: as check(), no such file; mesh: not usable, names that contradict each other)
template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene);

/// Fixes the data of `scene` on `mesh`: tractions projected (L2) on linear functions per edge, displacements
/// interpolated linearly, gaps enclosed between quadratics; cuts the contact sides alike (scene/problem/cutting.h);
/// gives the facets of one straight line one normal; where displacements are prescribed on both sides of a contact's
/// vertex and close more than its gap by rounding only (8 ε of their size, the gap's and the length scale), raises the
/// gap to that.
/// \param mesh that of the scene, or another whose bodies and parts have its names; then the scene needs none
/// \throw Error (input: as check(), unknown names, values that are not finite or out of range, prescribed
///        displacements that contradict each other at a vertex; mesh: sides that do not face each other)
template <int dim> Problem<dim> fix_data(const Scene<dim>& scene, Mesh<dim> mesh);

}  // namespace bracket::scene
