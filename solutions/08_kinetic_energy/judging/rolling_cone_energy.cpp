#include "solutions/08_kinetic_energy/shared.hpp"

namespace {

/// A cone that rolls around its apex, and what wrong answers make of it.
struct RollingCone {
  double M, height, half_angle, rate;

  double radius() const { return height * tan(half_angle); }
  double along() const { return 0.3 * M * pow(radius(), 2); }
  double across_in_center() const { return 0.15 * M * (pow(radius(), 2) + height * height / 4); }
  double across_in_apex() const { return across_in_center() + M * pow(0.75 * height, 2); }
  double of_center() const { return 0.5 * M * pow(0.75 * height * cos(half_angle) * rate, 2); }
  /// About the line of contact, with a moment of one's own about an axis across the cone.
  double about_contact(double across) const {
    return 0.5 * pow(rate / tan(half_angle), 2) *
           (along() * pow(cos(half_angle), 2) + across * pow(sin(half_angle), 2));
  }
  /// The Euler angles of the cone while it rolls, at the time t.
  Vector3d angles(double t) const { return {rate * t, pi / 2 - half_angle, -rate * t / sin(half_angle)}; }
};

auto of_cone(double (*energy_of)(const RollingCone&)) {
  return [energy_of](double M, double height, double half_angle, double rate) {
    return energy_of({M, height, half_angle, rate});
  };
}

/// ½ Σ m v² over points with the mass and the second moments of the cone, velocities by differences of the places.
double energy_of_points(const RollingCone& cone) {
  const double h = 1e-3 * sin(cone.half_angle) / (cone.rate == 0 ? 1 : abs(cone.rate));
  const double x = sqrt(0.6);  // three Gauss points along the axis, two along the radius
  double energy = 0, volume = 0;
  for (const auto& [node, weight] : {std::pair{-x, 5.0}, {0.0, 8.0}, {x, 5.0}}) {
    for (const double radial : {0.5 - sqrt(1 / 12.0), 0.5 + sqrt(1 / 12.0)}) {
      for (const double around : {0.0, pi / 2, pi, 3 * pi / 2}) {
        const double u = (1 + node) / 2, mass = weight * u * u * radial;
        const Vector3d place(u * radial * cone.radius() * cos(around), u * radial * cone.radius() * sin(around),
                             u * cone.height);
        const auto at = [&](double steps) { return attitude(cone.angles(steps * h)) * place; };
        energy += 0.5 * mass * ((8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h)).squaredNorm();
        volume += mass;
      }
    }
  }
  return cone.M * energy / volume;
}

}  // namespace

