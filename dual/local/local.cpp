// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "contact/clock.h"
#include "dual/dual.h"
#include "dual/local/contact_step.h"
#include "dual/local/target.h"
#include "scene/bernstein.h"
#include "scene/parallel.h"
#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// The loads of a linear stress on the facets of a cell.
template <int dim> CellVector<dim> loads_of(const scene::Mesh<dim>& mesh, int cell, const LinearStress<dim>& stress) {
  CellVector<dim> loads;
  for (int i = 0; i <= dim; ++i) {
    const Vector<dim> outward = scene::area_vector<dim>(scene::positions(mesh, facet_vertices(mesh, cell, i)));
    const auto corners = sorted_corners<dim>(mesh.cells[cell], i);
    for (int slot = 0; slot < dim; ++slot)
      loads.template segment<dim>(n_facet_loads<dim> * i + dim * slot) =
          scene::traction<dim>(stress[corners[slot]], outward);
  }
  return loads;
}

/// div of a stress linear on a cell.
template <int dim> Vector<dim> divergence(const scene::Mesh<dim>& mesh, int cell, const LinearStress<dim>& stress) {
  const auto G = scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[cell]));
  Vector<dim> sum = Vector<dim>::Zero();
  for (int j = 0; j <= dim; ++j) sum += scene::traction<dim>(stress[j], G[j]);
  return sum;
}

