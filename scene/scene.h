// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The mechanical problem: geometry, mesh, materials, supports, loads and contact pairs; reading and checking them.
/// Start with read_scene(), then build_mesh(), then fix_data(); the `Problem` that results is all that the two
/// formulations see.
namespace bracket::scene {

// ---- plain types ----------------------------------------------------------------------------------------------------

/// A point, displacement, force or traction, in the units of the scene.
template <int dim> using Vector = Eigen::Matrix<double, dim, 1>;
template <int dim> inline constexpr int n_voigt = dim * (dim + 1) / 2;
/// A stress (s11, s22, s12) or a strain (e11, e22, 2 e12).
template <int dim> using Voigt = Eigen::Matrix<double, n_voigt<dim>, 1>;
/// A stiffness (stress by strain) or a compliance (strain by stress) in the notation of `Voigt`.
template <int dim> using Elasticity = Eigen::Matrix<double, n_voigt<dim>, n_voigt<dim>>;
/// A given function of position.
template <int dim> using Function = std::function<double(const Vector<dim>&)>;

/// How a command ends; the values are the exit statuses of the program.
enum class Status { done = 0, internal = 1, input = 2, mesh = 3, ill_posed = 4, budget = 5, not_guaranteed = 6 };

/// Something that the user can mend. what() is one line: where (file, line, column if known), what is wrong, what was
/// expected.
class Error : public std::runtime_error {
 public:
  Error(Status status, const std::string& line) : std::runtime_error(line), status_(status) {}
  Status status() const { return status_; }

 private:
  Status status_;
};

// ---- the scene as its author wrote it -------------------------------------------------------------------------------

/// A built-in rectangle of cells[0] × cells[1] squares, each cut in two by the diagonal from its lower left.
/// Its boundary parts are "body.left", ".right", ".bottom" and ".top".
template <int dim> struct Block {
  std::string body;
  std::array<std::array<double, 2>, dim> range;  ///< {x from, to}, {y from, to}
  std::array<int, dim> cells;
  std::string where;  ///< "file:line:column", for messages; so below
};

/// An elastic material and its weight. Isotropic materials keep stiffness and compliance in closed form, neither is
/// computed as the inverse of the other, so that both stay accurate as ν → ½.
struct Isotropic {
  double young, poisson;
  bool plane_stress;
};
template <int dim> struct Body {
  std::optional<Isotropic> isotropic;  ///< what the matrices are made of
  Elasticity<dim> stiffness = Elasticity<dim>::Zero();
  Elasticity<dim> compliance = Elasticity<dim>::Zero();
  Vector<dim> force = Vector<dim>::Zero();  ///< body force per volume, constant
  std::string where;
};

enum class ConditionKind { fixed, sliding, traction, pressure };

/// What is prescribed on one boundary part. `value`: `dim` functions for fixed (displacement) and traction (force per
/// area), one for sliding (displacement along the outward normal) and pressure (traction −p n).
template <int dim> struct Condition {
  ConditionKind kind;
  std::vector<Function<dim>> value;
  std::string where;
};

/// A frictionless contact pair. The gap is measured along the outward normal of `first`, ≥ 0 open, < 0 interference.
template <int dim> struct ContactPair {
  std::string first;
  std::string second;  ///< a boundary part, or "rigid": a wall along `first`
  Function<dim> gap;
  std::string where;
};

struct Refine {
  std::string strategy = "none";
  double target = 0;  ///< relative error bound to reach; 0: none asked
  double bulk = 0.5;
  int max_levels = 30;
  int max_cells = 200000;
  double max_seconds = 600;
};

struct Solve {
  int degree = 2;  ///< of the displacements, 1 or 2
  std::string dual = "hybrid";  ///< or "uzawa"
};

template <int dim> struct Scene {
  std::string file;  ///< where it was read from; empty if built in code
  std::string title;
  std::string units;
  std::string plane = "strain";  ///< or "stress"
  std::vector<Block<dim>> blocks;
  std::filesystem::path mesh_file;  ///< empty: blocks
  std::string mesh_where;
  std::map<std::string, Body<dim>> bodies;
  std::map<std::string, Condition<dim>> boundary;
  std::vector<ContactPair<dim>> contact;
  Refine refine;
  Solve solve;
};

/// Isotropic stiffness and compliance, plane strain unless `plane_stress`.
/// \pre E > 0, −1 < ν < ½ (plane stress: −1 < ν ≤ ½)
template <int dim> Body<dim> isotropic(double young, double poisson, bool plane_stress);

/// Anisotropic: compliance is the inverse of `stiffness`.
/// \pre symmetric, positive definite
template <int dim> Body<dim> anisotropic(const Elasticity<dim>& stiffness);

/// Reads and checks a scene file (TOML). `overrides` are "key=value" lines that replace or add keys before checking.
/// \throw Error (input), with file, line and column and, for a misspelt key, the nearest known one
template <int dim>
Scene<dim> read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

// ---- the mesh -------------------------------------------------------------------------------------------------------

/// A conforming triangulation of all bodies; bodies share no vertices, each hangs together through edges.
template <int dim> struct Mesh {
  std::vector<Vector<dim>> vertices;
  std::vector<std::array<int, dim + 1>> cells;  ///< vertices, counter-clockwise
  std::vector<int> cell_body;                   ///< index into `bodies`
  std::vector<std::string> bodies;              ///< names
  std::vector<std::array<int, 2>> edges;        ///< vertices, the lower index first
  std::vector<std::array<int, 3>> cell_edges;   ///< edge k lies opposite to vertex k: from vertex k+1 to k+2 (mod 3)
  std::vector<char> refinement_edge;            ///< of each cell: the edge (0, 1 or 2) that bisection cuts first

  struct Facet {
    std::array<int, dim> vertices;  ///< in the order in which its cell is walked counter-clockwise: the body is left
    int cell;
    int local;  ///< which edge of the cell
    int edge;   ///< index into `edges`
    int part;   ///< index into `parts`, −1: none (such a facet is free)
  };
  std::vector<Facet> boundary;     ///< every edge that has a cell on one side only
  std::vector<std::string> parts;  ///< names of the boundary parts
  std::vector<std::string> notes;  ///< what was mended on reading, one line each
};

/// The scene's blocks as a mesh, or its mesh file read.
/// \throw Error (input: no such file; mesh: not usable)
template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene);

