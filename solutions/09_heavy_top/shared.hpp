#pragma once

#include "rigid/heavy_top.hpp"
#include "solutions/08_kinetic_energy/shared.hpp"

// The top of the cases that were computed elsewhere: kg m², kg m², J.
inline constexpr double top_I1 = 4e-4, top_I3 = 9e-5, top_mgl = 0.06;

// One mistake, one sentence: these serve several exercises.
inline constexpr const char* weight_sign =
    "The weight has the wrong sign in your result: there it drives the axis upwards.";
inline constexpr const char* spin_as_psi_rate =
    "ψ̇ and the component of ω along the axis are confused: the precession has a part of this component.";
inline constexpr auto spin_confused = [](auto, auto, auto, auto theta, Vector3d& rates) {
  rates[2] -= rates[0] * cos(theta);
};
inline constexpr auto let_go_from_rest = [](auto, auto, auto, auto theta, Vector3d& rates) {
  rates = Vector3d(0, 0, rates[2] + rates[0] * cos(theta));
};

/// A body that can rest on its axis: I₃ ≤ 2 I₁, as for every body about a point of its axis.
inline bool is_top(double I1, double I3) { return I3 <= 2 * I1 * (1 + 1e-12); }

/// A heavy top in motion: what an exercise on its nutation gets.
using Start = std::tuple<double, double, double, double, Vector3d>;

/// Nutation of at least `width`, and sin θ of at least `away` at both limits.
inline bool nutates(const Start& start, double width, double away) {
  const auto& [I1, I3, mgl, theta, rates] = start;
  if (!is_top(I1, I3) || theta >= pi || sin(theta) < away) return false;
  const Vector2d limits = nutation_limits(I1, I3, mgl, theta, rates);
  return limits[1] - limits[0] >= width && sin(limits[0]) >= away && sin(limits[1]) >= away;
}

/// A top whose rates, in its body and in space, are comparable: no wrong answer is nearly right.
inline Start any_nutation(Random& random) {
  while (true) {
    const double I1 = random.uniform(1e-4, 6e-4), I3 = I1 * random.uniform(0.15, 1.5), mgl = random.uniform(0.02, 0.1);
    const double theta = random.uniform(0.3, 1.2) + (random.sign() > 0 ? 0 : 1.6), rate = sqrt(mgl / I1);
    const double phi_rate = random.sign() * rate * random.uniform(0.2, 0.8);
    const double theta_rate = random.sign() * rate * random.uniform(0.1, 0.5);
    const double spin = random.sign() * rate * random.uniform(1, 4) * I1 / I3;
    Start start{I1, I3, mgl, theta, Vector3d(phi_rate, theta_rate, spin - phi_rate * cos(theta))};
    if (nutates(start, 0.1, 0.1)) return start;
  }
}

inline const std::vector<Named> arguments_of_nutation{{"I1", positive(kg_m2)},
                                                      {"I3", positive(kg_m2)},
                                                      {"mgl", positive(joule)},
                                                      {"theta", positive(rad)},
                                                      {"rates", rad_per_s}};

// A small top without spin that goes round on a cone at the inclination 2.2, and swings when it is tapped with 0.1
// rad/s.
inline const double rate_on_cone = sqrt(top_mgl / (-top_I1 * cos(2.2)));
inline const double frequency_on_cone = rate_on_cone * sqrt(1 + 3 * pow(cos(2.2), 2));
inline const double tapped_by = 0.1 / frequency_on_cone;

// The fast top of the cases: it nods as a free body does, but for twice the part of its precession along the axis.
inline const double fast_spin = top_I3 * 800 / top_I1, fast_precession = top_mgl / top_I1 / fast_spin;
inline const double fast_nods = fast_spin - 2 * fast_precession * cos(0.5);

/// Domain and cases of all exercises on nutation.
template <class Exercise>
void describe_starts(Exercise& e) {
  e.domain([](auto&... inputs) { return nutates(Start(inputs...), 1e-3, 0.01); });
  e.worked("a small top", top_I1, top_I3, top_mgl, 0.5, {2, 0.5, 150});
  e.worked("slow, and below its support", top_I1, top_I3, top_mgl, 2.2, {3, 1, 12});
  e.special("let go from rest: cusps", top_I1, top_I3, top_mgl, 0.5, {0, 0, 150});
  e.special("pushed backwards: loops", top_I1, top_I3, top_mgl, 0.5, {-6, 0, 150});
  e.special("pushed forwards: waves", top_I1, top_I3, top_mgl, 0.5, {3, 0, 150});
  e.special("spin the other way", top_I1, top_I3, top_mgl, 0.5, {2, 0.5, -150});
  e.special("a fast top, with a nutation of 0.0045", top_I1, top_I3, top_mgl, 0.5, {0, 0, 800});
  e.special("close to the vertical", top_I1, top_I3, top_mgl, 0.02, {25, 0.3, 90});
  e.special("without spin: a spherical pendulum", top_I1, top_I3, top_mgl, 2.2, {4, 1, -4 * cos(2.2)});
  e.special("a conical pendulum, tapped", top_I1, top_I3, top_mgl, 2.2, {rate_on_cone, 0.1, -rate_on_cone * cos(2.2)});
  e.special("a flat top", 2e-4, 3e-4, 0.03, 1.2, {-3, 2, 20});
  e.random("any top", 10, any_nutation);
  e.survivor("halving", "One halving more or less changes no digit.");
  e.survivor(">= 0 ? inside", "Where the square is exactly zero the limit is found.");
  e.survivor("towards(-", "Below −1 the cubic is negative: no root is met twice.");
  e.survivor("outside = - vertical", "The formula does not change when the two limits are exchanged.");
}

