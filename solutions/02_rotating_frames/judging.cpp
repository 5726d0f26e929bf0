/// @file
/// How the exercises of lecture 02 are judged.
#include "rigid/rotating_frames.hpp"
#include "solutions/judging/lecture.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace {

using namespace rigid;
using namespace workbook;
using namespace workbook::judging;

using FrameMotion = std::tuple<Vector3d, Vector3d, Vector3d, Vector3d, Vector3d>;
using ForceInputs = std::tuple<double, Vector3d, Vector3d, Vector3d, Vector3d>;
using CoriolisInputs = std::tuple<Vector3d, double, double>;
using FallInputs = std::tuple<double, double, double, double>;
using PendulumInputs = std::tuple<double, double>;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double earth_rate = 7.292115e-5;  // rad/s, against the stars
constexpr double sidereal_day = 86164.0905;
constexpr double solar_day = 86400;

// The vectors of the lecture's running example.
const Vector3d example_a(0.1, 0.2, 0.3);
const Vector3d example_v(0.4, -0.3, 0.6);
const Vector3d example_r(1, 2, -1);
const Vector3d example_omega(0.3, -0.2, 0.5);
const Vector3d example_alpha(0.05, 0.1, -0.04);

Vector3d cross(const Vector3d& a, const Vector3d& b) { return a.cross(b); }

Matrix3d matrix_of(const Vector3d& w) { return Matrix3d{{0, -w[2], w[1]}, {w[2], 0, -w[0]}, {-w[1], w[0], 0}}; }

/// A latitude of either hemisphere, away from the equator, from 45° and from the poles.
double generic_latitude(Random& random) {
  const double latitude = random.whole(0, 1) == 0 ? random.uniform(0.2, 0.6) : random.uniform(0.95, 1.35);
  return random.sign() * latitude;
}

/// Sum of the four terms of the acceleration with coefficients of one's own.
Vector3d weighted(const FrameMotion& motion, double acceleration, double coriolis, double euler, double centripetal) {
  const auto& [a, v, r, omega, alpha] = motion;
  return acceleration * a + coriolis * cross(omega, v) + euler * cross(alpha, r) +
         centripetal * cross(omega, cross(omega, r));
}

