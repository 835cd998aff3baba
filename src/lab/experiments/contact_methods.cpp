// SPDX-License-Identifier: MIT
#include "lab/experiments/contact_methods.h"

#include <algorithm>
#include <map>

#include "lab/measure/made_scenes.h"
#include "measure/theory.h"
#include "methods/methods.h"
#include "response/pair_force.h"

namespace ballpit {

namespace {

std::string role_of(std::string_view response) {
  static const std::map<std::string_view, std::string> roles{{"event-driven", "first"},
                                                             {"impulse", "second"},
                                                             {"penalty", "third"},
                                                             {"position-based", "sixth"},
                                                             {"kinematic", "fifth"}};
  const auto found = roles.find(response);
  return found == roles.end() ? "fourth" : found->second;
}

/// The values of a setting that go with a response, without auto.
template <class Choice>
std::vector<Choice> choices_for(Response response, std::string_view setting) {
  std::vector<Choice> choices;
  for (const std::string_view name : kNames<Choice>) {
    if (name != "auto" && goes_with(response, setting, name)) choices.push_back(named<Choice>(name));
  }
  return choices;
}

/// Settings other than the integrator that make another method; empty: the default of the response.
std::vector<std::string> variants_of(Response response) {
  std::vector<std::string> variants{""};
  if (goes_with(response, "solver", "gauss-seidel")) variants.push_back("gauss-seidel");
  if (goes_with(response, "swept", "on")) variants.push_back("swept");
  return variants;
}

void add_methods(Response response, std::vector<ContactMethod>& list) {
  const std::string name(name_of(response));
  const std::vector<Integrator> integrators = choices_for<Integrator>(response, "integrator");
  Settings own = settings_of(name, 0);
  own.integrator = integrator_of(own);
  for (const Integrator integrator : integrators) {
    for (const std::string& variant : variants_of(response)) {
      for (const Precision precision : choices_for<Precision>(response, "precision")) {
        ContactMethod method{name, name, role_of(name), false, own};
        method.settings.integrator = integrator;
        method.settings.precision = precision;
        if (variant == "gauss-seidel") method.settings.solver = Solver::gauss_seidel;
        method.settings.is_swept = variant == "swept";
        const bool is_own = integrator == own.integrator;
        method.is_main = is_own && variant.empty() && precision == Precision::float64;
        if (integrators.size() > 1) method.name.append(", ").append(name_of(integrator));
        if (!is_own) method.label = "+ " + std::string(name_of(integrator));
        if (!variant.empty()) method.name += ", " + variant;
        if (!variant.empty()) method.label = "+ " + variant;
        if (precision == Precision::float32) method.name += ", float";
        list.push_back(method);
      }
    }
  }
}

}  // namespace

const std::vector<ContactMethod>& contact_methods() {
  static const std::vector<ContactMethod> table = [] {
    std::vector<ContactMethod> list;
    for (const std::string_view name : kNames<Response>) {
      if (name != name_of(Response::automatic)) add_methods(named<Response>(name), list);
    }
    return list;
  }();
  return table;
}

bool is_float_of_main(const ContactMethod& method) {
  const auto is_its_main = [&](const ContactMethod& o) { return o.is_main && o.name + ", float" == method.name; };
  return std::ranges::any_of(contact_methods(), is_its_main);
}

bool has_steps(const ContactMethod& method) { return method.settings.response != Response::event_driven; }

Series series_of(const ContactMethod& method) {
  const bool is_float = method.settings.precision == Precision::float32;
  return {is_float ? "" : method.label, method.role, {}, Stroke::line_and_points, is_float, !method.is_main};
}

void drop_equal_labels(std::vector<Series>& list) {
  for (Series& series : list) {
    const auto main = std::find_if(list.begin(), list.end(), [&](const Series& other) {
      return !other.is_thin && !other.is_dashed && other.role == series.role;
    });
    if (!series.is_thin || main == list.end()) continue;
    const double ratio = series.points.back().y / main->points.back().y;
    if (ratio > 0.9 && ratio < 1.1) series.label.clear();
  }
}

double stiffness_for(double dt, double steps, double mu, double restitution) {
  return stiffness_of_duration(steps * dt, mu, damping_of(restitution, false));
}

Scene with_springs(Scene gas, double dt) {
  gas.physics.stiffness = stiffness_for(dt, kStepsOfContact, 0.5, 1);
  return gas;
}

}  // namespace ballpit
