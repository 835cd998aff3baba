// SPDX-License-Identifier: MIT
// The motion of the penalty response, by any integrator. In each pass the integrator asks for the forces once:
//
//     before_forces() ──▶ candidates ──▶ forces ──▶ after_forces()        src/integrate
#pragma once

#include "integrate/explicit_euler.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
#include "integrate/velocity_verlet.h"
#include "methods/methods.h"
#include "response/penalty.h"
#include "world/motion.h"

namespace ballpit {

template <class V, class Exec, class Integrator>
class ForceMotion final : public Motion<V, Exec> {
  using Real = Scalar<V>;
  using Saved = typename Motion<V, Exec>::Saved;

 public:
  /// `keeps_tally`: impulses will be recorded.
  ForceMotion(const PenaltyLaw<Real>& law, bool keeps_tally)
      : response_(law, keeps_tally), integrator_(response_.depends_on_velocity()) {}

  /// Forces of pairs that do not touch are 0, so a candidate list is not tested first.
  ContactKind contact_kind(const Exec& exec) const override {
    return response_.adds_in_order(exec) ? ContactKind::near : ContactKind::near_by_body;
  }

  bool can_repeat() const override { return true; }

  int first_pass(const BodyStore<V, Exec>& bodies) const override { return integrator_.first_pass(bodies.count()); }
  int passes() const override { return Integrator::kPasses; }
  bool counts_collisions(int pass) const override { return pass == Integrator::kCollisionPass; }

  bool before_contacts(BodyStore<V, Exec>& bodies, Real h, int pass) override {
    return integrator_.before_forces(bodies, h, pass);
  }
  bool respond(BodyStore<V, Exec>& bodies, const ContactsView<V>& pairs, Real h, int pass,
               const ImpulseNotes<V>& notes) override {
    response_.accelerate(bodies, pairs, integrator_.duration(h, pass), notes, integrator_.acceleration(bodies.count()));
    return false;
  }
  bool after_contacts(BodyStore<V, Exec>& bodies, Real h, int pass) override {
    return integrator_.after_forces(bodies, h, pass);
  }

  double elastic_energy(const BodyStore<V, Exec>& bodies, Span<const Pair> pairs) const override {
    return response_.elastic_energy(bodies.exec(), bodies.view(), bodies.box(), pairs);
  }

  typename Exec::template Buffer<V>* kept() override { return integrator_.kept(); }

  Saved save(Exec& exec) override {
    Saved saved;
    if (kept()) saved.acceleration = exec.download(kept()->span());
    return saved;
  }
  void restore(Exec& exec, const Saved& saved) override {
    if (kept()) exec.upload(*kept(), saved.acceleration);
  }

  int64_t bytes() const override { return response_.bytes() + integrator_.bytes(); }

 private:
  PenaltyResponse<V, Exec> response_;
  Integrator integrator_;
};

template <class Real>
PenaltyLaw<Real> penalty_law(const Scene& scene, const Settings& settings) {
  const Physics& physics = scene.physics;
  const bool ends_with_force = settings.contact_end == ContactEnd::force,
             has_walls = scene.domain.boundary != Boundary::periodic;
  return {static_cast<Real>(physics.stiffness),
          static_cast<Real>(damping_of(physics.restitution, ends_with_force)),
          has_walls ? static_cast<Real>(damping_of(physics.wall_restitution, ends_with_force)) : Real(0),
          static_cast<Real>(physics.shear),
          physics.law == "hertz",
          ends_with_force};
}

template <class V, class Exec>
std::unique_ptr<Motion<V, Exec>> make_penalty_motion(const Scene& scene, const Settings& settings) {
  const PenaltyLaw<Scalar<V>> law = penalty_law<Scalar<V>>(scene, settings);
  const auto make = [&]<class Method>() -> std::unique_ptr<Motion<V, Exec>> {
    return std::make_unique<ForceMotion<V, Exec, Method>>(law, settings.keeps_tally);
  };
  const auto integrator = integrator_of(settings);
  if (integrator == Integrator::explicit_euler) return make.template operator()<ExplicitEuler<V, Exec>>();
  if (integrator == Integrator::symplectic_euler) return make.template operator()<SymplecticEuler<V, Exec>>();
  if (integrator == Integrator::velocity_verlet) return make.template operator()<VelocityVerlet<V, Exec>>();
  if (integrator == Integrator::rk4) return make.template operator()<RungeKutta4<V, Exec>>();
  throw std::logic_error("forces need an integrator");
}

}  // namespace ballpit