void describe_inertial_acceleration(Lecture& lecture) {
  auto& exercise = lecture.exercise("inertial_acceleration", &inertial_acceleration);
  exercise.argument("a_body", units::metre_per_second_squared).argument("v_body", units::metre_per_second);
  exercise.argument("r", units::metre)
      .argument("omega", units::radian_per_second)
      .argument("alpha", units::radian_per_second_squared);
  exercise.result("a_inertial", units::metre_per_second_squared);

  const Vector3d zero = Vector3d::Zero();
  exercise.worked("the vectors of the lecture", example_a, example_v, example_r, example_omega, example_alpha);
  exercise.special("at rest in a steadily turning frame", zero, zero, example_r, example_omega, zero);
  exercise.special("the frame does not turn", example_a, example_v, example_r, zero, zero);
  exercise.special("the frame begins to turn", example_a, example_v, example_r, zero, example_alpha);
  exercise.special("on the axis", example_a, example_v, Vector3d(2 * example_omega), example_omega, zero);
  exercise.special("at rest in the inertial frame", Vector3d(0, -4, 0), Vector3d(2, 0, 0), Vector3d(0, 1, 0.5),
                   Vector3d(0, 0, 2), zero);
  exercise.random("a random motion", 10, [](Random& random) {
    return FrameMotion{random.vector(2.0), random.vector(2.0), random.vector(2.0), random.vector(2.0),
                       random.vector(2.0)};
  });
  exercise.scale(
      [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega, const Vector3d& alpha) {
        return a.norm() + 2 * omega.norm() * v.norm() + alpha.norm() * r.norm() + omega.squaredNorm() * r.norm();
      });

  const char* const anchor = "rotating_frames_acceleration";
  const auto with = [](double acceleration, double coriolis, double euler, double centripetal) {
    return [=](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
               const Vector3d& alpha) -> Vector3d {
      return weighted({a, v, r, omega, alpha}, acceleration, coriolis, euler, centripetal);
    };
  };
  exercise.misconception(
      "coriolis_without_two",
      "The Coriolis term lacks its factor 2: ω × v arises twice, from the turning of v and from the change of ω × r.",
      anchor, with(1, 1, 1, 1));
  exercise.misconception("no_euler_term", "The Euler term α × r is missing; it is there whenever ω itself changes.",
                         anchor, with(1, 2, 0, 1));
  exercise.misconception(
      "no_centripetal_term",
      "The term ω × (ω × r) is missing or zero; read without these brackets, as (ω × ω) × r, it vanishes.",
      "rotating_frames_brackets", with(1, 2, 1, 0));
  exercise.misconception("centripetal_sign",
                         "ω × (ω × r) has the wrong sign: in the inertial acceleration it is added, and it points "
                         "towards the axis by itself.",
                         "rotating_frames_brackets", with(1, 2, 1, -1));
  exercise.misconception("coriolis_sign",
                         "The Coriolis term has the wrong sign: in the inertial acceleration it is +2 ω × v.", anchor,
                         with(1, -2, 1, 1));
  exercise.misconception("euler_sign", "The Euler term has the wrong sign: in the inertial acceleration it is +α × r.",
                         anchor, with(1, 2, -1, 1));
  exercise.misconception("fictitious_signs",
                         "The three extra terms are subtracted; that is how they enter as fictitious forces, but "
                         "a_inertial is their sum with a_body.",
                         "rotating_frames_forces", with(1, -2, -1, -1));
  exercise.misconception(
      "no_coriolis_term",
      "The Coriolis term 2 ω × v is missing; it is there whenever the point moves in the turning frame.", anchor,
      with(1, 0, 1, 1));
  exercise.misconception("a_body_lost", "The acceleration in the turning frame, a_body, does not enter.", anchor,
                         with(0, 2, 1, 1));
  exercise.misconception("a_body_only", "You return a_body; three terms of the turning frame are to be added.", anchor,
                         with(1, 0, 0, 0));
  exercise.misconception("transported_once",
                         "You return a_body + ω × v_body: the transport theorem has been applied to v_body, which is "
                         "not yet the inertial velocity.",
                         anchor, with(1, 1, 0, 0));
  exercise.misconception("inertial_velocity",
                         "ω × (ω × r) enters three times; the Coriolis term takes v_body, and v_body + ω × r in its "
                         "place brings in two too many.",
                         anchor, with(1, 2, 1, 3));
  exercise.misconception("omega_squared_r",
                         "You take −ω² r for ω × (ω × r); they agree only for r perpendicular to ω, because the "
                         "distance counts from the axis.",
                         "rotating_frames_brackets",
                         [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
                            const Vector3d& alpha) -> Vector3d {
                           return a + 2 * cross(omega, v) + cross(alpha, r) - omega.squaredNorm() * r;
                         });
  exercise.misconception("euler_with_velocity", "You cross α with the velocity; the Euler term is α × r.", anchor,
                         [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
                            const Vector3d& alpha) -> Vector3d {
                           return a + 2 * cross(omega, v) + cross(alpha, v) + cross(omega, cross(omega, r));
                         });

  exercise.term("a_body", 1, with(1, 0, 0, 0));
  exercise.term("ω × v", 2, with(0, 1, 0, 0));
  exercise.term("α × r", 1, with(0, 0, 1, 0));
  exercise.term("ω × (ω × r)", 1, with(0, 0, 0, 1));

  exercise.route("the transport theorem twice",
                 [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
                    const Vector3d& alpha) -> Vector3d {
                   const Vector3d velocity = v + cross(omega, r);
                   const Vector3d rate_of_velocity_in_body = a + cross(alpha, r) + cross(omega, v);
                   return rate_of_velocity_in_body + cross(omega, velocity);
                 });
  exercise.route("matrices",
                 [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
                    const Vector3d& alpha) -> Vector3d {
                   // d²A/dt² of the attitude at the instant when A = 1 is [α] + [ω]².
                   return (matrix_of(alpha) + matrix_of(omega) * matrix_of(omega)) * r + 2 * matrix_of(omega) * v + a;
                 });
  exercise.route("ω (ω·r) − ω² r",
                 [](const Vector3d& a, const Vector3d& v, const Vector3d& r, const Vector3d& omega,
                    const Vector3d& alpha) -> Vector3d {
                   return a - 2 * cross(v, omega) - cross(r, alpha) + omega * omega.dot(r) - r * omega.dot(omega);
                 });

  exercise.sweep(
      {"The lecture's motion in a frame that turns faster and faster about its axis", "|ω| (rad/s)",
       "inertial acceleration (m/s²)"},
      {0, 2},
      [](double rate) {
        return FrameMotion{example_a, example_v, example_r, rate * example_omega.normalized(), example_alpha};
      },
      {{"x", 0, 0}, {"y", 1, 0}, {"z", 2, 0}});
}

