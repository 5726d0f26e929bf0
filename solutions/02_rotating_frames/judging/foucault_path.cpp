#include "solutions/02_rotating_frames/shared.hpp"

/// A pendulum on our Earth or a similar planet, seen neither at the ends of a swing nor at the centre.
static auto a_swing(Random& random) {
  const double length = random.uniform(30, 90), g = random.uniform(9, 12), latitude = generic_latitude(random);
  const double half_period = pi * sqrt(length / g);
  const double t = (random.whole(40, 100) + random.uniform(0.2, 0.8)) * half_period;
  const Vector2d start = random.vector(2).head<2>();
  return tuple{start, length, g, latitude, random.uniform(5e-5, 7.5e-5), t};
}

/// The path with a plane of swing that turns at a multiple of Ω sin λ, another sideways velocity at the release, and
/// with or without the second order in the frequency.
static auto turned(double turns, double release, double second_order) {
  return [=](auto& start, auto length, auto g, auto latitude, auto rate, auto t) -> Vector2d {
    const double vertical = rate * sin(latitude), swing = sqrt(g / length + second_order * vertical * vertical);
    const auto bob = std::complex(start.x(), start.y()) * polar(1.0, -turns * vertical * t) *
                     std::complex(cos(swing * t), release * vertical / swing * sin(swing * t));
    return {bob.real(), bob.imag()};
  };
}

void judge_foucault_path(Lecture& lecture) {
  auto& e = lecture.exercise(&foucault_path,
                             {{"start", metre},
                              {"length", positive(metre)},
                              {"g", positive(m_per_s2)},
                              {"latitude", latitude_angle},
                              {"earth_rate", earth_rate},
                              {"t", not_negative(second)}},
                             {"position", metre});
  e.domain([](auto& start, auto length, auto g, auto, auto rate, auto t) {
    return start.norm() <= length / 10 && length <= 100 && t <= 1800 && rate * rate * t <= 3.2e-5 * sqrt(g / length);
  });
  const Vector2d pushed(2, -1);
  const double our_g = 9.81, paris = 48.8462 * degree;
  e.worked("the Panthéon, after ten minutes", pushed, 67, our_g, paris, our_earth_rate, 604);
  e.worked("the same at 30° south, after 25 minutes", pushed, 67, our_g, -30 * degree, our_earth_rate, 1500);
  e.special("on the equator", pushed, 67, our_g, 0, our_earth_rate, 604);
  e.special("at the pole", {1, 0}, 30, our_g, pi / 2, our_earth_rate, 900);
  e.special("at the moment of release", pushed, 67, our_g, paris, our_earth_rate, 0);
  e.special("after a quarter of a swing", pushed, 67, our_g, paris, our_earth_rate, pi / 2 * sqrt(67 / our_g));
  e.special("a short pendulum", {0, 0.01}, 0.25, our_g, paris, our_earth_rate, 1800);
  e.special("hung at rest", Vector2d::Zero(), 67, our_g, paris, our_earth_rate, 604);
  e.limit("at the moment of release", pushed, "It has not moved yet.");
  e.limit("on the equator", pushed * cos(sqrt(our_g / 67) * 604),
          "The vertical part of the rotation vanishes there, and the plane of the swing stays.");
  e.random("a random pendulum", 10, a_swing);
  e.tolerance(2e-5, "An answer to first order in earth_rate may differ from the exact one by 1.6e-5 of the start.");
  e.scale([](auto& start, auto...) { return or_one(start.norm()); });
  e.sweep({"The bob of the Panthéon 25 minutes after its release 2 m to the east, at other latitudes", "latitude (°)",
           "position of the bob (m)"},
          {"east", "north"}, {-90, 90},
          [](auto degrees) { return tuple(Vector2d(2, 0), 67, 9.81, degrees * degree, our_earth_rate, 1500); });

  e.wrong_input<4>("Your pendulum turns anticlockwise in the north; level motion is deflected to the right there.",
                   "counterclockwise", negated);
  e.wrong_input<3>("The whole rotation enters; level motion feels its vertical part only.", "no_latitude",
                   fixed(pi / 2));
  e.wrong_input<3>("The latitude enters with its cosine; the vertical part is largest at the pole.", "cosine",
                   complement);
  e.wrong_input<3>("Your pendulum turns the same way in the south; the vertical part changes sign on the equator.",
                   "always_northern", without_sign);
  e.wrong("Your pendulum turns at twice the rate: the Coriolis acceleration has a 2, the turning has not.",
          "coriolis_rate", turned(2, 1, 1));
  e.wrong_input<4>("This is the swing of an ordinary pendulum; its plane stays where it is.", "no_rotation",
                   fixed(0.0));
  e.wrong("Your path goes through the centre; a bob at rest on the floor moves sideways where the plane stands still.",
          "turned_plane_only", turned(1, 0, 1));
  e.wrong("The sideways velocity at the release has the wrong sign: the bob is at rest on the floor.", "release_sign",
          turned(1, -1, 1));
  e.angles_read_as_degrees();
  e.route("to first order in the rate, apart from the turning", turned(1, 1, 0));
  e.route("two circular motions", [](auto& start, auto length, auto g, auto latitude, auto rate, auto t) {
    // ζ = A exp(i a t) + B exp(i b t), with a and b the roots of s² + 2 Ω s − g/l = 0; A + B = ζ₀, a A + b B = 0.
    const double vertical = rate * sin(latitude), root = hypot(sqrt(g / length), vertical);
    const double a = root - vertical, b = -root - vertical;
    const auto bob = std::complex(start.x(), start.y()) * (a * polar(1.0, b * t) - b * polar(1.0, a * t)) / (a - b);
    return Vector2d(bob.real(), bob.imag());
  });
  e.route("the exponential of the four equations",
          [](auto& start, auto length, auto g, auto latitude, auto rate, auto t) {
            const double twice = 2 * rate * sin(latitude);
            Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();
            motion.topRightCorner<2, 2>().setIdentity();
            motion.bottomLeftCorner<2, 2>() = -g / length * Eigen::Matrix2d::Identity();
            motion.bottomRightCorner<2, 2>() << 0, twice, -twice, 0;
            const int halvings = 24;
            const Eigen::Matrix4d X = motion * t / std::exp2(halvings);
            // exp(X) − 1 is doubled, not exp(X), or the small steps would be lost beside the 1.
            Eigen::Matrix4d less_one = X + X * X / 2 + X * X * X / 6;
            for (int k = 0; k < halvings; ++k) less_one = 2 * less_one + less_one * less_one;
            const Eigen::Vector4d released(start.x(), start.y(), 0, 0), end = released + less_one * released;
            return Vector2d(end.head<2>());
          });
  e.survivor("swing = ", "Cosine and sine over its argument are even, and Ω² is beyond the tolerance.");
  e.survivor("std::cos( -swing", "The cosine is even.");
}