/// The axis of a top followed in space without angles, through three limits of its nutation: with n along the axis and
/// ℓ = L/I₁ there ṅ = ℓ × n and ℓ̇ = (mgl/I₁) ẑ × n.
struct Followed {
  explicit Followed(const Start& start) {
    const auto& [I1, I3, mgl, theta, rates] = start;
    using State = Eigen::Matrix<double, 6, 1>;
    const double pull = mgl / I1, spin = rates[0] * cos(theta) + rates[2];
    const auto stepped = [&](const State& state, double h) {
      return one_step_on(state, h, [&](const State& now) -> State {
        const Vector3d n = now.head<3>(), l = now.tail<3>();
        State rate;
        rate << cross(l, n), pull * cross(z_axis, n);
        return rate;
      });
    };
    const auto rises = [](const State& state) { return state[3] * state[1] > state[4] * state[0]; };  // (ℓ × n)_z > 0
    const Vector3d n(sin(theta), 0, cos(theta));
    State state;
    state << n, rates[0] * z_axis + rates[1] * y_axis + (rates[2] + (I3 / I1 - 1) * spin) * n;
    double time = 0, azimuth = 0;
    const auto go = [&](double h) {
      const State next = stepped(state, h);
      azimuth += std::remainder(atan2(next[1], next[0]) - atan2(state[1], state[0]), 2 * pi);
      time += h;
      state = next;
    };
    const double h = 4e-3 / sqrt(pow(I3 / I1 * spin, 2) + 2 * pull + rates.head<2>().squaredNorm());
    go(h);
    for (int limit = 0, steps = 0; limit < 3 && steps < 1'000'000; ++steps) {
      const bool rose = rises(state);
      double before = 0, after = h;
      if (rises(stepped(state, h)) != rose) {
        for (int i = 0; i < 50; ++i) {
          const double middle = (before + after) / 2;
          (rises(stepped(state, middle)) == rose ? before : after) = middle;
        }
      }
      go(after);
      if (rises(state) == rose) continue;
      theta_at[limit] = atan2(hypot(state[0], state[1]), state[2]);
      time_at[limit] = time;
      azimuth_at[limit++] = azimuth;
    }
  }
  Vector3d theta_at = zero, time_at = zero, azimuth_at = zero;
};

/// u = cos θ moves by u̇² = w (u − low)(high − u)(third − u), here with the roots by the closed formula.
struct Cubic {
  explicit Cubic(const Start& start) {
    const auto& [I1, I3, mgl, theta, rates] = start;
    b = I3 * (rates[0] * cos(theta) + rates[2]) / I1;
    a = pow(sin(theta), 2) * rates[0] + b * cos(theta);
    beta = 2 * mgl / I1;
    const double alpha = pow(sin(theta) * rates[0], 2) + pow(rates[1], 2) + beta * cos(theta);
    // u³ + c₂u² + c₁u + c₀ = 0 with three real roots, by cosines
    const double c2 = -(alpha + b * b) / beta, c1 = 2 * a * b / beta - 1, c0 = (alpha - a * a) / beta;
    const double q = (c2 * c2 - 3 * c1) / 9, r = (2 * c2 * c2 * c2 - 9 * c2 * c1 + 27 * c0) / 54;
    const double angle = acos(clamp(r / pow(q, 1.5), -1.0, 1.0)) / 3;
    const auto root = [&](double turn) { return -2 * sqrt(q) * cos(angle + turn) - c2 / 3; };
    low = root(0), high = root(-2 * pi / 3), third = root(2 * pi / 3);
  }
  /// ∫ f(u) dt over one nutation, by the substitution u = low + (high − low) sin²χ, which has no ends.
  template <class Function>
  double over_one_nutation(const Function& f) const {
    constexpr int points = 4000;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double u = low + (high - low) * pow(sin((i + 0.5) * pi / points), 2);
      sum += f(u) / sqrt(beta * (third - u));
    }
    return 2 * pi / points * sum;
  }
  double phi_rate(double u) const { return (a - b * u) / (1 - u * u); }
  double m() const { return (high - low) / (third - low); }
  double a, b, beta, low, high, third;
};