void describe_fictitious_force(Lecture& lecture) {
  auto& exercise = lecture.exercise("fictitious_force", &fictitious_force);
  exercise.argument("m", units::kilogram).argument("r", units::metre).argument("v_body", units::metre_per_second);
  exercise.argument("omega", units::radian_per_second).argument("alpha", units::radian_per_second_squared);
  exercise.result("F", units::newton);

  const Vector3d zero = Vector3d::Zero();
  exercise.worked("2 kg with the motion of the lecture", 2.0, example_r, example_v, example_omega, example_alpha);
  exercise.special("at rest in a steadily turning frame", 2.0, example_r, zero, example_omega, zero);
  exercise.special("the frame does not turn", 2.0, example_r, example_v, zero, zero);
  exercise.special("the frame begins to turn", 2.0, example_r, example_v, zero, example_alpha);
  exercise.special("on the axis, at rest", 2.0, Vector3d(2 * example_omega), zero, example_omega, zero);
  exercise.random("a random motion", 10, [](Random& random) {
    return ForceInputs{random.uniform(1.5, 4), random.vector(2.0), random.vector(2.0), random.vector(2.0),
                       random.vector(2.0)};
  });
  exercise.scale([](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) {
    const double size = m * (2 * omega.norm() * v.norm() + alpha.norm() * r.norm() + omega.squaredNorm() * r.norm());
    return size > 0 ? size : 1.0;  // without rotation there is no force: any scale tells zero from something
  });

  const char* const anchor = "rotating_frames_forces";
  const auto with = [](double coriolis, double euler, double centripetal) {
    return
        [=](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
          return m * weighted({Vector3d::Zero(), v, r, omega, alpha}, 0, coriolis, euler, centripetal);
        };
  };
  exercise.misconception(
      "overall_sign",
      "Your force has the wrong sign: brought to the other side of Newton's law, all three terms carry a minus.",
      anchor, with(2, 1, 1));
  exercise.misconception("coriolis_without_two", "The Coriolis force lacks its factor 2: it is −2 m ω × v.", anchor,
                         with(-1, -1, -1));
  exercise.misconception(
      "centrifugal_inward",
      "Your centrifugal force points towards the axis; it is −m ω × (ω × r), which points away from it.", anchor,
      with(-2, -1, 1));
  exercise.misconception("coriolis_sign", "The Coriolis force has the wrong sign: it is −2 m ω × v, or 2 m v × ω.",
                         anchor, with(2, -1, -1));
  exercise.misconception("euler_sign", "The Euler force has the wrong sign: it is −m α × r.", anchor, with(-2, 1, -1));
  exercise.misconception("no_euler_force",
                         "The Euler force −m α × r is missing; it is there whenever ω itself changes.", anchor,
                         with(-2, 0, -1));
  exercise.misconception(
      "no_coriolis_force",
      "The Coriolis force −2 m ω × v is missing; it is there whenever the point moves in the turning frame.", anchor,
      with(0, -1, -1));
  exercise.misconception(
      "no_centrifugal_force",
      "The centrifugal force is missing or zero; read without its brackets, as (ω × ω) × r, it vanishes.",
      "rotating_frames_brackets", with(-2, -1, 0));
  exercise.misconception("inertial_velocity",
                         "The centrifugal force enters three times; the Coriolis force takes v_body, and the inertial "
                         "velocity v_body + ω × r in its place brings in two too many.",
                         anchor, with(-2, -1, -3));
  exercise.misconception(
      "velocity_from_inertial",
      "Your centrifugal force points towards the axis; it is −m ω × (ω × r), which points away from it.", anchor,
      [](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
        return -m * weighted({Vector3d::Zero(), v - cross(omega, r), r, omega, alpha}, 0, 2, 1, 1);
      });
  exercise.misconception(
      "omega_squared_r",
      "Your centrifugal force is m ω² r, away from the origin; it must point away from the axis, m ω² times the "
      "distance from it.",
      "rotating_frames_brackets",
      [](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
        return m * (omega.squaredNorm() * r - 2 * cross(omega, v) - cross(alpha, r));
      });
  exercise.misconception("mass_lost", "The mass does not enter: this is the acceleration, not the force.", anchor,
                         [](double, const Vector3d& r, const Vector3d& v, const Vector3d& omega,
                            const Vector3d& alpha) -> Vector3d { return fictitious_force(1, r, v, omega, alpha); });

  exercise.term("m ω × v", -2, with(1, 0, 0));
  exercise.term("m α × r", -1, with(0, 1, 0));
  exercise.term("m ω × (ω × r)", -1, with(0, 0, 1));

  exercise.route(
      "force by force",
      [](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
        return 2 * m * cross(v, omega) + m * cross(r, alpha) + m * cross(cross(omega, r), omega);
      });
  exercise.route(
      "centrifugal force from the axis",
      [](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
        const double rate = omega.norm();
        const Vector3d axis = rate > 0 ? Vector3d(omega / rate) : Vector3d::UnitZ();
        const Vector3d from_axis = r - axis * axis.dot(r);
        return m * (rate * rate * from_axis - 2 * rate * cross(axis, v) - cross(alpha, r));
      });
  exercise.route(
      "matrices",
      [](double m, const Vector3d& r, const Vector3d& v, const Vector3d& omega, const Vector3d& alpha) -> Vector3d {
        const Matrix3d W = matrix_of(omega);
        return m * (W.transpose() * (2 * v + W * r) + matrix_of(alpha).transpose() * r);
      });

  exercise.sweep({"A mass of 2 kg moves out along (1, 2, −1) from the axis, with the velocity, ω and α of the lecture",
                  "distance from the origin (m)", "fictitious force (N)"},
                 {0, 5},
                 [](double distance) {
                   return ForceInputs{2.0, distance * example_r.normalized(), example_v, example_omega, example_alpha};
                 },
                 {{"x", 0, 0}, {"y", 1, 0}, {"z", 2, 0}});
}

