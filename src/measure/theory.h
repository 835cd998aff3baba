// SPDX-License-Identifier: MIT
// Closed forms and reference values with which experiments are compared. None was measured with this program. Units are
// those of the arguments; in a gas of hard spheres, diameter, mass and kT are 1.
#pragma once

namespace ballpit {

// A gas of hard spheres at the number density rho.

/// Z = PV/(N·kT) by Carnahan and Starling 1969, doi 10.1063/1.1672048: good to 0.3 %.
double carnahan_starling_z(double rho);

/// Z to 4e-5 for rho from 0.2 to 1.03: Kolafa, Labík, Malijevský 2004, doi 10.1039/b402792b.
double reference_z(double rho);

/// Z of `count` spheres in a periodic box: Z − ρχ·P''(ρ)/(2N), where P = ρZ and χ = 1/P'. Here the number of spheres in
/// the volume is fixed; in an infinite gas it fluctuates. Lebowitz and Percus 1961, doi 10.1103/PhysRev.124.1673.
double finite_z(double rho, double count);

/// Z_N if each hit is found half a step late: with a mean speed of approach of √π, spheres seem smaller by √π/2·dt.
double late_contact_z(double rho, double count, double dt);

/// Collisions of a sphere per unit of time: (6/√π)·(Z_N − 1), times a factor for the speeds of this number of spheres
/// with total momentum 0.
double collision_rate(double rho, double count);

/// τ of Haff's law T = T₀·(1 + t/τ)⁻²: 6/((1 − e²)·Γ₀). Haff 1983, doi 10.1017/S0022112083003419.
double cooling_time(double rho, double count, double restitution);

/// The mean height [m] above their lowest place of hard spheres under gravity whose mean kinetic and potential energy
/// is `energy` [J]: kT/w·(1 + β/2), energy = kT·(5 + β)/2. β = (2π/3)·D³·n₀ is the first, small correction to the
/// barometric formula. `weight` [N] and `diameter` D [m] are those of one sphere, `per_area` [1/m²] spheres stand above
/// a unit of the floor, n₀ is their density there.
double barometric_height(double energy, double weight, double diameter, double per_area);

/// The height [m] above its lowest place of a ball that falls from `height` at time 0 and bounces. Each bounce is a
/// parabola that starts with `restitution` times the previous speed.
double bouncing_height(double height, double restitution, double gravity, double time);

// A contact of springs and dashpots; mu [kg] is the reduced mass, zeta the damping, v [m/s] the speed of approach.

/// t_c = π/(ω·√(1 − ζ²)), ω = √(k/μ) [s].
double contact_duration(double stiffness, double mu, double zeta);

/// The k whose contact lasts this long [N/m].
double stiffness_of_duration(double duration, double mu, double zeta);

/// t_c of Hertz's contact without damping: 2.943275·δ_max/v, δ_max = (5μv²/(4K))^0.4 [s].
double hertz_duration(double stiffness, double mu, double v);

// Where methods fail.

/// The part of hits that contacts at the ends of steps find, at the step s = v·dt/D and the impact parameter b/D: the
/// chord 2·√(1 − (b/D)²) over the step, at most 1.
double part_seen(double step, double impact);

/// The part of touching pairs with uniform directions that cells of edge c [diameters] find:
/// ⟨∏ clamp(2 − |n_a|/c, 0, 1)⟩ over unit vectors n.
double cell_recall(double edge);

/// Sweeps of Gauss–Seidel until one percent of the error is left. In a stack of n spheres each sweep leaves cos²(π/2n),
/// which gives 1.866·n². Under a sphere `ratio` times as heavy as its carrier each leaves ratio/(ratio + 1): about
/// 4.6·(ratio + 1).
double stack_sweeps(double n);
double ratio_sweeps(double ratio);

/// The largest v·dt [m] that is lost at x [m] by rounding to float: half the distance between neighbouring floats.
double frozen_step(double x);

}  // namespace ballpit
