#include "solutions/05_euler_equations/shared.hpp"

namespace {

/// The period of swings about the meridian with I1 φ″ = −(level rate) (momentum) φ.
template <class Momentum>
auto swinging(const Momentum& momentum) {
  return [momentum](auto I1, auto I3, auto spin, auto latitude, auto rate) {
    const double level = rate * cos(latitude);
    return 2 * pi * sqrt(I1 / (level * momentum(I1, I3, spin, level)));
  };
}

/// The axle and its velocity in space, on the axes east, north, up of the time 0.
using Axle = Eigen::Matrix<double, 3, 2>;

/// Four times the time from a small angle to the meridian. The float adds the acceleration that keeps the axle level.
double period_in_space(double I1, double I3, double spin, double latitude, double rate) {
  const Vector3d ground = rate * Vector3d(0, cos(latitude), sin(latitude));
  const double angle = 1e-3, way = copysign(1, spin), ratio = I3 / I1 * (spin + way * ground[1]);
  const double step = 1e-3 * gyrocompass_period(I1, I3, spin, latitude, rate);
  const auto at_rest = [&](const Vector3d& axle) { return (Axle() << axle, cross(ground, axle)).finished(); };
  Axle now = at_rest({way * sin(angle), way * cos(angle), 0});
  const auto east_of_meridian = [&](double t) { return way * now.col(0).dot(turn(ground, rate * t) * x_axis); };
  double t = 0, before = angle;
  for (; east_of_meridian(t) > 0; t += step) {
    before = east_of_meridian(t);
    // One step of Runge-Kutta on axes that do not turn; each stage has the vertical of its moment.
    const auto rates_at = [&](const Axle& axle, double time) {
      const Vector3d up = turn(ground, rate * time) * z_axis, e = axle.col(0), v = axle.col(1);
      const Vector3d free = ratio * cross(e, v) - v.squaredNorm() * e;
      const double to_stay_level = -2 * v.dot(cross(ground, up)) - e.dot(cross(ground, cross(ground, up)));
      return (Axle() << v, free + (to_stay_level - free.dot(up)) * up).finished();
    };
    const Axle k1 = rates_at(now, t), k2 = rates_at(now + step / 2 * k1, t + step / 2);
    const Axle k3 = rates_at(now + step / 2 * k2, t + step / 2), k4 = rates_at(now + step * k3, t + step);
    now = now + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double after = east_of_meridian(t);  // of a sine near its zero, whose chord misses by a millionth of a step
  return 4 * (t - step + step * before / (before - after));
}

/// Four times the time that the energy of a swing of 10⁻⁴ rad gives, by the midpoint rule in φ = angle · sin χ.
double period_by_energy(double I1, double I3, double spin, double latitude, double rate) {
  const double level = rate * cos(latitude), L = I3 * (abs(spin) + level), angle = 1e-4;
  constexpr int points = 8;
  double time = 0;
  for (int i = 0; i < points; ++i) {
    const double phi = angle * sin(pi / 2 * (i + 0.5) / points);
    const double released = 2 * L * level * sin((angle + phi) / 2) * sin((angle - phi) / 2) -
                            I1 * level * level / 2 * sin(angle + phi) * sin(angle - phi);
    time += 2 * pi / points * sqrt(I1 * (angle - phi) * (angle + phi) / (2 * released));
  }
  return time;
}

}  // namespace

void judge_gyrocompass_period(Lecture& lecture) {
  auto& e = lecture.exercise(&gyrocompass_period,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"spin", rad_per_s},
                              {"latitude", rad},
                              {"ground_rate", positive(rad_per_s)}},
                             {"period", second});
  e.domain([](auto I1, auto I3, auto spin, auto latitude, auto rate) {
    return I3 <= 2 * I1 && abs(latitude) <= 1.5 && I3 * abs(spin) > I1 * rate;
  });
  const double earth = 7.292115e-5;
  e.worked("a bicycle wheel on a turntable", 0.07, 0.13, 25, 0.7, 2);
  e.worked("the compass of a ship at 54° north", 0.012, 0.02, 2000, 54 * degree, earth);
  e.special("on the equator", 0.012, 0.02, 2000, 0, earth);
  e.special("south of the equator, spinning the other way", 0.012, 0.02, -2000, -54 * degree, earth);
  e.special("a rotor with equal moments", 0.05, 0.05, 12, 0.7, 2);
  e.special("a long rotor that spins slowly", 0.07, 0.02, -10, 0.4, 2);
  e.special("near the pole", 0.012, 0.02, 2000, 1.45, earth);
  e.limit("on the equator", 2 * pi * sqrt(0.012 / (0.02 * 2000 * earth)),
          "A fast rotor on the equator swings as a pendulum does: the torque on an axle that points off north is the "
          "spin's angular momentum times the rotation of the ground, times the sine.");
  e.limit("near the pole", 2 * pi * sqrt(0.012 / (0.02 * 2000 * earth * cos(1.45))),
          "Only the horizontal part of the ground's rotation draws the axle to the north; near the pole little of it "
          "is left, and the swings become slow.");
  e.random("a wheel on a turntable", 10, [](Random& random) {
    const double I1 = random.uniform(0.03, 0.2), rate = random.uniform(1, 4);
    const double I3 = I1 * (random.sign() > 0 ? random.uniform(1.3, 2) : random.uniform(0.3, 0.7));
    const double spin = random.sign() * I1 / I3 * rate * random.uniform(2, 15);
    return tuple(I1, I3, spin, random.sign() * random.uniform(0.2, 0.6) + (random.whole(0, 1) == 1 ? 0.7 : 0.0), rate);
  });
  e.tolerance(
      1e-6, "Swings of a thousandth of a radian, as an integration may take, change the period by 10⁻⁷ of it at most.");
  e.sweep<3>({"A bicycle wheel that spins with 25 rad/s on a turntable with 2 rad/s", "latitude (rad)", "period (s)"},
             {{"period"}}, {-1.5, 1.5});

  e.wrong_input<3>("The vertical part of the ground's rotation enters; it carries housing and axle round alike.",
                   "vertical_part", complement);
  e.wrong("The swing has the moment I₃; the axle turns about the vertical, which is a diameter of the rotor.",
          "axial_moment", [](auto I1, auto I3, auto spin, auto latitude, auto rate) {
            return sqrt(I3 / I1) * gyrocompass_period(I1, I3, spin, latitude, rate);
          });
  e.wrong("The terms of second order in the ground's rate are missing; on a turntable they count.", "slow_ground",
          swinging([](auto, auto I3, auto spin, auto) { return I3 * abs(spin); }));
  e.wrong("The spin serves as the whole of ω₃; it is relative to the housing, which the ground carries round.",
          "spin_is_total",
          swinging([](auto I1, auto I3, auto spin, auto level) { return I3 * abs(spin) - I1 * level; }));
  e.wrong(
      "The part of L across the axle is missing: with its axle off the meridian the rotor rotates about a level "
      "diameter too.",
      "no_transverse", swinging([](auto, auto I3, auto spin, auto level) { return I3 * (abs(spin) + level); }));
  e.wrong("A negative spin is subtracted from the ground's rate: then the axle settles to the south, where they add.",
          "always_north",
          swinging([](auto I1, auto I3, auto spin, auto level) { return abs(I3 * (spin + level) - I1 * level); }));
  e.wrong_output("This is the time of half a swing, from one side to the other.", "half_swing", times(0.5));
  e.wrong_output("This is the reciprocal of the angular frequency; a period is 2π times as long.", "radians",
                 times(0.5 / pi));
  e.route("the torque about the vertical that would hold the axle",
          [](auto I1, auto I3, auto spin, auto latitude, auto rate) {
            // The axes of the vehicle lie across the axle, up and along it.
            const auto held_by = [&](double phi) {
              const double level = rate * cos(latitude);
              return gyroscopic_torque(I1, I3, abs(spin) + level * (1 - cos(phi)),
                                       {-level * sin(phi), rate * sin(latitude), level * cos(phi)})[1];
            };
            return 2 * pi * sqrt(I1 / abs(derivative_at_0(held_by, 0.02)));
          });
  e.route("the axle integrated in space", period_in_space);
  e.route("the energy of a swing", period_by_energy);
}
