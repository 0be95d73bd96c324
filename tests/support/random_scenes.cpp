// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "scene/mesh/topology.h"
#include "tests/support/random_grid.h"

namespace bracket::tests {
namespace {

using scene::ConditionKind;

/// c + a·(x − x0) + b (t·(x − x0))²
struct Polynomial {
  double c = 0;
  Vector<2> a = Vector<2>::Zero();
  double b = 0;
  Vector<2> t = Vector<2>::Zero();
  Vector<2> x0 = Vector<2>::Zero();

  auto operator()(const auto& x) const {
    const auto dx = x[0] - x0[0], dy = x[1] - x0[1];
    const auto s = t[0] * dx + t[1] * dy;
    return c + a[0] * dx + a[1] * dy + b * s * s;
  }
  std::string text() const {
    std::string result = fmt::format("{}", c);
    if (!a.isZero(0)) result += fmt::format(" + ({}, {}).(x - x0)", a[0], a[1]);
    if (b != 0) result += fmt::format(" + {} (({}, {}).(x - x0))^2", b, t[0], t[1]);
    return a.isZero(0) && b == 0 ? result : result + fmt::format(", x0 = ({}, {})", x0[0], x0[1]);
  }
};

struct Made {
  scene::Body<2> body;
  std::string text;
};

Made random_body(Random& random, double young, scene::Plane plane) {
  if (random.chance(0.15)) {
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) root(i, j) = i == j ? random.uniform(0.2, 1.5) : random.uniform(-0.5, 0.5);
    const Eigen::Matrix3d product = young * root * root.transpose();
    const scene::Elasticity<2> stiffness = (product + product.transpose()) / 2;
    std::string text = "stiffness";
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) text += fmt::format(" {}", stiffness(i, j));
    return {scene::anisotropic<2>(stiffness), text};
  }
  if (random.chance(0.5)) young *= random.pick<double>({1, 1, 1e-3, 1e3, 1e-8, 1e8});
  const double poisson = random.pick<double>({0, 0, 0.3, 0.3, 0.49, 0.4999, -0.5, 0.2});
  return {scene::isotropic<2>(young, poisson, plane), fmt::format("E = {}, nu = {}", young, poisson)};
}

/// The scene while it is being made.
struct Making {
  Random random;
  Grid grid;
  double size, load;
  RandomScene made;
  Vector<2> carried = Vector<2>::Zero();  ///< by which everything that is prescribed is moved, walls too

  void say(const std::string& line) { made.text += line + "\n"; }
};

void add_bodies(Making& making, double young) {
  scene::Scene<2>& scene = making.made.scene;
  for (std::size_t i = 0; i < making.grid.taken.size(); ++i)
    for (std::size_t j = 0; j < making.grid.taken[i].size(); ++j) {
      if (!making.grid.taken[i][j]) continue;
      const std::string name = making.grid.body(static_cast<int>(i), static_cast<int>(j));
      const auto& [x, y] = making.grid.lines;
      scene.blocks.push_back(
          {name, {{{x[i], x[i + 1]}, {y[j], y[j + 1]}}}, {making.grid.cells[0][i], making.grid.cells[1][j]}, ""});
      Made made = random_body(making.random, young, scene.plane);
      if (making.random.chance(0.2))
        made.body.force = Vector<2>(making.random.pick<double>({0, 0.1, -0.1}), -1) * (making.load / making.size);
      making.say(fmt::format("{}: [{}, {}] x [{}, {}], cells {} {}; {}, force {} {}", name, x[i], x[i + 1], y[j],
                             y[j + 1], making.grid.cells[0][i], making.grid.cells[1][j], made.text, made.body.force[0],
                             made.body.force[1]));
      scene.bodies.emplace(name, std::move(made.body));
    }
}

std::string part_name(const Grid& grid, int i, int j, const Side& side) { return grid.body(i, j) + "." + side.name; }

Polynomial random_gap(Making& making, const Vector<2>& from, const Vector<2>& to) {
  const double size = making.size;
  const Vector<2> along = (to - from) / (to - from).norm();
  Polynomial gap;
  gap.x0 = from;
  switch (making.random.pick<int>({0, 0, 0, 1, 2, 3, 4, 5})) {
    case 1: gap.c = 1e-3 * size; break;
    case 2: gap.c = -1e-4 * size; break;
    case 3: gap.a = 1e-3 * along; break;
    case 4: gap.b = 1e-3 / size, gap.t = along; break;
    case 5: gap.a = -1e-3 * (to - from).norm() / size * along, gap.b = 1e-3 / size, gap.t = along; break;
    default: break;
  }
  return gap;
}