/// −2 Ω × v for a rotation vector east, north, up.
Vector3d coriolis(const Vector3d& v, double east, double north, double up) {
  return -2 * cross(Vector3d(east, north, up), v);
}

void describe_coriolis_acceleration(Lecture& lecture) {
  auto& exercise = lecture.exercise("coriolis_acceleration", &coriolis_acceleration);
  exercise.argument("v_enu", units::metre_per_second)
      .argument("latitude", units::radian)
      .argument("earth_rate", units::radian_per_second);
  exercise.result("a_enu", units::metre_per_second_squared);

  exercise.worked("a flight over 40° north", Vector3d(30, -20, 10), 40 * degree, earth_rate);
  exercise.special("at the north pole", Vector3d(30, -20, 10), pi / 2, earth_rate);
  exercise.special("at the south pole", Vector3d(30, -20, 10), -pi / 2, earth_rate);
  exercise.special("on the equator", Vector3d(30, -20, 10), 0.0, earth_rate);
  exercise.special("at 45°, where sine and cosine are equal", Vector3d(30, -20, 10), pi / 4, earth_rate);
  exercise.special("along the Earth's axis", Vector3d(0, 30 * std::cos(0.7), 30 * std::sin(0.7)), 0.7, earth_rate);
  exercise.special("at rest", Vector3d::Zero(), 0.7, earth_rate);
  exercise.random("a random velocity on a planet", 10, [](Random& random) {
    const double latitude = generic_latitude(random);
    const Vector3d velocity = random.vector(100);
    return CoriolisInputs{velocity, latitude, random.uniform(3e-5, 2e-4)};
  });
  exercise.scale([](const Vector3d& v, double, double rate) { return 2 * rate * std::max(v.norm(), 1.0); });

  const char* const anchor = "rotating_frames_earth";
  exercise.misconception(
      "sign", "The sign is wrong: the Coriolis acceleration is −2 Ω × v, to the right of the velocity in the north.",
      anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
        return -coriolis_acceleration(v, latitude, rate);
      });
  exercise.misconception("no_two", "The factor 2 is missing: −2 Ω × v.", anchor,
                         [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return 0.5 * coriolis_acceleration(v, latitude, rate);
                         });
  exercise.misconception("sine_and_cosine_exchanged",
                         "Sine and cosine of the latitude are exchanged: at the pole, λ = 90°, the axis points up, so "
                         "sin λ belongs to up.",
                         anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return coriolis(v, 0, rate * std::sin(latitude), rate * std::cos(latitude));
                         });
  exercise.misconception("vertical_rotation_only",
                         "Only the vertical part Ω sin λ of the rotation enters; its northward part Ω cos λ matters "
                         "for velocities east and up.",
                         anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return coriolis(v, 0, 0, rate * std::sin(latitude));
                         });
  exercise.misconception(
      "horizontal_rotation_only",
      "Only the northward part Ω cos λ of the rotation enters; its vertical part Ω sin λ is missing.", anchor,
      [](const Vector3d& v, double latitude, double rate) -> Vector3d {
        return coriolis(v, 0, rate * std::cos(latitude), 0);
      });
  exercise.misconception("axis_always_up", "You take the Earth's axis for vertical; that is so only at the north pole.",
                         anchor,
                         [](const Vector3d& v, double, double rate) -> Vector3d { return coriolis(v, 0, 0, rate); });
  exercise.misconception("axis_to_the_east",
                         "You let the Earth's axis lean to the east; it lies in the plane of north and up.", anchor,
                         [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return coriolis(v, rate * std::cos(latitude), 0, rate * std::sin(latitude));
                         });
  exercise.misconception(
      "axis_to_the_south",
      "You let the Earth's axis lean to the south; seen from either hemisphere its horizontal part points north.",
      anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
        return coriolis(v, 0, -rate * std::cos(latitude), rate * std::sin(latitude));
      });
  exercise.misconception("southern_sign",
                         "The vertical part of the rotation has the wrong sign: it is +Ω sin λ along up, where λ is "
                         "positive in the north and negative in the south.",
                         anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return coriolis(v, 0, rate * std::cos(latitude), -rate * std::sin(latitude));
                         });
  exercise.misconception("always_northern",
                         "Your answer is the same at −λ as at λ; the vertical part of the rotation, Ω sin λ, changes "
                         "its sign at the equator.",
                         anchor, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
                           return coriolis_acceleration(v, std::abs(latitude), rate);
                         });
  exercise.misconception(
      "horizontal_result_only",
      "The vertical component is missing: motion to the east makes a body lighter by 2 Ω cos λ v_east.", anchor,
      [](const Vector3d& v, double latitude, double rate) -> Vector3d {
        return coriolis_acceleration(v, latitude, rate).cwiseProduct(Vector3d(1, 1, 0));
      });
  exercise.misconception("earth_rate_fixed",
                         "Your answer does not follow the argument earth_rate; it is right only for our Earth.", anchor,
                         [](const Vector3d& v, double latitude, double) -> Vector3d {
                           return coriolis_acceleration(v, latitude, earth_rate);
                         });
  exercise.angles_read_as_degrees(anchor);

  exercise.term("Ω sin λ ẑ × v", -2, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
    return rate * std::sin(latitude) * cross(Vector3d::UnitZ(), v);
  });
  exercise.term("Ω cos λ ŷ × v", -2, [](const Vector3d& v, double latitude, double rate) -> Vector3d {
    return rate * std::cos(latitude) * cross(Vector3d::UnitY(), v);
  });
  exercise.perpendicular_to(0, "The Coriolis acceleration is perpendicular to the velocity: it does no work.", anchor);

  exercise.route("component by component", [](const Vector3d& v, double latitude, double rate) -> Vector3d {
    const double f = 2 * rate * std::sin(latitude);
    const double e = 2 * rate * std::cos(latitude);
    return {f * v[1] - e * v[2], -f * v[0], e * v[0]};
  });
  exercise.route("on axes along the Earth's axis", [](const Vector3d& v, double latitude, double rate) -> Vector3d {
    // Tilt the local axes about east until "up" is the Earth's axis, take the simple product there, tilt back.
    const Matrix3d tilt = Eigen::AngleAxisd(pi / 2 - latitude, Vector3d::UnitX()).toRotationMatrix();
    const Vector3d u = tilt * v;
    return tilt.transpose() * Vector3d(2 * rate * u.y(), -2 * rate * u.x(), 0);
  });
  exercise.route("with the cross matrix", [](const Vector3d& v, double latitude, double rate) -> Vector3d {
    return 2 * matrix_of(rate * Vector3d(0, std::cos(latitude), std::sin(latitude))).transpose() * v;
  });

  exercise.sweep({"A velocity of (30, −20, 10) m/s east, north, up, from pole to pole", "latitude (rad)",
                  "Coriolis acceleration (m/s²)"},
                 {-pi / 2, pi / 2},
                 [](double latitude) {
                   return CoriolisInputs{Vector3d(30, -20, 10), latitude, earth_rate};
                 },
                 {{"east", 0, 0}, {"north", 1, 0}, {"up", 2, 0}});
}