/// Reads a Gmsh ASCII file, version 2.2 or 4.1, of first-order triangles. Physical surfaces name the bodies, physical
/// curves the boundary parts. Clockwise cells are turned, with a note. Vertices of no cell are dropped.
/// \throw Error (input: no such file; mesh: truncated, binary, second order, 3D, empty, degenerate cells, …)
template <int dim> Mesh<dim> read_gmsh(const std::filesystem::path& file);

/// Counts and shape of a mesh. Angles in degrees.
struct Quality {
  double smallest_angle = 180;
  double largest_angle = 0;
  double smallest_area = 0;
  double largest_area = 0;
};
template <int dim> Quality quality(const Mesh<dim>& mesh);

template <int dim> double volume(const Mesh<dim>& mesh, int cell);       ///< area of a cell
template <int dim> double length(const Mesh<dim>& mesh, int facet);      ///< of a boundary facet
template <int dim> Vector<dim> normal(const Mesh<dim>& mesh, int facet); ///< unit outward normal of a boundary facet

// ---- the problem: data that both formulations carry exactly (design §1.2) -------------------------------------------

enum class Support {
  traction,  ///< Γ_τ: traction prescribed (zero: free)
  fixed,     ///< Γ_u: displacement prescribed
  sliding,   ///< Γ_0: normal displacement prescribed, no shear
  contact    ///< Γ_K
};

/// The data of one boundary facet, at its vertices, linear between.
template <int dim> struct FacetData {
  Support support = Support::traction;
  /// The direction of sliding, pressure and contact: the unit outward normal, one and the same to the last bit for all
  /// facets of the scene whose normals agree, up to sign, within 1e-6 rad (rounding of coordinates, not geometry; on a
  /// fine arc less, see scene/normals.h). So facets that meet continue each other where their normals are equal, and
  /// form a corner where they are not. The mesh's own normal() differs by that rounding; it belongs in Cauchy's λn.
  Vector<dim> normal = Vector<dim>::Zero();
  std::array<Vector<dim>, dim> traction = {Vector<dim>::Zero(), Vector<dim>::Zero()};
  std::array<Vector<dim>, dim> displacement = {Vector<dim>::Zero(), Vector<dim>::Zero()};
  std::array<double, dim> normal_displacement = {0, 0};  ///< along `normal`
};
/// Whether a traction is prescribed on the facet that is not zero.
template <int dim> bool is_loaded(const FacetData<dim>& data);