void add_contact(Making& making, const std::string& first, const std::string& second, const Polynomial& gap) {
  making.say(fmt::format("contact {} on {}, gap {}", first, second, gap.text()));
  making.made.scene.contact.push_back({first, second, scene::enclosed<2>(gap), ""});
}

void add_condition(Making& making, const std::string& part, ConditionKind kind, const std::vector<Polynomial>& value) {
  static const std::array<const char*, 4> names = {"fixed", "sliding", "traction", "pressure"};
  std::string line = fmt::format("{}: {}", part, names[static_cast<int>(kind)]);
  scene::Condition<2> condition{kind, {}, ""};
  for (const Polynomial& p : value) {
    line += fmt::format(" [{}]", p.text());
    condition.value.push_back(scene::enclosed<2>(p));
  }
  making.say(line);
  making.made.scene.boundary.emplace(part, std::move(condition));
}

/// A load on a side with the outward normal n.
void add_load(Making& making, const std::string& part, const Vector<2>& from, const Vector<2>& n) {
  Random& random = making.random;
  Polynomial p, q;
  p.x0 = from;
  switch (random.pick<int>({0, 1, 2, 3})) {
    case 0: p.c = making.load * random.uniform(0, 1); break;
    case 1:
      p.c = making.load;
      p.a = Vector<2>(-n[1], n[0]) * (random.uniform(-1, 1) * making.load / making.size);
      break;
    case 2: p.c = -0.1 * making.load * random.uniform(0, 1); break;
    default: {
      const double shear = random.pick<double>({0, 0, 0.3}) * making.load * random.uniform(-1, 1);
      const double pressure = making.load * random.uniform(0, 1);
      p.c = -pressure * n[0] - shear * n[1];
      q.c = -pressure * n[1] + shear * n[0];
      add_condition(making, part, ConditionKind::traction, {p, q});
      return;
    }
  }
  add_condition(making, part, ConditionKind::pressure, {p});
}

/// A side that no other body touches. \param field what is prescribed of the displacement, if it is
void add_outer_side(Making& making, int i, int j, const Side& side, const std::array<Polynomial, 2>& field, bool held) {
  Random& random = making.random;
  const std::string part = part_name(making.grid, i, j, side);
  const auto at = [&](int k) { return making.grid.corner(i + side.corners[k][0], j + side.corners[k][1]); };
  const Vector<2> from = at(0), to = at(1), along = (to - from) / (to - from).norm(), n(along[1], -along[0]);
  const bool base = side.name == "bottom" || side.name == "left";
  const double support = base ? 0.35 : 0.12;
  const double r = random.uniform(0, held ? support : 1);
  if (r < support * 0.4) {
    add_condition(making, part, ConditionKind::fixed, {field[0], field[1]});
  } else if (r < support * 0.7) {
    Polynomial normal = field[0];
    normal.c = n[0] * field[0].c + n[1] * field[1].c;
    normal.a = n[0] * field[0].a + n[1] * field[1].a;
    add_condition(making, part, ConditionKind::sliding, {normal});
  } else if (r < support) {
    Polynomial gap;
    gap.c = making.size * random.pick<double>({0, 0, 1e-3, -1e-4}) + n.dot(making.carried);
    add_contact(making, part, "rigid", gap);
  } else if (r < support + 0.3) {
    add_load(making, part, from, n);
  }
}

void add_boundary(Making& making) {
  const bool held = making.random.chance(0.8);  // at the lower and left sides of the grid
  const Grid& grid = making.grid;
  for (int i = 0; i < static_cast<int>(grid.taken.size()); ++i)
    for (int j = 0; j < static_cast<int>(grid.taken[i].size()); ++j) {
      if (!grid.has(i, j)) continue;
      std::array<Polynomial, 2> field;
      const bool moved = making.random.chance(0.3);
      for (Polynomial& u : field) {
        u.x0 = grid.corner(i, j);
        if (!moved) continue;
        const double scale = making.random.pick<double>({0, 0, 1e-3, -1e-3});
        u.c = scale * making.random.uniform(0, 1) * making.size;
        u.a[0] = scale * making.random.uniform(0, 1);
        u.a[1] = scale * making.random.uniform(0, 1);
      }
      for (int c = 0; c < 2; ++c) field[c].c += making.carried[c];
      for (const Side& side : sides) {
        const int di = i + side.step[0], dj = j + side.step[1];
        if (!grid.has(di, dj)) {
          const bool lowest = (side.name == "bottom" && j == 0) || (side.name == "left" && i == 0);
          add_outer_side(making, i, j, side, field, held && lowest);
        } else if (side.name == "right" || side.name == "top") {
          if (making.random.chance(0.1)) continue;
          const Side& back = side.name == "right" ? sides[0] : sides[2];
          const std::string own = part_name(grid, i, j, side), other = part_name(grid, di, dj, back);
          const Vector<2> from = grid.corner(i + side.corners[0][0], j + side.corners[0][1]);
          const Vector<2> to = grid.corner(i + side.corners[1][0], j + side.corners[1][1]);
          const bool swapped = making.random.chance(0.5);
          add_contact(making, swapped ? other : own, swapped ? own : other, random_gap(making, from, to));
        }
      }
    }
}

