#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// (I₃ω₃)² over the least value with which a steady precession exists; infinite for a hanging top.
double excess(double I1, double I3, double mgl, double omega3, double theta) {
  return pow(I3 * omega3, 2) / max(4 * I1 * mgl * cos(theta), 0.0);
}

/// The component across the vertical plane of dL/dt − τ, in units of sin θ, while the axis goes round at a rate.
double missing_torque(double I1, double I3, double mgl, double omega3, double theta, double rate) {
  const Vector3d axis(sin(theta), 0, cos(theta)), vertical = z_axis;
  const Vector3d omega = rate * vertical + (omega3 - rate * cos(theta)) * axis;
  const Vector3d L = I1 * omega + (I3 - I1) * omega3 * axis;
  return cross(rate * vertical, L).y() / sin(theta) - mgl;
}

/// Newton's method on it. It is quadratic in the rate, so that from outside the roots it cannot go astray.
double root_from(double I1, double I3, double mgl, double omega3, double theta, double rate) {
  for (int i = 0; i < 200; ++i) {
    const auto at = [&](double x) { return missing_torque(I1, I3, mgl, omega3, theta, x); };
    const double change = at(rate) / (I3 * omega3 - 2 * I1 * cos(theta) * rate);
    rate -= change;
    if (abs(change) <= 1e-16 * abs(rate)) break;
  }
  return rate;
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_steady_precession(Exercise& e) {
  e.wrong("These are the limits for a fast top, mgl/(I₃ω₃) and I₃ω₃/(I₁ cos θ); the exact rates differ.", "fast_top",
          [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
            return Vector2d(mgl / (I3 * omega3), I3 * omega3 / (I1 * cos(theta)));
          });
  e.wrong("These are the limits for a fast top, mgl/(I₃ω₃) and I₃ω₃/(I₁ cos θ); the exact rates differ.",
          "fast_top_in_order", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
            const double slow = mgl / (I3 * omega3), fast = I3 * omega3 / (I1 * cos(theta));
            return abs(fast) < abs(slow) ? Vector2d(fast, slow) : Vector2d(slow, fast);
          });
  e.wrong("The inclination does not enter your rates; the level part of L contains cos θ.", "no_cosine",
          [](auto I1, auto I3, auto mgl, auto omega3, auto) {
            return steady_precession(I1, I3, min(mgl, 0.999 * pow(I3 * omega3, 2) / (4 * I1)), omega3, 1e-9);
          });
  e.wrong_output("The fast precession stands first; the rate of smaller magnitude is asked for first.", "order",
                 reversed);
  e.wrong(spin_as_psi_rate, "spin_as_psi_rate", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
    const double a = (I1 - I3) * cos(theta), b = I3 * omega3, root = sqrt(max(b * b - 4 * a * mgl, 0.0));
    const double larger = (b + copysign(root, b)) / 2;
    return Vector2d(mgl / larger, larger / a);
  });
  e.wrong("mgl sin θ stands where mgl belongs: the level part of L has the factor sin θ too, and it drops out.",
          "sine_on_one_side", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
            return steady_precession(I1, I3, mgl * sin(theta), omega3, theta);
          });
  e.wrong(
      {"The slow rate comes from a difference of two nearly equal numbers, and digits are lost; the product of both "
       "rates gives it without one.",
       "heavy_top_steady"},
      "difference", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
        const double a = I1 * cos(theta), b = I3 * omega3, root = copysign(sqrt(b * b - 4 * a * mgl), b);
        return Vector2d((b - root) / (2 * a), (b + root) / (2 * a));
      });
  e.template wrong_input<2>(weight_sign, "hanging", negated);
  e.template wrong_input<4>("The angle is counted from the downward vertical here; θ is the angle to the upward one.",
                            "from_below", [](double& theta) { theta = pi - theta; });
  e.template wrong_input<4>("Sine and cosine of the inclination are exchanged.", "sine",
                            [](double& theta) { theta = acos(copysign(sin(theta), cos(theta))); });
  e.wrong_output("Both rates have the wrong sign.", "sense", negated);
}

}  // namespace

