#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// The push in units of p_ψ/I₁, that at which cusps come again, and where between the two verticals φ̇ would vanish.
struct Push {
  Push(double I1, double I3, double mgl, double theta, double phi_rate, double omega3)
      : own(I3 * omega3 / I1),
        size(phi_rate / own),
        cusp(2 * mgl / (I1 * own * own)),
        turning(cos(theta) + pow(sin(theta), 2) * size) {}
  double own, size, cusp, turning;
};

/// Loops, cusps or a wave, as φ̇ goes from one rate to another.
int between(double slowest, double fastest) {
  const double least = min(slowest * fastest, 0.0), size = max(pow(slowest, 2), pow(fastest, 2));
  return min(abs(slowest), abs(fastest)) < 1e-6 * sqrt(size) ? 0 : least < 0 ? -1 : 1;
}

int by_the_other_limit(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
  const double u0 = cos(theta), b = I3 * omega3 / I1, w = 2 * mgl / I1, rate = phi_rate * pow(sin(theta), 2);
  // The cubic of u̇² over u − u₀, with a = b u₀ + rate: (w − …) u² + … = 0 has one root that is an inclination.
  const double a = b * u0 + rate, alpha = rate * phi_rate + w * u0;
  const double c2 = w, c1 = w * u0 - alpha - b * b, c0 = c1 * u0 - w + 2 * a * b;
  const double q = -(c1 + copysign(sqrt(max(c1 * c1 - 4 * c2 * c0, 0.0)), c1)) / 2;
  const double u1 = abs(c0) < abs(q) ? c0 / q : q / c2;
  return between(phi_rate, (a - b * u1) / (1 - u1 * u1));
}

int by_following_the_axis(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
  using State = Eigen::Matrix<double, 6, 1>;  // the axis n, then L/I₁
  const double pull = mgl / I1;
  const Vector3d n(sin(theta), 0, cos(theta));
  State state;
  state << n, phi_rate * z_axis + (I3 * omega3 / I1 - phi_rate * cos(theta)) * n;
  const auto rate_of_n = [](const State& now) { return cross(now.tail<3>(), Vector3d(now.head<3>())); };
  const auto phi_rate_of = [&](const State& now) {
    const Vector3d v = rate_of_n(now);
    return (now[0] * v[1] - now[1] * v[0]) / (now[0] * now[0] + now[1] * now[1]);
  };
  const double fast = sqrt(pow(I3 * omega3 / I1, 2) + 2 * pull + phi_rate * phi_rate);
  const double h = 0.02 / fast;
  double least = phi_rate, most = phi_rate;
  for (int i = 0, limits = 0; limits < 2 && i < 200'000; ++i) {
    const double before = rate_of_n(state)[2];
    state = one_step_on(state, h, [&](const State& now) -> State {
      return (State() << rate_of_n(now), pull * cross(z_axis, Vector3d(now.head<3>()))).finished();
    });
    least = min(least, phi_rate_of(state));
    most = max(most, phi_rate_of(state));
    if (i > 0 && before * rate_of_n(state)[2] <= 0) ++limits;
  }
  return phi_rate == 0 ? 0 : between(least, most);
}

int by_the_potential(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
  const double p_psi = I3 * omega3, p_phi = I1 * pow(sin(theta), 2) * phi_rate + p_psi * cos(theta);
  if (phi_rate == 0) return 0;
  if (abs(p_phi) >= abs(p_psi)) return 1;
  const double energy = effective_potential(I1, I3, mgl, p_phi, p_psi, theta);
  return effective_potential(I1, I3, mgl, p_phi, p_psi, acos(p_phi / p_psi)) < energy ? -1 : 1;
}

}  // namespace