/// One facet of a contact pair and what it touches. The facets of a pair coincide; the second runs the other way, so
/// that vertex 0 of the first lies on vertex 1 of the second, with the same coordinates to the last bit.
struct ContactFacet {
  int pair;                   ///< index into Scene::contact
  int first;                  ///< index into Mesh::boundary; its FacetData::normal is d
  int second;                 ///< likewise, its normal is −d; −1: a rigid wall
  std::array<double, 3> gap;  ///< at the first facet's vertices 0 and 1 and at its midpoint; quadratic between
};

/// By how much fixing the data on the mesh moved the given functions: largest difference by largest value.
struct Oscillation {
  double traction = 0;
  double displacement = 0;
  double gap = 0;
};

/// A scene on a mesh. One fixed problem of which the two formulations compute bounds; refinement inherits it.
template <int dim> struct Problem {
  Mesh<dim> mesh;
  std::vector<Body<dim>> bodies;           ///< as Mesh::bodies
  std::vector<FacetData<dim>> facets;      ///< as Mesh::boundary
  std::vector<ContactFacet> contact;
  Oscillation oscillation;
  double length_scale = 1;  ///< diameter of the bounding box
};

/// Fixes the data of `scene` on `mesh`: tractions projected (L2) on linear functions per edge, displacements
/// interpolated linearly, gaps quadratically; matches the contact sides edge by edge; gives the facets of one straight
/// line one normal; where displacements are prescribed on both sides of a contact's vertex and close more than its gap
/// by rounding only (8 ε of their size, the gap's and the length scale), raises the gap to their approach.
/// \throw Error (input: unknown names, two conditions on one part, values that are not finite or out of
///        range, prescribed displacements that contradict each other at a vertex; mesh: sides that do not match)
template <int dim> Problem<dim> fix_data(const Scene<dim>& scene, Mesh<dim> mesh);

// ---- refinement -----------------------------------------------------------------------------------------------------

/// A problem on a refined mesh, and where its pieces come from.
template <int dim> struct Refined {
  Problem<dim> problem;
  std::vector<int> cell_parent;     ///< of each cell: index into the old Mesh::cells
  std::vector<int> contact_parent;  ///< of each contact facet: index into the old Problem::contact
};

/// Newest-vertex bisection: all three edges of a marked cell are halved (it falls into four), and of others as many as
/// keep the mesh conforming and the two sides of each contact matched. A cell is cut from the midpoint of its
/// refinement edge to the vertex opposite; a child's refinement edge is opposite to that midpoint, so that the
/// descendants of one coarse cell have at most four shapes. The problem stays the same: bodies, names and data are
/// inherited; linear data at a midpoint are the mean of the ends, a gap stays the same parabola. The order is that of
/// the parents, and vertices keep their numbers. Linear in the number of cells.
/// \pre `marked` has an entry for each cell; the mesh is from build_mesh(), read_gmsh() or refine()
/// \throw Error (budget) where cells have become so small that rounding of coordinates spoils their shape
template <int dim> Refined<dim> refine(const Problem<dim>& problem, const std::vector<char>& marked);

// ---- rigid motions --------------------------------------------------------------------------------------------------

/// An infinitesimal rigid motion: a translation and a rotation (radians, counter-clockwise) about `centre`.
template <int dim> struct RigidMotion {
  Vector<dim> translation;
  double rotation;
  Vector<dim> centre;
};
/// The displacement of the point x.
template <int dim> Vector<dim> displacement(const RigidMotion<dim>& motion, const Vector<dim>& x);

/// The rigid motions that the supports of a body leave free (0 … 3 of them), linearly independent, each moving some
/// point of the body by about 1 [HH81, R ∩ V].
template <int dim> std::vector<RigidMotion<dim>> free_motions(const Problem<dim>& problem, int body);

/// "moving it by (0, 1)" or "turning it clockwise about (2, 3)", for messages; coordinates at rounding level are 0.
/// \pre some point of the body is moved by about 1, as by free_motions()
template <int dim> std::string describe(const RigidMotion<dim>& motion);

}  // namespace bracket::scene