void judge_steady_precession(Lecture& lecture) {
  auto& e = lecture.exercise(&steady_precession,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"mgl", positive(joule)},
                              {"omega3", nonzero(rad_per_s)},
                              {"theta", positive(rad)}},
                             {"rates", rad_per_s});
  e.domain([](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
    return is_top(I1, I3) && theta < pi && abs(cos(theta)) >= 0.01 &&
           excess(I1, I3, mgl, omega3, theta) >= pow(1.001, 2);
  });
  e.generated([](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
    const double size = pow(I3 * omega3, 2) / (4 * I1 * mgl * abs(cos(theta)));
    return size > 1e-6 && size < 1e10;
  });
  e.worked("a small top", top_I1, top_I3, top_mgl, 150, 0.5);
  e.worked("the toy top of the lecture", 3.28e-4, 6.6e-5, 0.0456, 200, 30 * degree);
  e.worked("a gyroscope below its support", top_I1, top_I3, top_mgl, -40, 2.5);
  e.special("almost balanced: the rates differ by ten powers of ten", top_I1, top_I3, 1e-8, 2000, 0.5);
  e.special("just fast enough", top_I1, top_I3, top_mgl, 1.0011 * 108.86621079036 * sqrt(cos(0.5)), 0.5);
  e.special("spin the other way", top_I1, top_I3, top_mgl, -150, 0.5);
  e.special("almost horizontal", top_I1, top_I3, top_mgl, 150, acos(0.011));
  const auto top = [](double sign_of_cosine) {
    return [=](Random& random) {
      const double I1 = random.uniform(1e-4, 6e-4), I3 = I1 * random.uniform(0.15, 1.5);
      const double mgl = random.uniform(0.02, 0.1), theta = random.uniform(0.3, 1.2);
      const double least = 2 * sqrt(I1 * mgl * cos(theta)) / I3;
      return tuple{I1, I3, mgl, random.sign() * least * random.uniform(1.1, 2),
                   sign_of_cosine > 0 ? theta : pi - theta};
    };
  };
  e.random("any top", 6, top(1));
  e.random("hanging below its support", 5, top(-1));
  e.random("a very fast top", 2, [](Random& random) {
    const double I1 = random.uniform(1e-4, 6e-4), I3 = I1 * random.uniform(0.15, 1.5), theta = random.uniform(0.3, 1.2);
    const double mgl = random.uniform(1e-8, 1e-7), least = 2 * sqrt(I1 * mgl * cos(theta)) / I3;
    return tuple{I1, I3, mgl, random.sign() * least * random.uniform(1e4, 4e4), theta};
  });
  e.scale([](auto... inputs) { return Vector2d(steady_precession(inputs...).cwiseAbs()); });
  e.sweep<3>({"A small top at θ = 0.5: the slow and the fast precession", "spin ω₃ (rad/s)", "rate (rad/s)"},
             {{"slow", 0}, {"fast", 1}}, {102.1, 250});

  mistakes_of_steady_precession(e);
  e.survivor("std::copysign( -std::sqrt", "std::copysign takes the magnitude of its first argument.");
  e.angles_read_as_degrees();
  e.route("dL/dt − τ in space, by Newton's method", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
    const double far = 2 * I3 * omega3 / (I1 * cos(theta));
    return Vector2d(root_from(I1, I3, mgl, omega3, theta, 0), root_from(I1, I3, mgl, omega3, theta, far));
  });
  e.route("corrections to the fast top, until nothing changes",
          [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
            const double a = I1 * cos(theta), b = I3 * omega3;
            double slow = 0;
            for (int i = 0; i < 1000; ++i) slow = mgl / (b - a * slow);
            return Vector2d(slow, b / a - slow);
          });
  e.route("a triangle", [](auto I1, auto I3, auto mgl, auto omega3, auto theta) {
    const double a = I1 * cos(theta), b = I3 * omega3, middle = sqrt(mgl / abs(a)), ratio = 2 * sqrt(abs(a) * mgl) / b;
    const double half = tan((a > 0 ? asin(ratio) : atan(ratio)) / 2);
    return Vector2d(middle * half, copysign(middle, a) / half);
  });
}