void judge_path_type(Lecture& lecture) {
  auto& e = lecture.exercise(&path_type,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"mgl", positive(joule)},
                              {"theta", positive(rad)},
                              {"phi_rate", rad_per_s},
                              {"omega3", nonzero(rad_per_s)}},
                             {"type", none});
  e.domain([](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
    if (!is_top(I1, I3) || theta >= pi || sin(theta) < 1e-2) return false;
    const Push push(I1, I3, mgl, theta, phi_rate, omega3);
    return phi_rate == 0 || (abs(push.size) > 1e-3 * min(push.cusp, 1.0) && abs(push.size / push.cusp - 1) > 1e-3 &&
                             abs(abs(push.turning) - 1) > 1e-3);
  });
  // In a few million steps an axis can be followed only where its rates are comparable.
  e.generated([](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
    const Push push(I1, I3, mgl, theta, phi_rate, omega3);
    const bool is_clear = phi_rate == 0 || (abs(push.size) > 0.02 * min(push.cusp, 1.0) &&
                                            abs(push.size / push.cusp - 1) > 0.02 && abs(abs(push.turning) - 1) > 0.02);
    return is_clear && sin(theta) > 0.1 && push.cusp > 1e-3 && push.cusp < 1e3 && abs(push.size) < 50;
  });
  constexpr double toy_I1 = 3.28e-4, toy_I3 = 6.6e-5, toy_mgl = 0.0456, at = 40 * degree;
  e.worked("released at rest", toy_I1, toy_I3, toy_mgl, at, 0, 200);
  e.worked("a gentle push forwards", toy_I1, toy_I3, toy_mgl, at, 5, 200);
  e.worked("a push backwards", toy_I1, toy_I3, toy_mgl, at, -4, 200);
  e.worked("a strong push forwards", toy_I1, toy_I3, toy_mgl, at, 10, 200);
  e.worked("a push past the vertical", toy_I1, toy_I3, toy_mgl, at, 30, 200);
  e.special("released at rest, below its support", toy_I1, toy_I3, toy_mgl, 2.2, 0, -90);
  e.special("so slow that no push forwards makes loops", toy_I1, toy_I3, toy_mgl, at, 12, 80);
  e.special("so slow, and pushed more", toy_I1, toy_I3, toy_mgl, at, 30, 80);
  e.special("backwards past the lower vertical", toy_I1, toy_I3, toy_mgl, 2.2, -40, 200);
  e.special("a little less than cusps", toy_I1, toy_I3, toy_mgl, at, 6.9 * 0.99, 200);
  e.special("a little more than cusps", toy_I1, toy_I3, toy_mgl, at, 6.92 * 1.01, 200);
  const auto push_of = [](double from, double to) {
    return [from, to](Random& random) {
      const double across = random.uniform(2e-4, 6e-4), ratio = random.uniform(0.15, 1.5);
      const double weight = random.uniform(0.02, 0.1), theta = random.uniform(0.5, 1.2) + (random.sign() > 0 ? 0 : 1);
      const double cusp = random.uniform(0.1, 0.2), own = random.sign() * sqrt(2 * weight / across / cusp);
      return tuple{across, across * ratio, weight, theta, own * cusp * random.uniform(from, to), own / ratio};
    };
  };
  e.random("pushed backwards", 3, push_of(-2, -0.3));
  e.random("pushed forwards, less than the gyroscope formula says", 3, push_of(0.1, 0.4));
  e.random("pushed forwards, less than twice", 3, push_of(0.6, 0.9));
  e.random("pushed forwards, more than twice", 3, push_of(1.1, 2));
  e.random("pushed forwards past the vertical", 3, push_of(22, 30));
  e.random("pushed backwards past the lower vertical", 2, push_of(-60, -50));
  e.scale(1);
  e.sweep<4>(
      {"The toy top released at 40° with 200 rad/s", "push: the first φ̇ (rad/s)", "wave (+1), cusps (0) or loops (−1)"},
      {"type"}, {-10, 30, 161});

  const Sentence forwards{
      "A push forwards always makes a wave here; one beyond twice the rate of the gyroscope formula "
      "makes loops, at the end of a rise.",
      "heavy_top_paths"};
  e.wrong(forwards, "forwards_is_a_wave", [](auto, auto, auto, auto, auto phi_rate, auto omega3) {
    return phi_rate == 0 ? 0 : phi_rate * omega3 < 0 ? -1 : 1;
  });
  e.wrong(forwards, "forwards_only_falls", [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
    const Push push(I1, I3, mgl, theta, phi_rate, omega3);
    return phi_rate == 0 ? 0 : push.size < 0 && abs(push.turning) < 1 ? -1 : 1;
  });
  e.wrong("The sense of the spin does not count here: forwards is the sense in which the top precesses, that of ω₃.",
          "sense_of_the_spin", [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
            return path_type(I1, I3, mgl, theta, phi_rate, abs(omega3));
          });
  e.wrong("The axis is let through the vertical: where |p_φ| is larger than |p_ψ|, φ̇ vanishes at no inclination.",
          "no_vertical", [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
            const Push push(I1, I3, mgl, theta, phi_rate, omega3);
            return phi_rate == 0 ? 0 : push.size < 0 || push.size > push.cusp ? -1 : 1;
          });
  e.wrong("Loops begin here at the rate of the gyroscope formula; at twice that rate is where cusps come again.",
          "once_the_rate", [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
            const Push push(I1, I3, mgl, theta, phi_rate, omega3);
            return phi_rate == 0 ? 0 : abs(push.turning) < 1 && (push.size < 0 || push.size > push.cusp / 2) ? -1 : 1;
          });
  e.wrong(
      "The axis reaches here every inclination at which φ̇ vanishes; it has the energy for it after a push "
      "backwards or a strong one forwards only.",
      "no_energy", [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
        const Push push(I1, I3, mgl, theta, phi_rate, omega3);
        return phi_rate == 0 ? 0 : abs(push.turning) < 1 ? -1 : 1;
      });
  e.wrong_output("Waves and loops are exchanged: 1 means a wave.", "opposite", [](int& type) { type = -type; });
  e.wrong("A release at rest is no special case here; the axis stops again at the upper end of every arc.", "no_cusps",
          [](auto I1, auto I3, auto mgl, auto theta, auto phi_rate, auto omega3) {
            return phi_rate == 0 ? 1 : path_type(I1, I3, mgl, theta, phi_rate, omega3);
          });
  e.route("the rates at both limits", by_the_other_limit);
  e.route("the axis and L followed in space", by_following_the_axis);
  e.route("the effective potential where the precession stops", by_the_potential);
}
