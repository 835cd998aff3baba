// SPDX-License-Identifier: MIT
#include "choose/rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/numbers.h"
#include "core/phrase.h"
#include "measure/theory.h"

namespace ballpit {

namespace {

using C = const RuleCase&;

std::string text(double value) { return local_number(three_digits(value)); }

bool is(C c, Response response) { return c.settings.response == response; }
bool needs(C c, Effect effect) { return c.needs.has(effect); }
bool is_exact(C c) { return is(c, Response::event_driven); }

/// Neither event-driven nor swept: a contact is seen where a step ends.
bool is_discrete(C c) { return !is_exact(c) && !c.settings.is_swept; }

bool carries_load(C c) { return c.numbers.has_gravity && c.numbers.layers > 1 && c.needs.duration > 0; }

/// The smallest overlap that is allowed at rest, as a fraction of a radius; infinite if none is.
double allowed_overlap(C c) {
  return std::min(c.needs.max_overlap.value_or(std::numeric_limits<double>::infinity()),
                  c.needs.max_overlap_ever.value_or(std::numeric_limits<double>::infinity()));
}

std::string kinematic_is_implausible(C c) {
  if (!is(c, Response::kinematic) || needs(c, Effect::kinematic)) return "";
  return phrase("it only looks plausible: a sphere turns back at a contact, whatever the other one weighs");
}

std::string rigid_contacts_have_no_duration(C c) {
  if (is(c, Response::penalty) || !needs(c, Effect::contact_time)) return "";
  return phrase("its contacts have no duration, and the scene needs contact-time");
}

std::string contact_is_not_resolved(C c) {
  if (!is(c, Response::penalty) || !needs(c, Effect::contact_time)) return "";
  constexpr double kSteps = 20;
  const double steps = c.numbers.contact_duration / c.step();
  if (steps >= kSteps) return "";
  return phrase("a contact lasts {} steps; contact-time needs 20: a step of {} s", text(steps),
                text(c.numbers.contact_duration / kSteps));
}

std::string springs_are_unstable(C c) {
  if (!is(c, Response::penalty) || c.numbers.count == 0) return "";
  const double limit =
      stable_step(c.scene, c.numbers) * (integrator_of(c.settings) == Integrator::rk4 ? std::sqrt(2.0) : 1);
  if (c.step() <= limit) return "";
  return phrase("springs gain energy: a step of {} s is {} times the largest stable one, {} s", text(c.step()),
                text(c.step() / limit), text(limit));
}

std::string springs_are_too_soft(C c) {
  if (!is(c, Response::penalty) || c.numbers.count == 0 || c.numbers.packing == 0) return "";
  const SceneNumbers& n = c.numbers;
  const double k = c.scene.physics.stiffness, load = n.load * n.gravity;
  const double sunk = c.scene.physics.law == "hertz" ? std::pow(load / k, 2.0 / 3) : load / k;
  if (!n.has_gravity || sunk <= allowed_overlap(c) * n.radius_min) return "";
  return phrase("its springs are too soft: n·m·g/k is {} of a radius, allowed {}", text(sunk / n.radius_min),
                text(allowed_overlap(c)));
}

/// What the response itself leaves: ImpulseLaw::slop, of the sum of two radii.
std::string impulses_leave_overlap(C c) {
  constexpr double kSlop = 0.01;
  const bool corrects = is(c, Response::impulse) && c.settings.correction == Correction::split;
  if (!corrects || !carries_load(c) || allowed_overlap(c) >= kSlop) return "";
  return phrase("it leaves an overlap of {} of a radius in what rests, so that contacts persist; allowed {}",
                text(kSlop), text(allowed_overlap(c)));
}

std::string spheres_pass_through(C c) {
  const double flight = c.numbers.flight(c.step());
  if (!is_discrete(c) || flight <= 1) return "";
  return phrase("the fastest sphere moves {} diameters in a step and may pass through another one; 1 is a step of {} s",
                text(flight), text(c.step() / flight));
}

std::string contacts_last(C c) {
  if (!is_exact(c)) return "";
  if (needs(c, Effect::resting)) return phrase("contacts that last are infinitely many collisions");
  if (c.needs.duration <= c.numbers.rest_time) return "";
  return phrase("contacts begin to last after about {} s; each is then infinitely many collisions",
                text(c.numbers.rest_time));
}

std::string starts_in_contact(C c) {
  constexpr double kAllowed = 1e-6;
  if (!is_exact(c) || c.numbers.start_overlap <= kAllowed) return "";
  return phrase("spheres overlap at the start by {} of a radius, and hard spheres cannot",
                text(c.numbers.start_overlap));
}

std::string hits_at_once(C c) {
  if (is_exact(c) || !needs(c, Effect::momentum_order)) return "";
  return phrase("it resolves all contacts of a step at once, and the scene needs one hit after another");
}

/// Sweeps per step until 1 % is left, Jacobi's four times Gauss–Seidel's; a third of it is what four steps share.
std::string stack_is_too_tall(C c) {
  if (!is(c, Response::impulse) || !carries_load(c)) return "";
  const bool is_jacobi = c.settings.solver == Solver::jacobi;
  const double n = c.numbers.layers, sweeps = (is_jacobi ? 4 : 1) * stack_sweeps(n);
  const double left = std::max(1.0, sweeps / iterations_of(c.settings));
  const double sinks = left * c.numbers.gravity * c.step() * c.step() / c.numbers.radius_min;
  if (sinks <= allowed_overlap(c)) return "";
  return phrase("{} layers need {} sweeps; with {} they sink by {} of a radius, allowed {}", text(n), text(sweeps),
                iterations_of(c.settings), text(sinks), text(allowed_overlap(c)));
}

std::string heavy_on_light(C c) {
  if (!is(c, Response::impulse) || !carries_load(c) || c.numbers.has_equal_masses) return "";
  const double sweeps = ratio_sweeps(c.numbers.mass_ratio()), left = std::max(1.0, sweeps / iterations_of(c.settings));
  const double sinks = left * c.numbers.gravity * c.step() * c.step() / c.numbers.radius_min;
  if (sinks <= allowed_overlap(c)) return "";
  return phrase("a mass ratio of {} needs {} sweeps; with {} it sinks by {} of a radius, allowed {}",
                text(c.numbers.mass_ratio()), text(sweeps), iterations_of(c.settings), text(sinks),
                text(allowed_overlap(c)));
}

std::string positions_sag(C c) {
  if (!is(c, Response::position_based) || !carries_load(c)) return "";
  const double h = c.step(), n = c.numbers.layers;
  const double sag = (n - 1) * c.numbers.gravity * h * h / iterations_of(c.settings) / c.numbers.radius_min;
  if (sag <= allowed_overlap(c)) return "";
  return phrase("(n − 1)·g·h² is {} of a radius, allowed {}", text(sag), text(allowed_overlap(c)));
}

std::string enters_too_deep(C c) {
  if (is(c, Response::penalty) || is_exact(c) || c.settings.is_swept || c.numbers.count < 2) return "";
  if (c.needs.duration > c.numbers.rest_time && !c.needs.max_overlap_ever) return "";  // at the end nothing hits
  const double deep = c.numbers.typical_speed * c.step() / c.numbers.radius_min;
  if (deep <= allowed_overlap(c)) return "";
  return phrase("spheres enter each other by {} of a radius in a step, allowed {}", text(deep),
                text(allowed_overlap(c)));
}

std::string float_is_frozen(C c) {
  if (precision_of(c.settings) == Precision::float64 || c.numbers.typical_speed == 0) return "";
  const double steps = c.numbers.float_steps(c.step());
  if (steps >= 1) return "";
  return phrase("float cannot hold the motion: {} m from the origin a step of {} m is lost", text(c.numbers.reach),
                text(c.numbers.typical_speed * c.step()));
}

/// Sums of 1/dt steps, each rounded to 6·10⁻⁸, as a random walk.
std::string float_is_too_coarse(C c) {
  if (precision_of(c.settings) == Precision::float64) return "";
  constexpr double kRounding = 6e-8, kNone = std::numeric_limits<double>::infinity();
  const double tolerance =
      std::min(c.needs.energy_tolerance.value_or(kNone), c.needs.momentum_tolerance.value_or(kNone));
  const double error = kRounding * std::sqrt(c.needs.duration / c.step());
  if (error <= tolerance) return "";
  return phrase("float rounds energy and momentum to {}, allowed {}", text(error), text(tolerance));
}

/// .81 e-folds a collision and sphere at a density of .5, 2.5 at .1.
std::string chaos_loses_the_paths(C c) {
  if (!needs(c, Effect::paths) || c.numbers.count < 2) return "";
  const bool is_double = precision_of(c.settings) == Precision::float64;
  const double collisions = c.numbers.collision_rate * c.needs.duration, most = (is_double ? 46 : 21) / 2.0;
  if (collisions <= most) return "";
  return phrase("after {} collisions of a sphere its path is chance; {} holds it for {}", text(collisions),
                name_of(precision_of(c.settings)), text(most));
}

/// dZ/dt = −3η·Z'(η)·√π/2 in reduced units, with Z by Carnahan and Starling.
std::string late_contacts_bias_pressure(C c) {
  if (is_exact(c) || is(c, Response::penalty) || c.numbers.dimensions == 2 || c.numbers.count < 2) return "";
  const double eta = std::min(c.numbers.packing, 0.6), h = 1e-4;
  const auto z = [](double x) { return carnahan_starling_z(6 * x / std::numbers::pi); };
  const double slope = 3 * eta * (z(eta + h) - z(eta - h)) / (2 * h) * std::sqrt(std::numbers::pi) / 2;
  const double diameter = c.numbers.radius_min + c.numbers.radius_max;
  const double step = c.step() * c.numbers.typical_speed / std::sqrt(3.0) / diameter;
  for (const NeededObservable& o : c.needs.observables) {
    if (o.name != "compressibility" && o.name != "pressure" && o.name != "collision-rate") continue;
    const double bias = slope * step / z(eta);
    if (bias > o.tolerance) {
      return phrase("contacts are seen half a step late, which changes {} by {}, allowed {}", o.name, text(bias),
                    text(o.tolerance));
    }
  }
  return "";
}

std::string cells_are_too_small(C c) {
  if (!can_miss_contacts(c.settings) || is_exact(c)) return "";
  return phrase("cells of {} diameters find {} % of the contacts", text(*c.settings.cell_size),
                text(100 * cell_recall(*c.settings.cell_size)));
}

constexpr auto kMethod = RuleKind::method, kStep = RuleKind::step, kEstimate = RuleKind::estimate;

constexpr std::array kRules{
    Rule{"plausible", kMethod, false, "kinematic", "momentum is conserved", "exercise sheet 2",
         kinematic_is_implausible},
    Rule{"contact-time", kMethod, false, "all but penalty", "t_c > 0", "docs/responses.md",
         rigid_contacts_have_no_duration},
    Rule{"order", kMethod, false, "all but event-driven", "0, 0, 0, 0, 1 against −.6, .4, .4, .4, .4",
         "Newton's cradle, docs/responses.md", hits_at_once},
    Rule{"lasting-contacts", kMethod, false, "event-driven", "T ≤ √(2h/g)·(1 + e)/(1 − e)",
         "Luding and McNamara 1998, doi 10.1007/s100350050017", contacts_last},
    Rule{"overlap", kMethod, false, "event-driven", "overlap at the start ≤ 10⁻⁶", "docs/responses.md",
         starts_in_contact},
    Rule{"soft", kMethod, false, "penalty", "n·m·g/k ≤ allowed overlap", "docs/responses.md", springs_are_too_soft},
    Rule{"chaos", kMethod, false, "all", "Γ·T ≤ 23 in double, 10 in float", "docs/lab: half of what is measured",
         chaos_loses_the_paths},
    Rule{"cells", kMethod, false, "grids", "c ≥ 2·r_max", "docs/model.md", cells_are_too_small},
    Rule{"stable-step", kStep, true, "penalty", "h ≤ .7071·√(m/k)", "2/ω_max of an fcc packing", springs_are_unstable},
    Rule{"resolved", kStep, false, "penalty", "t_c/h ≥ 20", "docs/lab, work-precision", contact_is_not_resolved},
    Rule{"tunnelling", kStep, true, "those that see contacts at the end of a step", "v·h/D ≤ 1",
         "part seen 1 − s²/12, docs/lab, stability", spheres_pass_through},
    Rule{"frozen", kStep, true, "float", "v·h ≥ ulp(x)/2", "IEEE 754; docs/lab, stability", float_is_frozen},
    Rule{"rounding", kStep, false, "float", "6·10⁻⁸·√steps ≤ tolerance", "IEEE 754", float_is_too_coarse},
    Rule{"late-contacts", kStep, false, "those with steps", "dZ/dt = −3η·Z′·√π/2", "docs/lab, equation-of-state",
         late_contacts_bias_pressure},
    Rule{"tall-stack", kEstimate, false, "impulse", "1.866·n² sweeps by Gauss-Seidel, 7.46·n² by Jacobi",
         "docs/lab, stability", stack_is_too_tall},
    Rule{"mass-ratio", kEstimate, false, "impulse", "4.6·(R + 1) sweeps", "docs/lab, stability", heavy_on_light},
    Rule{"slop", kEstimate, false, "impulse", "allowed overlap at rest ≥ 0.01", "docs/responses.md",
         impulses_leave_overlap},
    Rule{"sag", kEstimate, false, "position-based", "(n − 1)·g·h² ≤ allowed overlap",
         "Macklin et al. 2019, doi 10.1145/3309486.3340247", positions_sag},
    Rule{"depth", kEstimate, false, "impulse, position-based, kinematic", "v·h ≤ allowed overlap", "docs/model.md",
         enters_too_deep},
};

}  // namespace

std::span<const Rule> rules() { return kRules; }

Objection first_objection(const RuleCase& c, std::initializer_list<RuleKind> kinds) {
  for (const Rule& rule : kRules) {
    if (std::find(kinds.begin(), kinds.end(), rule.kind) == kinds.end()) continue;
    std::string reason = rule.objection(c);
    if (!reason.empty()) return {&rule, std::move(reason)};
  }
  return {};
}

std::vector<std::string> warnings_of(const Scene& scene, const Settings& settings) {
  std::vector<std::string> warnings;
  const SceneNumbers numbers = numbers_of(scene);
  const Needs none;
  for (const Rule& rule : kRules) {
    if (!rule.warns) continue;
    const std::string reason = rule.objection({scene, none, numbers, settings});
    if (!reason.empty()) warnings.push_back(reason);
  }
  return warnings;
}

}  // namespace ballpit