/// The loads on all facets of all cells, while stars change them.
template <int dim> class Loads {
 public:
  Loads(const Problem<dim>& problem, const std::vector<std::array<double, std::size_t{dim}>>& pressure,
        const scene::Displacement<dim>& displacement)
      : problem_(problem), mesh_(problem.mesh), facets_(facets_of(problem)), pressure_(pressure) {
    const Stars stars = stars_of(mesh_);
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
      stars_.emplace_back(problem, facets_, stars, static_cast<int>(v));
    set_colours();
    given_ = given_loads(problem, facets_, pressure);
    target_ = target_stress(problem, facets_, stars_, given_, displacement);
    const int n = static_cast<int>(mesh_.cells.size());
    energy_.resize(n);
    loads_.resize(n);
    scene::for_each_index(n, [&](int c) {
      energy_[c] = energy_of(problem, c);
      loads_[c] = loads_of(mesh_, c, target_[c]);
    });
    prescribed_.assign(facets_.facet.size(), FacetVector<dim>::Zero());
    for (std::size_t f = 0; f < mesh_.boundary.size(); ++f) prescribe(static_cast<int>(f));
  }

  /// Stars one after the other hand the target's loads out such that cells and facets are in balance; each sees what
  /// those before it changed (docs/theory.md §12.2).
  void equilibrate() {
    constexpr int one = n_facet_loads<dim>;
    const std::size_t n = mesh_.cells.size();
    std::vector<FacetVector<dim>> lacking =
        std::move(given_);              // on facets: what has to be there, less what the target has
    std::vector<Vector<dim>> force(n);  // F + div σ*
    for (std::size_t c = 0; c < n; ++c) {
      const int cell = static_cast<int>(c);
      for (int i = 0; i <= dim; ++i) lacking[cell_facets(mesh_, cell)[i]] -= loads_[c].template segment<one>(one * i);
      force[c] = body_of(problem_, cell).force + divergence(mesh_, cell, target_[c]);
    }
    std::vector<CellVector<dim>> change(n, CellVector<dim>::Zero());
    std::vector<int> done(n, 0);
    for_each_star([&](const Star<dim>& star) {
      StarData<dim> data(star);
      for (std::size_t i = 0; i < star.cells().size(); ++i) {
        const int c = star.cells()[i];
        ++done[c];
        data.gradient[i] = on_spokes(star.corner(i), energy_[c].loads * change[c] +
                                                         energy_[c].by_body_force * (done[c] / (dim + 1.0) * force[c]));
        data.resultant[i] = -share_of(force[c], c, star.corner(i));
      }
      for (std::size_t f = 0; f < star.spokes().size(); ++f) {
        const int number = star.spokes()[f];
        data.sum[f] = applied<dim>(share_of_vertex<dim>()[slot(facets_, number, star.vertex())], lacking[number]);
      }
      add(star, StarSystem<dim>(star, energy_).solve(data).loads, change);
    });
    for (std::size_t c = 0; c < n; ++c) loads_[c] += change[c];
    target_.clear();
  }

  /// Once around all stars: each gets the loads of least S that are in balance, those on other facets as they are.
  void sweep() {
    for_each_star([&](const Star<dim>& star) {
      const StarSystem<dim> system(star, energy_);
      add(star, system.solve(as_they_are(star)).loads, loads_);
    });
  }

  /// Once around the vertices in contact: the stars of both sides get the loads and the pressures on their contact
  /// facets of least S together, p ≥ 0 where the sides can part.
  void contact_sweep() {
    std::vector<std::vector<int>> contacts(mesh_.vertices.size());
    for (std::size_t j = 0; j < problem_.contact.size(); ++j)
      for (const int v : mesh_.boundary[problem_.contact[j].first].vertices) contacts[v].push_back(static_cast<int>(j));
    for (std::size_t v = 0; v < contacts.size(); ++v)
      if (!contacts[v].empty()) press(static_cast<int>(v), contacts[v]);
  }

  const std::vector<std::array<double, std::size_t{dim}>>& pressure() const { return pressure_; }
  /// How many loads are to be found.
  int unknowns() const {
    int sum = 0;
    for (const auto& facet : facets_.facet)
      sum += facet.boundary < 0 || facet.support == Support::fixed ? n_facet_loads<dim>
             : facet.support == Support::sliding                   ? dim
                                                                   : 0;
    return sum;
  }

  scene::Stress<dim> stress() const {
    scene::Stress<dim> result;
    result.cell.resize(loads_.size());
    scene::for_each_index(static_cast<int>(loads_.size()), [&](int c) {
      const auto block = stress_of<dim>(mesh_.cells[c], geometry_of(mesh_, c), loads_[c], body_of(problem_, c).force);
      for (const auto& part : block)
        for (const auto& tensor : part) result.cell[c].push_back(Eigen::Map<const scene::Voigt<dim>>(tensor.data()));
    });
    return result;
  }

 private:
  using Spokes = typename StarData<dim>::Spokes;

  /// One after the other, but for those that have no cell in common.
  template <class Work> void for_each_star(const Work& work) {
    constexpr int at_once = 16;  // a star is as much work as some dozens of cells
    for (const std::vector<int>& together : colours_)
      scene::for_each_index(
          static_cast<int>(together.size()), [&](int i) { work(stars_[together[i]]); }, at_once);
  }
  void set_colours() {
    std::vector<int> colour(stars_.size(), -1);
    std::vector<std::size_t> taken;  // by which vertex a colour is last known to be
    for (std::size_t v = 0; v < stars_.size(); ++v) {
      for (const int c : stars_[v].cells())
        for (const int w : mesh_.cells[c])
          if (colour[w] >= 0) taken[colour[w]] = v + 1;
      const auto free = std::find_if(taken.begin(), taken.end(), [&](std::size_t by) { return by != v + 1; });
      colour[v] = static_cast<int>(free - taken.begin());
      if (free == taken.end()) {
        taken.push_back(0);
        colours_.emplace_back();
      }
      colours_[colour[v]].push_back(static_cast<int>(v));
    }
  }

  static Spokes on_spokes(int corner, const CellVector<dim>& loads) {
    constexpr int one = n_facet_loads<dim>;
    Spokes result;
    for (int k = 0, place = 0; k <= dim; ++k)
      if (k != corner) result.template segment<one>(one * place++) = loads.template segment<one>(one * k);
    return result;
  }
  static void add(const Star<dim>& star, const std::vector<Spokes>& change, std::vector<CellVector<dim>>& loads) {
    constexpr int one = n_facet_loads<dim>;
    for (std::size_t i = 0; i < change.size(); ++i)
      for (int k = 0, place = 0; k <= dim; ++k)
        if (k != star.corner(i))
          loads[star.cells()[i]].template segment<one>(one * k) += change[i].template segment<one>(one * place++);
  }

  /// Changes of the loads on a star that leave all in balance, and what S would gain by them.
  StarData<dim> as_they_are(const Star<dim>& star) const {
    StarData<dim> data(star);
    for (std::size_t i = 0; i < star.cells().size(); ++i) {
      const int c = star.cells()[i];
      data.gradient[i] = on_spokes(
          star.corner(i), energy_[c].loads * loads_[c] + energy_[c].by_body_force * body_of(problem_, c).force);
    }
    for (std::size_t f = 0; f < star.spokes().size(); ++f) data.prescribed[f] = prescribed_[star.spokes()[f]];
    return data;
  }

  /// A star that a contact acts on.
  struct Touched {
    const Star<dim>* star;
    StarSystem<dim> system;
    StarData<dim> data;
    typename StarSystem<dim>::Solution at_rest;  ///< by the pressures as they are
  };
  /// The loads of a unit pressure at a vertex of a contact facet.
  struct UnitPressure {
    struct On {
      std::size_t touched;
      int spoke;
      FacetVector<dim> load;
    };
    std::vector<On> on;  ///< one side or both
    int contact, vertex;
  };

  int number_of(int facet) const { return cell_facets(mesh_, mesh_.boundary[facet].cell)[mesh_.boundary[facet].local]; }

  void press(int vertex, const std::vector<int>& contacts) {
    std::vector<Touched> touched;
    const auto touch = [&](int v) {
      for (std::size_t t = 0; t < touched.size(); ++t)
        if (touched[t].star == &stars_[v]) return t;
      StarSystem<dim> system(stars_[v], energy_);
      StarData<dim> data = as_they_are(stars_[v]);
      auto at_rest = system.solve(data);
      touched.push_back({&stars_[v], std::move(system), std::move(data), std::move(at_rest)});
      return touched.size() - 1;
    };
    std::vector<UnitPressure> units;
    for (const int j : contacts) {
      const auto& pair = problem_.contact[j];
      const auto& first = mesh_.boundary[pair.first].vertices;
      const auto place = std::find(first.begin(), first.end(), vertex) - first.begin();
      const double size = scene::area_vector<dim>(scene::positions(mesh_, first)).norm();
      for (int k = 0; k < dim; ++k) {
        UnitPressure unit{{}, j, k};
        const auto act = [&](int facet, int at_star, int own, double sign) {
          const std::size_t t = touch(at_star);
          const auto& spokes = touched[t].star->spokes();
          const int number = number_of(facet);
          FacetVector<dim> load = FacetVector<dim>::Zero();
          load.template segment<dim>(dim * slot(facets_, number, mesh_.boundary[facet].vertices[own])) =
              sign * size * problem_.facets[pair.first].normal;
          unit.on.push_back(
              {t, static_cast<int>(std::lower_bound(spokes.begin(), spokes.end(), number) - spokes.begin()), load});
        };
        act(pair.first, vertex, k, -1);
        if (pair.second >= 0)
          act(pair.second, mesh_.boundary[pair.second].vertices[pair.meets[place]], pair.meets[k], 1);
        units.push_back(std::move(unit));
      }
    }
    const SmallProblem problem = small_problem(touched, units);
    const Eigen::VectorXd change = descend(problem, 8 * static_cast<int>(units.size()));
    for (std::size_t i = 0; i < units.size(); ++i) {
      pressure_[units[i].contact][units[i].vertex] += change[static_cast<Eigen::Index>(i)];
      for (const auto& [t, spoke, load] : units[i].on)
        touched[t].data.sum[spoke] += change[static_cast<Eigen::Index>(i)] * load;
    }
    for (const Touched& one : touched) add(*one.star, one.system.solve(one.data).loads, loads_);
  }

  /// S by changes of the pressures.
  SmallProblem small_problem(const std::vector<Touched>& touched, const std::vector<UnitPressure>& units) const {
    const auto n = static_cast<Eigen::Index>(units.size());
    SmallProblem problem{Eigen::MatrixXd(n, n), Eigen::VectorXd(n), {}, Eigen::VectorXd(n)};
    std::vector<Eigen::Index> first_motion;
    Eigen::Index motions = 0;
    for (const Touched& one : touched) {
      first_motion.push_back(motions);
      motions += one.star->motions().cols();
    }
    problem.motion = Eigen::MatrixXd::Zero(n, motions);
    for (Eigen::Index i = 0; i < n; ++i) {
      const UnitPressure& unit = units[i];
      const auto& pair = problem_.contact[unit.contact];
      problem.least[i] =
          pair.law.two_sided ? -std::numeric_limits<double>::infinity() : -pressure_[unit.contact][unit.vertex];
      problem.slope[i] = gap_moment(pair, unit.vertex);
      std::vector<StarData<dim>> alone;
      for (const Touched& one : touched) alone.emplace_back(*one.star);
      for (const auto& [t, spoke, load] : unit.on) {
        problem.slope[i] += load.dot(touched[t].at_rest.displacement[spoke]);
        alone[t].sum[spoke] += load;
        const Star<dim>& star = *touched[t].star;
        Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1> wrench =
            resultants<dim>(star.arms(spoke)) * load;
        wrench.template tail<scene::Simplex<dim>::n_rotations>() /= star.size();
        problem.motion.row(i).segment(first_motion[t], star.motions().cols()) += wrench.transpose() * star.motions();
      }
      std::vector<typename StarSystem<dim>::Solution> response;
      for (std::size_t t = 0; t < touched.size(); ++t) response.push_back(touched[t].system.solve(alone[t]));
      for (Eigen::Index k = 0; k < n; ++k) {
        problem.form(k, i) = 0;
        for (const auto& [t, spoke, load] : units[k].on)
          problem.form(k, i) += load.dot(response[t].displacement[spoke]);
      }
    }
    problem.form = (0.5 * (problem.form + problem.form.transpose())).eval();
    return problem;
  }

  /// ∫ ψ_k g⁺ over a contact facet, k one of the first facet's vertices.
  double gap_moment(const scene::ContactFacetOf<dim>& pair, int k) const {
    const double size = scene::area_vector<dim>(scene::positions(mesh_, mesh_.boundary[pair.first].vertices)).norm();
    double sum = 0;
    for (std::size_t i = 0; i < pair.upper.size(); ++i) {
      if constexpr (dim == 2) {
        sum += scene::number<double>(scene::bernstein_mass(1, k, 2, static_cast<int>(i))) * pair.upper[i];
      } else {  // of vertices 1/10, 1/30; of edges that end at the vertex 1/15, the other 1/30
        const bool own = i < 3 ? static_cast<int>(i) == k : static_cast<int>(i) - 3 != k;
        sum += (i < 3 ? (own ? 3 : 1) : (own ? 2 : 1)) / 30.0 * pair.upper[i];
      }
    }
    return size * sum;
  }

  /// Force and moments about the vertex of ψ_a F on a cell.
  Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1> share_of(const Vector<dim>& force, int cell,
                                                                          int corner) const {
    using Table = scene::Simplex<dim>;
    Eigen::Matrix<double, Table::n_rigid_motions, 1> result;
    const double volume = scene::volume(mesh_, cell);
    Vector<dim> arm = Vector<dim>::Zero();
    for (const int v : mesh_.cells[cell]) arm += mesh_.vertices[v] - mesh_.vertices[mesh_.cells[cell][corner]];
    arm *= volume / Table::hat_masses_of;
    result.template head<dim>() = volume / (dim + 1) * force;
    for (int r = 0; r < Table::n_rotations; ++r) {
      const auto [i, j] = Table::rotations[r];
      result[dim + r] = arm[i] * force[j] - arm[j] * force[i];
    }
    return result;
  }

  /// The displacements prescribed on a boundary facet, by their moments.
  void prescribe(int f) {
    const auto& boundary = mesh_.boundary[f];
    const auto& data = problem_.facets[f];
    if (data.support != Support::fixed && data.support != Support::sliding) return;
    const int number = number_of(f);
    const Eigen::Matrix<double, dim, dim> masses = hat_masses<dim>();
    for (int k = 0; k < dim; ++k) {
      const Vector<dim> u = data.support == Support::fixed
                                ? data.displacement[k]
                                : Vector<dim>(data.normal_displacement[k] / data.normal.squaredNorm() * data.normal);
      const int at = slot(facets_, number, boundary.vertices[k]);
      for (int j = 0; j < dim; ++j) prescribed_[number].template segment<dim>(dim * j) += masses(j, at) * u;
    }
  }

  const Problem<dim>& problem_;
  const scene::Mesh<dim>& mesh_;
  Facets<dim> facets_;
  std::vector<std::array<double, std::size_t{dim}>> pressure_;
  std::vector<Star<dim>> stars_;
  std::vector<std::vector<int>> colours_;  ///< stars that have no cell in common
  std::vector<FacetVector<dim>> given_;    ///< until they are handed out, so below
  std::vector<LinearStress<dim>> target_;
  std::vector<Energy<dim>> energy_;
  std::vector<CellVector<dim>> loads_;
  std::vector<FacetVector<dim>> prescribed_;
};

}  // namespace

