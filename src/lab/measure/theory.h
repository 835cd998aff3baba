// SPDX-License-Identifier: MIT
// Closed forms and reference values that experiments are held against. Nothing here was measured with this program.
// Units are those of the arguments; of a gas of hard spheres, diameter, mass and kT are 1.
#pragma once

namespace ballpit {

// A gas of hard spheres at the number density rho.

/// Z = PV/(N·kT) by Carnahan and Starling 1969, doi 10.1063/1.1672048: good to 0.3 %.
double carnahan_starling_z(double rho);

/// Z to 4e-5 for rho from 0.2 to 1.03: Kolafa, Labík, Malijevský 2004, doi 10.1039/b402792b.
double reference_z(double rho);

/// Z of `count` spheres in a periodic box: Z − ρχ·P''(ρ)/(2N), where P = ρZ and χ = 1/P'. The number of spheres is fixed, that
/// of an infinite gas in the same volume is not: Lebowitz and Percus 1961, doi 10.1103/PhysRev.124.1673.
double finite_z(double rho, double count);

/// Z_N where each hit is seen half a step late, as at a mean speed of approach of √π: spheres seem smaller by √π/2·dt.
double late_contact_z(double rho, double count, double dt);

/// Collisions of a sphere in a unit of time: (6/√π)·(Z_N − 1), and a factor for the speeds of so many spheres at total
/// momentum zero.
double collision_rate(double rho, double count);

/// τ of Haff's law T = T₀·(1 + t/τ)⁻²: 6/((1 − e²)·Γ₀). Haff 1983, doi 10.1017/S0022112083003419.
double cooling_time(double rho, double count, double restitution);

/// The mean height above their lowest place [m] of hard spheres under gravity whose mean energy is `energy` [J], kinetic and of
/// height: kT/w·(1 + β/2), energy = kT·(5 + β)/2, β = (2π/3)·D³·n₀, the first correction to the barometric formula, and small.
/// `weight` [N] and `diameter` D [m] are those of one, `per_area` [1/m²] are above a unit of the floor, n₀ their density at it.
double barometric_height(double energy, double weight, double diameter, double per_area);

/// The height above its lowest place [m] of a ball that fell from `height` at time 0 and bounces: parabolas, each bounce of which
/// begins with the speed before times `restitution`.
double bouncing_height(double height, double restitution, double gravity, double time);

// A contact of springs and dashpots; mu [kg] is the reduced mass, zeta the damping, v [m/s] the speed of approach.

/// t_c = π/(ω·√(1 − ζ²)), ω = √(k/μ) [s].
double contact_duration(double stiffness, double mu, double zeta);

/// k whose contact lasts so long [N/m].
double stiffness_of_duration(double duration, double mu, double zeta);

/// t_c of Hertz's contact without damping: 2.943275·δ_max/v, δ_max = (5μv²/(4K))^0.4 [s].
double hertz_duration(double stiffness, double mu, double v);

// Where methods fail.

/// The largest stable step of springs in an fcc packing, twelve contacts each: √(m/(2k)) [s].
double stable_step_fcc(double stiffness, double mass);

/// The largest v·dt/D at which a hit with the impact parameter b/D is seen for certain: 2·√(1 − (b/D)²), the chord.
double certain_step(double impact);

/// The part of hits seen at the step s = v·dt/D and the impact parameter b/D; the same over all impact parameters.
double part_seen(double step, double impact);
double mean_part_seen(double step);

/// The part of touching pairs, directions uniform, that cells of edge c (in diameters) find:
/// ⟨∏ clamp(2 − |n_a|/c, 0, 1)⟩ over unit vectors n.
double cell_recall(double edge);

/// Sweeps of Gauss–Seidel to a percent. In a stack of n each leaves cos²(π/2n), which makes 1.866·n² of them. Under a sphere `ratio`
/// times as heavy as its carrier each leaves ratio/(ratio + 1): 4.6·(ratio + 1), nearly.
double stack_sweeps(double n);
double ratio_sweeps(double ratio);

/// The largest v·dt [m] that rounding to float takes away at x [m]: half the distance of float's numbers.
double frozen_step(double x);

}  // namespace ballpit
