#include "solutions/04_parallel_axis/shared.hpp"

#include <boost/math/quadrature/gauss.hpp>

/// The masses of the block and of the ball that is cut out of it.
static std::pair<double, double> block_and_ball(double density, const Vector3d& edges, double radius) {
  return {density * edges.prod(), density * 4 / 3 * pi * pow(radius, 3)};
}

static Matrix3d of_block(double density, const Vector3d& edges) {
  return of_cuboid(density * edges.prod(), edges, 1. / 12, 0);
}

/// About the centre of the block, with another factor of m r² for the ball.
static Matrix3d about_the_middle(double density, const Vector3d& edges, const Vector3d& center, double radius,
                                 double of_ball = 0.4) {
  const double ball = block_and_ball(density, edges, radius).second;
  return of_block(density, edges) - unit(of_ball * ball * radius * radius) - ball * of_unit_mass(center);
}

/// What the last step, from the centre of the block to the centre of mass, subtracts.
static Matrix3d last_step(double density, const Vector3d& edges, const Vector3d& center, double radius) {
  const auto [block, ball] = block_and_ball(density, edges, radius);
  return ball * ball / (block - ball) * of_unit_mass(center);
}

/// Points with the second moments of the block, and points of negative mass with those of the ball.
static Matrix3d by_points(double density, const Vector3d& edges, const Vector3d& center, double radius) {
  const auto [block, ball] = block_and_ball(density, edges, radius);
  VectorXd m(14);
  m << VectorXd::Constant(8, block / 8), VectorXd::Constant(6, -ball / 6);
  Matrix3Xd r(3, 14);
  r << gauss_points_of_cuboid(edges), unit(radius * sqrt(0.6)), unit(-radius * sqrt(0.6));
  r.rightCols<6>().colwise() += center;
  return as_points(m, r, center_of_mass(m, r));
}

/// The ball as thin discs at the points of a Gauss rule.
static Matrix3d by_discs(double density, const Vector3d& edges, const Vector3d& center, double radius) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  Matrix3d I = of_block(density, edges);
  double mass = density * edges.prod();
  Vector3d first_moment = Vector3d::Zero();
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    for (const double side : {1., -1.}) {
      const double z = side * radius * Gauss::abscissa()[k], square = radius * radius - z * z;
      const double disc = density * pi * square * radius * Gauss::weights()[k];
      const Vector3d place = center + z * z_axis;
      I -= disc * (square / 4 * Matrix3d(Vector3d(1, 1, 2).asDiagonal()) + of_unit_mass(place));
      mass -= disc;
      first_moment -= disc * place;
    }
  }
  return inertia_to_center_of_mass(I, mass, first_moment / mass);
}

void judge_block_with_hole(Lecture& lecture) {
  auto& e = lecture.exercise(&block_with_hole,
                             {{"density", positive(kg / metre / metre / metre)},
                              {"edges", positive(metre)},
                              {"center", metre},
                              {"radius", not_negative(metre)}},
                             {"I", kg_m2});
  e.domain([](auto, auto& edges, auto& center, auto radius) {
    return ((edges / 2 * (1 + 1e-12) - center.cwiseAbs()).array() >= radius).all();
  });
  const Vector3d edges(0.4, 0.3, 0.2), center(0.05, -0.04, 0.02);
  e.worked("a block of 19.2 kg", 800, edges, center, 0.07);
  e.special("a hole in the middle", 800, edges, zero, 0.07);
  e.special("no hole", 800, edges, center, 0);
  e.special("a cube, the hole touches three faces", 2700, {1, 1, 1}, {-0.2, 0.2, 0.2}, 0.3);
  e.limit("no hole", of_block(800, edges), "The block is whole.");
  e.limit("a hole in the middle", about_the_middle(800, edges, zero, 0.07),
          "The centre of mass stays, and the moments of a solid ball are missing.");
  e.random("a large hole", 10, [](Random& random) {
    const double radius = random.uniform(0.5, 0.8);
    const Vector3d place = random.vector(0.4);
    Vector3d box = 2 * (place.cwiseAbs() + Vector3d::Constant(radius));
    for (double& edge : box) edge += random.uniform(0.05, 0.5);
    return tuple(random.uniform(500, 3000), box, place, radius);
  });
  e.sweep(
      {"A hole of radius 0.07 m moves through the block along x", "center of the hole, x (m)", "entry of I (kg m²)"},
      {{"I_xy", 0, 1}, {"I_xz", 0, 2}}, {-0.13, 0.13},
      [=](auto x) { return tuple(800, edges, Vector3d(x, -0.04, 0.02), 0.07); });

  e.wrong("This is the tensor about the middle of the block; the centre of mass of what remains is elsewhere.",
          "about_the_middle", [](auto density, auto& box, auto& place, auto radius) {
            return about_the_middle(density, box, place, radius);
          });
  e.wrong("The hole counts as a positive mass here: this is a block with a ball added to it.", "hole_added",
          [](auto density, auto& box, auto& place, auto radius) {
            const auto [block, ball] = block_and_ball(density, box, radius);
            return of_block(density, box) + unit(0.4 * ball * radius * radius) +
                   block * ball / (block + ball) * of_unit_mass(place);
          });
  e.wrong({"The ball's tensor is subtracted as if the ball were in the middle of the block.", theorem_notes},
          "no_shift_of_hole", [](auto density, auto& box, auto& place, auto radius) {
            return about_the_middle(density, box, zero, radius) - last_step(density, box, place, radius);
          });
  e.wrong("The moment is that of a spherical shell; a ball is cut out here.", "shell",
          [](auto density, auto& box, auto& place, auto radius) {
            return about_the_middle(density, box, place, radius, 2. / 3) - last_step(density, box, place, radius);
          });
  e.wrong({"The last step, to the centre of mass, is added; there the moments are smallest.", "parallel_axis_back"},
          "step_back_added", [](auto density, auto& box, auto& place, auto radius) {
            return about_the_middle(density, box, place, radius) + last_step(density, box, place, radius);
          });
  e.wrong({"The last step, to the centre of mass, is taken with the mass of the whole block; what is left is lighter.",
           "parallel_axis_back"},
          "mass_of_the_block", [](auto density, auto& box, auto& place, auto radius) {
            const auto [block, ball] = block_and_ball(density, box, radius);
            return about_the_middle(density, box, place, radius) -
                   block / (block - ball) * last_step(density, box, place, radius);
          });
  e.is_inertia_tensor(theorem_notes, theorem_notes);
  e.route("points, some of negative mass", by_points);
  e.route("discs", by_discs);
  e.route("a body and a body of negative mass", [](auto density, auto& box, auto& place, auto radius) {
    const auto [block, ball] = block_and_ball(density, box, radius);
    return combined_inertia(VectorXd{{block, -ball}}, Matrix3Xd{{0, place[0]}, {0, place[1]}, {0, place[2]}},
                            {of_block(density, box), unit(-0.4 * ball * radius * radius)});
  });
  e.survivor("center_of_mass =  ball", "It enters twice.");
  e.survivor("of_unit_mass_at( -", "A position enters twice.");
}