void judge_rolling_cone_energy(Lecture& lecture) {
  auto& e = lecture.exercise(
      &rolling_cone_energy,
      {{"M", positive(kg)}, {"height", positive(metre)}, {"half_angle", positive(rad)}, {"rate", rad_per_s}},
      {"T", joule});
  e.domain([](auto, auto, auto half_angle, auto) { return half_angle < pi / 2; });
  e.worked("a cone of half angle 25°", 2, 0.3, 25 * degree, 4);
  e.special("half angle 45°", 2, 0.3, 45 * degree, 4);
  e.special("a needle: half angle 1°", 2, 0.3, 1 * degree, 4);
  e.special("nearly a disc: half angle 89°", 2, 0.3, 89 * degree, 4);
  e.special("the other way round", 2, 0.3, 25 * degree, -4);
  e.special("at rest", 2, 0.3, 25 * degree, 0);
  e.limit("a needle: half angle 1°", 0.75 * 0.6 * 2 * pow(0.3 * 4, 2),
          "A thin needle is a row of small discs that roll along, each with ¾ m v², and the mean of the square of the "
          "distance from the apex is ⅗ of the height squared.");
  e.limit("nearly a disc: half angle 89°", 0.075 * 2 * pow(0.3 * 4, 2),
          "A flat cone hardly turns about the line of contact, at rate · cot α, and about that line it has the moment "
          "3/20 M r² of a flat cone's diameter.");
  e.random("any cone", 8, [](Random& random) {
    const double half_angle = random.sign() > 0 ? random.uniform(0.2, 0.7) : random.uniform(0.87, 1.3);
    return tuple{random.uniform(0.5, 3), random.uniform(0.1, 0.5), half_angle, random.sign() * random.uniform(1, 6)};
  });
  e.scale([](auto M, auto height, auto, auto rate) { return or_one(0.1 * M * pow(height * rate, 2)); });
  e.sweep({"A cone of 2 kg and 0.3 m that goes round at 4 rad/s", "half angle (rad)", "T (J)"}, {"T"}, {0.02, 1.55},
          [](auto half_angle) { return tuple(2, 0.3, half_angle, 4); });

  e.wrong("Your ω is upright and as large as the rate; the cone also turns about its own axis.", "vertical_omega",
          of_cone([](auto& c) {
            const double s = sin(c.half_angle), cosine = cos(c.half_angle);
            return 0.5 * c.rate * c.rate * (c.along() * s * s + c.across_in_apex() * cosine * cosine);
          }));
  e.wrong("The energies of two rotations are added; their axes are not at right angles, and ω is to be added first.",
          "energies_added", of_cone([](auto& c) {
            const double s = sin(c.half_angle), cosine = cos(c.half_angle);
            return 0.5 * c.rate * c.rate * (c.along() * (s * s + 1 / (s * s)) + c.across_in_apex() * cosine * cosine);
          }));
  e.wrong("Your rotation is about the axis of the cone only; the cone also goes round the vertical.",
          "spin_about_axis_only",
          of_cone([](auto& c) { return c.of_center() + 0.5 * c.along() * pow(c.rate / sin(c.half_angle), 2); }));
  e.wrong("This is the energy of rotation about the centre of mass; the centre of mass moves as well.",
          "no_translation", of_cone([](auto& c) { return c.about_contact(c.across_in_center()); }));
  e.wrong("The motion of the centre of mass is counted twice; moments about the apex, which rests, include it.",
          "apex_and_translation", of_cone([](auto& c) { return c.of_center() + c.about_contact(c.across_in_apex()); }));
  e.wrong("The height is measured along the side of your cone; it is measured along its axis.", "height_as_slant",
          [](auto M, auto height, auto half_angle, auto rate) {
            return rolling_cone_energy(M, height * cos(half_angle), half_angle, rate);
          });
  e.wrong("This is the energy of the centre of mass alone; the cone also rotates about it.", "translation_only",
          of_cone([](auto& c) { return c.of_center(); }));
  e.wrong(
      "Your ω is as large as the spin about the axis; the rate round the vertical is still to be added, as a vector.",
      "omega_by_sine",
      of_cone([](auto& c) { return c.about_contact(c.across_in_apex()) / pow(cos(c.half_angle), 2); }));
  e.wrong(
      "Your ω grows with the angle of the cone; the blunter the cone, the slower it rotates about the line of contact.",
      "omega_by_tangent",
      of_cone([](auto& c) { return c.about_contact(c.across_in_apex()) * pow(tan(c.half_angle), 4); }));
  e.wrong("The moment about the axis is that of a cylinder; a cone has its mass nearer to its axis.", "cylinder",
          of_cone([](auto& c) {
            const double too_much = (0.5 - 0.3) * c.M * pow(c.radius() * cos(c.half_angle), 2);
            return c.about_contact(c.across_in_apex()) + 0.5 * too_much * pow(c.rate / tan(c.half_angle), 2);
          }));
  e.wrong(
      "Of ω along the axis of the cone the part of the rate round the vertical is missing; ω as a whole lies along "
      "the line of contact.",
      "spin_alone_along", of_cone([](auto& c) {
        const double along = c.rate / sin(c.half_angle), across = c.rate * cos(c.half_angle);
        return 0.5 * (c.along() * along * along + c.across_in_apex() * across * across);
      }));
  e.wrong(
      "These are the moments of a conical shell; a solid cone has its mass nearer to its axis.", "shell",
      of_cone([](auto& c) {
        const double R2 = c.radius() * c.radius(), w = c.rate / tan(c.half_angle);
        return 0.5 * c.M * w * w *
               (R2 / 2 * pow(cos(c.half_angle), 2) + (R2 / 4 + c.height * c.height / 2) * pow(sin(c.half_angle), 2));
      }));
  e.wrong_output("The factor one half is missing.", "no_half", times(2));
  e.wrong_input<2>("half_angle is halved once more; it lies between the axis and the side already.", "opening_angle",
                   times(0.5));
  e.wrong(
      "The centre of mass lies two thirds down the axis here, as in a triangle; in a solid cone it is three quarters.",
      "center_of_a_triangle",
      of_cone([](auto& c) { return c.of_center() * pow(8.0 / 9, 2) + c.about_contact(c.across_in_center()); }));
  e.angles_read_as_degrees("kinetic_energy_symmetric_top");
  e.property(Is::nonnegative, "A kinetic energy is never negative.");
  e.route("centre of mass and rotation about it",
          of_cone([](auto& c) { return c.of_center() + c.about_contact(c.across_in_center()); }));
  e.route("Euler angles of a symmetric body about the apex", of_cone([](auto& c) {
            return kinetic_energy_symmetric(c.across_in_apex(), c.along(), pi / 2 - c.half_angle,
                                            {c.rate, 0, -c.rate / sin(c.half_angle)});
          }));
  e.route("points of the cone, followed", of_cone(energy_of_points));
  e.survivor("radius = ", "It is squared.");
  e.survivor("omega = ", "It is squared.");
  e.survivor("omega_along = ", "Both components are squared.");
}
