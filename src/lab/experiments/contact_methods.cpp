// SPDX-License-Identifier: MIT
#include "lab/experiments/contact_methods.h"

#include <algorithm>
#include <map>

#include "lab/measure/made_scenes.h"
#include "lab/measure/theory.h"
#include "methods/methods.h"
#include "response/damping.h"

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

/// A setting other than the integrator that makes another method.
struct Variant {
  std::string name;  ///< empty: the default of the response
  void (*apply)(Settings&);
};

std::vector<Variant> variants_of(Response response) {
  std::vector<Variant> variants{{"", [](Settings&) {}}};
  if (goes_with(response, "solver", "gauss-seidel")) {
    variants.push_back({"gauss-seidel", [](Settings& settings) { settings.solver = Solver::gauss_seidel; }});
  }
  if (goes_with(response, "swept", "on")) {
    variants.push_back({"swept", [](Settings& settings) { settings.is_swept = true; }});
  }
  return variants;
}

/// "penalty, rk4, float": the settings that differ among the methods of a response.
std::string name_of(const Settings& settings, const Variant& variant, bool has_integrators) {
  std::string name(name_of(settings.response));
  if (has_integrators) name.append(", ").append(name_of(settings.integrator));
  if (!variant.name.empty()) name += ", " + variant.name;
  if (settings.precision == Precision::float32) name += ", float";
  return name;
}

/// The name of the response for its default integrator and solver; for others, the setting that differs.
std::string label_of(const Settings& settings, const Variant& variant, bool is_own) {
  if (!variant.name.empty()) return "+ " + variant.name;
  return is_own ? std::string(name_of(settings.response)) : "+ " + std::string(name_of(settings.integrator));
}

void add_methods(Response response, std::vector<ContactMethod>& list) {
  std::vector<Integrator> integrators;
  std::vector<Precision> precisions;
  for (const std::string_view name : kNames<Integrator>) {
    if (name != "auto" && goes_with(response, "integrator", name)) integrators.push_back(named<Integrator>(name));
  }
  for (const std::string_view name : kNames<Precision>) {
    if (goes_with(response, "precision", name)) precisions.push_back(named<Precision>(name));
  }
  Settings own = settings_of(std::string(name_of(response)), 0);
  own.integrator = integrator_of(own);
  for (const Integrator integrator : integrators) {
    for (const Variant& variant : variants_of(response)) {
      for (const Precision precision : precisions) {
        Settings settings = own;
        settings.integrator = integrator;
        settings.precision = precision;
        variant.apply(settings);
        const bool is_own = integrator == own.integrator;
        const bool is_main = is_own && variant.name.empty() && precision == Precision::float64;
        list.push_back({name_of(settings, variant, integrators.size() > 1), label_of(settings, variant, is_own),
                        role_of(name_of(response)), is_main, settings});
      }
    }
  }
}

}  // namespace

const std::vector<ContactMethod>& contact_methods() {
  static const std::vector<ContactMethod> table = [] {
    std::vector<ContactMethod> list;
    for (const std::string_view name : kNames<Response>) add_methods(named<Response>(name), list);
    return list;
  }();
  return table;
}

bool is_float_of_main(const ContactMethod& method) {
  return std::any_of(contact_methods().begin(), contact_methods().end(), [&](const ContactMethod& other) {
    return other.is_main && other.name + ", float" == method.name;
  });
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