void describe_eastward_deflection(Lecture& lecture) {
  auto& exercise = lecture.exercise("eastward_deflection", &eastward_deflection);
  exercise.argument("height", units::metre)
      .argument("latitude", units::radian)
      .argument("g", units::metre_per_second_squared);
  exercise.argument("earth_rate", units::radian_per_second).result("deflection", units::metre);

  exercise.worked("a tower of 110 m at 40° north", 110.0, 40 * degree, 9.81, earth_rate);
  exercise.special("the same tower at 45°, where sine and cosine are equal", 110.0, pi / 4, 9.81, earth_rate);
  exercise.special("on the equator", 110.0, 0.0, 9.81, earth_rate);
  exercise.special("at the pole", 110.0, pi / 2, 9.81, earth_rate);
  exercise.special("no height at all", 0.0, 40 * degree, 9.81, earth_rate);
  exercise.worked("the same tower at 40° south", 110.0, -40 * degree, 9.81, earth_rate);
  exercise.random("a random fall on a planet", 10, [](Random& random) {
    const double height = random.uniform(20, 300);
    const double latitude = generic_latitude(random);
    const double g = random.uniform(2, 15);
    return FallInputs{height, latitude, g, random.uniform(3e-5, 2e-4)};
  });
  exercise.scale([](double height, double, double g, double rate) {
    return height > 0 ? rate * std::sqrt(height * height * height / g) : 1.0;
  });

  const char* const anchor = "rotating_frames_fall";
  const auto times = [](double factor) {
    return [factor](double height, double latitude, double g, double rate) {
      return factor * eastward_deflection(height, latitude, g, rate);
    };
  };
  exercise.misconception(
      "sine",
      "The latitude enters with its sine; the part of the rotation across the fall is Ω cos λ, largest on the equator.",
      anchor, [](double height, double latitude, double g, double rate) {
        return eastward_deflection(height, pi / 2 - latitude, g, rate);
      });
  exercise.misconception("no_two",
                         "Your deflection is half of what it should be; that is what comes out when the Coriolis "
                         "acceleration lacks its factor 2.",
                         anchor, times(0.5));
  exercise.misconception("excess_speed_kept",
                         "Your deflection is 3/2 of what it should be: neither is the excess speed Ωh of the top kept "
                         "(d = Ωht), nor may a mean speed stand for the growing v = gt.",
                         "rotating_frames_inertial_view", times(1.5));
  exercise.misconception("west", "Your deflection is to the west: −2 Ω × v of a falling body points east.", anchor,
                         times(-1));
  exercise.misconception("constant_acceleration",
                         "Your deflection is three times too large; that is what comes out when the final speed g t is "
                         "used all the way instead of integrating.",
                         anchor, times(3));
  exercise.misconception("integrated_once_short",
                         "Your deflection is six times too large: the Coriolis acceleration 2 Ω g t cos λ integrated "
                         "twice has t³/6, not t³.",
                         anchor, times(6));
  exercise.misconception(
      "no_latitude", "The latitude does not enter; away from the equator the deflection shrinks with cos λ.", anchor,
      [](double height, double, double g, double rate) { return eastward_deflection(height, 0, g, rate); });
  exercise.misconception("fall_time", "The time of the fall is wrong: h = ½ g t² gives t = √(2h/g).", anchor,
                         times(1 / std::sqrt(8.0)));
  exercise.misconception(
      "thrown_up",
      "This is four times as far and to the west: the deflection of a ball thrown up to the height and falling back.",
      anchor, times(-4));
  exercise.misconception("g_fixed", "Your answer does not follow the argument g.", anchor,
                         [](double height, double latitude, double, double rate) {
                           return eastward_deflection(height, latitude, 9.81, rate);
                         });
  exercise.misconception("earth_rate_fixed",
                         "Your answer does not follow the argument earth_rate; it is right only for our Earth.", anchor,
                         [](double height, double latitude, double g, double) {
                           return eastward_deflection(height, latitude, g, earth_rate);
                         });
  exercise.angles_read_as_degrees(anchor);

  exercise.term("Ω g t³ cos λ", 1. / 3, times(3));

  exercise.route("one formula", [](double height, double latitude, double g, double rate) {
    return rate * std::cos(latitude) / 3 * std::sqrt(8 * height * height * height / g);
  });
  exercise.route("integrated twice by quadrature", [](double height, double latitude, double g, double rate) {
    // x(t) = ∫ (t − s) a(s) ds, a cubic polynomial in all: seven Gauss points are exact.
    const double t = std::sqrt(2 * height / g);
    if (t == 0) return 0.0;
    return boost::math::quadrature::gauss<double, 7>::integrate(
        [&](double s) {
          return (t - s) * coriolis_acceleration({0, 0, -g * s}, latitude, rate).x();
        },
        0.0, t);
  });
  exercise.route("steps of Runge and Kutta", [](double height, double latitude, double g, double rate) {
    const double step = std::sqrt(2 * height / g) / 100;
    const double jerk = 2 * rate * g * std::cos(latitude);  // the acceleration to the east is jerk · t
    double x = 0, v = 0;
    for (int k = 0; k < 100; ++k) {
      const double t = k * step;
      // Of fourth order, hence exact for this cubic.
      x += step * (v + step * jerk * (3 * t + step) / 6);
      v += step * jerk * (t + step / 2);
    }
    return x;
  });
  exercise.route("seen from outside", [](double height, double latitude, double g, double rate) {
    // The top is ahead by Ωht cos λ, and the plumb line, turning with the Earth, pulls the body back by
    // ⅙ g Ω t³ cos λ.
    const double t = std::sqrt(2 * height / g);
    return rate * std::cos(latitude) * (height * t - g * t * t * t / 6);
  });

  exercise.sweep({"A fall of 110 m, from pole to pole", "latitude (rad)", "deflection to the east (m)"},
                 {-pi / 2, pi / 2},
                 [](double latitude) {
                   return FallInputs{110, latitude, 9.81, earth_rate};
                 },
                 {{"east", 0, 0}});
}