/// Without some of the cells that have no edge in contact; a body that would fall apart stays whole.
scene::Mesh<2> with_holes(Random& random, const scene::Scene<2>& scene, const scene::Mesh<2>& whole) {
  std::vector<char> kept(whole.cells.size(), 1);
  for (char& cell : kept) cell = random.chance(0.15) ? 0 : 1;
  for (const auto& facet : whole.boundary)
    for (const auto& pair : scene.contact)
      if (contains(pair.first, whole.parts[facet.part]) || contains(pair.second, whole.parts[facet.part]))
        kept[facet.cell] = 1;
  scene::Mesh<2> mesh;
  mesh.bodies = whole.bodies;
  mesh.parts = whole.parts;
  std::vector<int> number(whole.vertices.size(), -1);
  for (std::size_t c = 0; c < whole.cells.size(); ++c) {
    if (!kept[c]) continue;
    auto cell = whole.cells[c];
    for (int& vertex : cell) {
      if (number[vertex] < 0) {
        number[vertex] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(whole.vertices[vertex]);
      }
      vertex = number[vertex];
    }
    mesh.cells.push_back(cell);
    mesh.cell_body.push_back(whole.cell_body[c]);
  }
  std::vector<scene::PartEdge> edges;
  for (const auto& facet : whole.boundary)
    if (kept[facet.cell]) edges.push_back({{number[facet.vertices[0]], number[facet.vertices[1]]}, facet.part});
  for (int body = 0; body < static_cast<int>(mesh.bodies.size()); ++body)
    if (std::ranges::count(mesh.cell_body, body) == 0) return whole;
  try {
    return scene::with_topology(std::move(mesh), edges, "");
  } catch (const scene::Error&) {
    return whole;
  }
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
  Random random(seed);
  const double size = random.pick<double>({1, 1, 1, 1e-6, 1e3, 1e6});
  const double young = random.pick<double>({1, 1, 1e5, 1e11, 1e-3});
  const double load = young * random.pick<double>({1e-3, 1e-3, 1e-6, 1e-1});
  const scene::Plane plane = random.chance(0.5) ? scene::Plane::strain : scene::Plane::stress;
  Grid grid = random_grid(random, size);
  Making making{random, std::move(grid), size, load, {}};
  if (seed % 2 == 0) {  // farther from the origin, or carried away by far more than the strains
    Random extra(seed + (std::uint64_t{1} << 32));
    if (extra.chance(0.15)) making.grid.map.shift = 1e8 * size * Vector<2>(1, -1);
    // Far from the origin directions are rounded: what is prescribed along them would contradict large motions.
    const bool far = making.grid.map.shift.norm() > 1e3 * size;
    const double carried = far ? 0 : extra.pick<double>({0, 0, 1, 1e3, 1048576});
    making.carried = carried * size * Vector<2>(extra.uniform(-1, 1), extra.uniform(-1, 1));
  }
  scene::Scene<2>& scene = making.made.scene;
  scene.plane = plane;
  const Map& map = making.grid.map;
  making.say(fmt::format("seed {}, plane {}, map: shear {}, bend {} {}, turn {} {}, shift {}", seed, name(plane),
                         map.shear, map.bend_x, map.bend_y, map.cosine, map.sine, map.shift[0]));
  making.say(fmt::format("carried by ({}, {})", making.carried[0], making.carried[1]));
  add_bodies(making, young);
  add_boundary(making);
  scene::Mesh<2> mesh = scene::build_mesh(scene);
  for (Vector<2>& x : mesh.vertices) x = map(x);
  if (making.random.chance(0.3)) mesh = with_holes(making.random, scene, mesh);
  making.say(fmt::format("{} cells", mesh.cells.size()));
  making.made.mesh = std::move(mesh);
  return std::move(making.made);
}

}  // namespace bracket::tests
