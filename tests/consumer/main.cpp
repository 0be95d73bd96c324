// A block pressed on a rigid wall by a punch-like load: the scene in code, the adaptive driver, the interval, the
// fields and the report as files.
#include <apps/report/report.h>
#include <apps/report/vtk.h>
#include <bounds/bounds.h>
#include <bounds/results.h>
#include <bracket/version.h>

#include <cstdio>
#include <fstream>

using namespace bracket;

int main() {
  scene::Scene<2> scene;
  scene.blocks = {{"block", {{{0, 2}, {0, 1}}}, {4, 2}}};
  scene.bodies = {{"block", scene::isotropic<2>(210e3, 0.3, scene::Plane::strain)}};
  scene.boundary["block.left"] = {scene::ConditionKind::sliding, {0}};
  scene.boundary["block.top"] = {scene::ConditionKind::pressure,
                                 {scene::enclosed<2>([](const auto& x) { return scene::choose(x[0] < 0.5, 100, 0); })}};
  scene.contact = {{"block.bottom", "rigid", 0}};
  scene.refine = {.strategy = scene::Strategy::adaptive, .target = 0.01};

  try {
    bounds::Observer<2> observer;
    observer.level = [](const bounds::Outcome<2>& so_far) {
      std::printf("%6d cells: [%.12g, %.12g]\n", so_far.levels.back().cells, so_far.lower, so_far.upper);
    };
    const auto outcome = bounds::run(scene, observer);
    std::printf("Bracket %s: energy in [%.17g, %.17g], error at most %.2g of the solution\n", BRACKET_VERSION_STRING,
                outcome.lower, outcome.upper, outcome.relative_error_bound);
    const apps::Report report = apps::report(scene, outcome);
    std::ofstream("solution.vtu", std::ios::binary) << apps::solution_vtu(report);
    std::ofstream("report.json") << apps::report_json(report);

    // Computed from the fields, not guaranteed.
    const auto contact = bounds::contact_result(outcome.problem, outcome.stress, 0);
    const auto support = bounds::resultant(outcome.problem, outcome.stress, "block.left");
    const auto largest = bounds::largest_displacement(outcome.problem, outcome.displacement);
    const auto middle = bounds::values_at<2>(outcome.problem, outcome.displacement, outcome.stress, {1, 0.5});
    std::printf("force of the wall %g, of the support %g; pressure up to %g, on %g of %g\n", contact.resultant.force[1],
                support.force[0], contact.largest_pressure, contact.pressed_length, contact.length);
    std::printf("displacement up to %g; stress in the middle %g\n", largest.displacement.norm(), middle->stress[1]);
    return static_cast<int>(outcome.status);
  } catch (const scene::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.status());
  }
}