template <int dim>
Result<dim> local(const Problem<dim>& problem, const std::vector<std::array<double, std::size_t{dim}>>& pressure,
                  const scene::Displacement<dim>& displacement, int sweeps) {
  constexpr int contact_sweeps = 2;  // before the first sweep; after each one more
  Clock clock;
  Result<dim> result;
  contact::Statistics& statistics = result.statistics;
  try {
    Loads<dim> loads(problem, pressure, displacement);
    statistics.seconds.assemble = clock.lap();
    loads.equilibrate();
    statistics.seconds.factorise = clock.lap();
    for (int i = 0; i < contact_sweeps; ++i) loads.contact_sweep();
    statistics.seconds.contact = clock.lap();
    for (int i = 0; i < sweeps; ++i) {
      loads.sweep();
      statistics.seconds.factorise += clock.lap();
      loads.contact_sweep();
      statistics.seconds.contact += clock.lap();
    }
    result.stress = loads.stress();
    statistics.seconds.recover = clock.lap();
    statistics.unknowns = loads.unknowns();
    statistics.rows = dim * static_cast<int>(problem.contact.size());
    for (const auto& facet : loads.pressure())
      statistics.active_rows += static_cast<int>(std::ranges::count_if(facet, [](double p) { return p != 0; }));
  } catch (const NotDefinite& star) {
    result.termination = contact::Termination::not_definite;
    std::vector<std::string> at;
    for (const double x : problem.mesh.vertices[star.vertex]) at.push_back(fmt::format("{:.7g}", x));
    result.reason = fmt::format(
        "stresses: the cells at the vertex ({}) are too thin, or their moduli too unlike, for the precision of a "
        "double",
        fmt::join(at, ", "));
  }
  return result;
}

template Result<2> local<2>(const Problem<2>&, const std::vector<std::array<double, 2>>&, const scene::Displacement<2>&,
                            int);
template Result<3> local<3>(const Problem<3>&, const std::vector<std::array<double, 3>>&, const scene::Displacement<3>&,
                            int);

}  // namespace bracket::dual
