#include "solutions/03_inertia_tensor/shared.hpp"

void judge_cuboid_about_corner(Lecture& lecture) {
  auto& e = lecture.exercise(
      &cuboid_about_corner,
      {{"M", positive(kg)}, {"a", not_negative(metre)}, {"b", not_negative(metre)}, {"c", not_negative(metre)}},
      {"I", kg_m2});
  e.worked("6 kg, edges 1 m, 2 m, 3 m", 6, 1, 2, 3);
  e.special("the cube of the slides", 1, 1, 1, 1);
  e.special("a thin rod along x", 2, 3, 0, 0);
  e.random("a random cuboid", 8, any::uniform(1.5, 5), any::uniform(0.5, 1), any::uniform(1.2, 1.8),
           any::uniform(2, 3));
  e.sweep({"A cuboid of 1 kg with edges a, 2 m, 3 m grows along x", "edge a (m)", "entry of I (kg m²)"},
          {"I_xx", {"I_yy", 1, 1}, {"I_xy", 0, 1}}, {0, 4}, [](auto a) { return tuple(1, a, 2, 3); });

  e.term("M (b² + c²), M (a² + c²), M (a² + b²) on the diagonal", 1. / 3,
         [](auto M, auto a, auto b, auto c) { return of_cuboid(M, Vector3d(a, b, c), 1, 0); });
  e.term("M ab, M ac, M bc off the diagonal", -1. / 4,
         [](auto M, auto a, auto b, auto c) { return of_cuboid(M, Vector3d(a, b, c), 0, 1); });
  const char* const products = "inertia_tensor_products";
  e.wrong_terms({"The products of inertia have the wrong sign: I_xy = −¼ M ab, with a minus.", products},
                "products_positive", {1. / 3, 1. / 4});
  e.wrong_terms("Your diagonal has 1/12, which belongs to the centre of the cuboid; about a corner it is 1/3.",
                "diagonal_about_center", {1. / 12, -1. / 4});
  e.wrong_terms("This is the tensor about the centre; asked for is the corner.", "about_center", {1. / 12, 0});
  e.wrong("From the centre to the corner each moment grows by M d² here, and no product changes; it is M (d² 1 − d d).",
          "isotropic_shift", [](auto M, auto a, auto b, auto c) -> Matrix3d {
            const Vector3d edges(a, b, c);
            return of_cuboid(M, edges, 1. / 12, 0) + M * edges.squaredNorm() / 4 * Matrix3d::Identity();
          });
  e.wrong_terms("Your products have −1/3; the mean of xy is ½a·½b, giving −1/4.", "products_third", {1. / 3, -1. / 3});
  e.wrong_terms("Your products have −1/2; the mean of xy is ½a·½b, giving −1/4.", "products_half", {1. / 3, -1. / 2});
  e.wrong_terms({"The products of inertia are missing; the edges through the corner are not principal axes.", products},
                "no_products", {1. / 3, 0});
  e.wrong_output("I_xx holds a² + b²; about the x axis the other two edges count, b² + c² (and so on, in turn).",
                 "diagonal_in_wrong_place", [](auto& I) { I.diagonal() = Vector3d(I(2, 2), I(0, 0), I(1, 1)); });
  e.wrong_output("I_xx holds a² + b² and I_zz holds b² + c²: the first and the last are exchanged.",
                 "diagonal_reversed", [](auto& I) { swap(I(0, 0), I(2, 2)); });
  e.wrong_input<0>("The mass does not enter.", "mass_dropped", fixed(1.0));
  e.wrong_inputs("M counts as a density here, multiplied by the volume; it is the whole mass.", "mass_as_density",
                 [](auto& M, auto a, auto b, auto c) { M *= a * b * c; });
  e.is_inertia_tensor("inertia_tensor_dyad", "inertia_tensor_energy");
  e.route("Gauss quadrature over the body", [](auto M, auto a, auto b, auto c) {
    const Vector3d edges(a, b, c);
    return inertia_of_points(VectorXd::Constant(8, M / 8), gauss_points_of_cuboid(edges).colwise() + edges / 2);
  });
  e.route("centre and parallel axes", [](auto M, auto a, auto b, auto c) {
    return of_cuboid(M, Vector3d(a, b, c), 1. / 12, 0) + M / 4 * of_unit_mass(Vector3d(a, b, c));
  });
  e.route("all nine entries", [](auto M, auto a, auto b, auto c) {
    return M * Matrix3d{{(b * b + c * c) / 3, -a * b / 4, -a * c / 4},
                        {-a * b / 4, (a * a + c * c) / 3, -b * c / 4},
                        {-a * c / 4, -b * c / 4, (a * a + b * b) / 3}};
  });
}