void describe_foucault_period(Lecture& lecture) {
  auto& exercise = lecture.exercise("foucault_period", &foucault_period);
  exercise.argument("latitude", units::radian).argument("sidereal_day", units::second).result("period", units::second);

  exercise.worked("Paris", 48.8462 * degree, sidereal_day);
  exercise.special("at the pole", pi / 2, sidereal_day);
  exercise.special("30°, where a turn takes two days", pi / 6, sidereal_day);
  exercise.special("45°, where sine and cosine are equal", pi / 4, sidereal_day);
  exercise.special("half a degree from the equator", 0.5 * degree, sidereal_day);
  exercise.random("a random place on a planet", 10, [](Random& random) {
    const double latitude = std::abs(generic_latitude(random));
    return PendulumInputs{latitude, random.uniform(3e4, 2e5)};
  });

  const char* const anchor = "rotating_frames_foucault";
  exercise.misconception(
      "cosine",
      "The latitude enters with its cosine; the vertical part of the rotation is Ω sin λ, largest at the pole.", anchor,
      [](double latitude, double day) { return day / std::cos(latitude); });
  exercise.misconception(
      "solar_day",
      "You use the solar day of 86400 s; the pendulum follows the stars, and its day is the argument sidereal_day.",
      anchor, [](double latitude, double day) { return foucault_period(latitude, day * solar_day / sidereal_day); });
  exercise.misconception(
      "solar_day_fixed",
      "You use the solar day of 86400 s; the pendulum follows the stars, and its day is the argument sidereal_day.",
      anchor, [](double latitude, double) { return foucault_period(latitude, solar_day); });
  exercise.misconception("earth_fixed",
                         "Your answer does not follow the argument sidereal_day; it is right only for our Earth.",
                         anchor, [](double latitude, double) { return foucault_period(latitude, sidereal_day); });
  exercise.misconception("times_sine",
                         "You multiply by sin λ; the plane turns more slowly away from the pole, so the time is longer "
                         "than a day: divide.",
                         anchor, [](double latitude, double day) { return day * std::sin(latitude); });
  exercise.misconception("tangent",
                         "The latitude enters with its tangent; the vertical part of the rotation is Ω sin λ.", anchor,
                         [](double latitude, double day) { return day / std::tan(latitude); });
  exercise.misconception("no_latitude", "You return the sidereal day itself; a turn takes so long only at the pole.",
                         anchor, [](double, double day) { return day; });
  exercise.misconception("half_a_turn",
                         "Your time is half of what it should be: after it the plane stands where it began, but a full "
                         "turn by 360° is asked for.",
                         anchor, [](double latitude, double day) { return foucault_period(latitude, day) / 2; });
  exercise.misconception("two_pi", "A factor 2π is lost: this is the time of a turn by one radian.", anchor,
                         [](double latitude, double day) { return foucault_period(latitude, day) / (2 * pi); });
  exercise.misconception("hours", "Your answer is in hours; seconds are asked for.", anchor,
                         [](double latitude, double day) { return foucault_period(latitude, day) / 3600; });
  exercise.angles_read_as_degrees(anchor);

  exercise.term("T / sin λ", 1, [](double latitude, double day) { return day / std::sin(latitude); });
  exercise.property(PropertyKind::nonnegative, "A time is not negative.", anchor);

  exercise.route("from the angular velocity", [](double latitude, double day) {
    const double rate = 2 * pi / day;
    return 2 * pi / (rate * std::sin(latitude));
  });
  exercise.route("from the colatitude", [](double latitude, double day) { return day / std::cos(pi / 2 - latitude); });
  exercise.route("from the angle that parallel transport leaves", [](double latitude, double day) {
    // Carried once round the circle of latitude, a direction kept parallel comes back turned by 2π less the solid
    // angle of the cap.
    const double solid_angle = 2 * pi * (1 - std::sin(latitude));
    return day * 2 * pi / (2 * pi - solid_angle);
  });
  exercise.route("with the tangent", [](double latitude, double day) {
    const double t = std::tan(latitude);
    return day * std::sqrt(1 + 1 / (t * t));
  });

  exercise.sweep({"The turn of a Foucault pendulum, from 10° to the pole", "latitude (rad)", "time of a full turn (s)"},
                 {10 * degree, pi / 2},
                 [](double latitude) {
                   return PendulumInputs{latitude, sidereal_day};
                 },
                 {{"period", 0, 0}});
}

}  // namespace

void workbook::judging::describe(Lecture& lecture) {
  describe_inertial_acceleration(lecture);
  describe_fictitious_force(lecture);
  describe_coriolis_acceleration(lecture);
  describe_eastward_deflection(lecture);
  describe_foucault_period(lecture);
}
