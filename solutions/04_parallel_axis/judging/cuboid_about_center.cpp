#include "solutions/04_parallel_axis/shared.hpp"

void judge_cuboid_about_center(Lecture& lecture) {
  auto& e = lecture.exercise(
      &cuboid_about_center,
      {{"M", positive(kg)}, {"a", not_negative(metre)}, {"b", not_negative(metre)}, {"c", not_negative(metre)}},
      {"I", kg_m2});
  e.worked("6 kg, edges 1 m, 2 m, 3 m", 6, 1, 2, 3);
  e.special("a cube", 1, 1, 1, 1);
  e.special("a thin rod along x", 2, 3, 0, 0);
  e.special("a thin plate across z", 2, 1, 3, 0);
  e.random("a random cuboid", 8, any::uniform(1.5, 5), any::uniform(0.5, 1), any::uniform(1.2, 1.8),
           any::uniform(2, 3));
  e.sweep({"A cuboid of 1 kg with edges a, 2 m, 3 m grows along x", "edge a (m)", "entry of I (kg m²)"},
          {"I_xx", {"I_yy", 1, 1}, {"I_zz", 2, 2}}, {0, 4}, [](auto a) { return tuple(1, a, 2, 3); });

  e.term("M (b² + c²), M (a² + c²), M (a² + b²) on the diagonal", 1. / 12,
         [](auto M, auto a, auto b, auto c) { return of_cuboid(M, Vector3d(a, b, c), 1, 0); });
  e.wrong_terms("Your moments have 1/3, as for half edges or about an edge; it is 1/12.", "third", {1. / 3});
  e.wrong_terms("Your moments have 1/6, as of a cube, where b² + c² is 2a²; it is 1/12.", "sixth", {1. / 6});
  e.wrong_terms("Your moments have 1/48: a, b, c are the whole edges, and it is 1/12.", "halved_edges", {1. / 48});
  e.wrong_terms("Your moments have 1/5, as of an ellipsoid with half axes a, b, c; it is 1/12.", "ellipsoid", {1. / 5});
  e.wrong_terms("Your moments have 1/4, what the shift takes off: 1/3 − 1/4 = 1/12.", "fourth_of_corner", {1. / 4});
  e.wrong("This is the tensor about a corner; asked for is the centre, where the products vanish.", "about_corner",
          [](auto M, auto a, auto b, auto c) { return of_cuboid(M, Vector3d(a, b, c), 1. / 3, -1. / 4); });
  e.wrong("Your diagonal is right, but about the centre the products of inertia vanish.", "products_of_corner",
          [](auto M, auto a, auto b, auto c) { return of_cuboid(M, Vector3d(a, b, c), 1. / 12, -1. / 4); });
  e.wrong("I_xx holds only a²; about the x axis the other two edges count, b² + c² (and so on, in turn).", "own_edge",
          [](auto M, auto a, auto b, auto c) { return M / 12 * diagonal_part(dyad(Vector3d(a, b, c))); });
  e.wrong("All three edges enter each of your moments; about the x axis only b and c count.", "all_edges",
          [](auto M, auto a, auto b, auto c) { return unit(M / 12 * (a * a + b * b + c * c)); });
  e.wrong_output("I_xx holds a² + b²; about the x axis the other two edges count, b² + c² (and so on, in turn).",
                 "edges_shifted", [](auto& I) { I.diagonal() = Vector3d(I(2, 2), I(0, 0), I(1, 1)); });
  e.wrong_output("I_xx holds a² + b² and I_zz holds b² + c²: the first and the last are exchanged.", "edges_reversed",
                 [](auto& I) { swap(I(0, 0), I(2, 2)); });
  e.wrong_input<0>("The mass does not enter.", "mass_dropped", fixed(1.0));
  e.wrong_inputs("M counts as a density here, multiplied by the volume; it is the whole mass.", "mass_as_density",
                 [](auto& M, auto a, auto b, auto c) { M *= a * b * c; });
  e.wrong_terms("Your tensor is zero: 1/12 is 0 in C++, a quotient of integers.", "integer_division", {0});
  e.is_inertia_tensor(theorem_notes, theorem_notes);
  e.route("Gauss quadrature over the body", [](auto M, auto a, auto b, auto c) {
    return tensor_of_moment(second_moment(VectorXd::Constant(8, M / 8), gauss_points_of_cuboid({a, b, c})));
  });
  e.route("from the corner, by the slides", [](auto M, auto a, auto b, auto c) {
    const Vector3d center(a / 2, b / 2, c / 2);
    return inertia_about_shifted_origin(of_cuboid(M, {a, b, c}, 1. / 3, -1. / 4), M, center, -center);
  });
  e.route("cut into eight, again and again", [](auto M, auto a, auto b, auto c) {
    // A cuboid is eight cuboids of half its size at a quarter of its edges. If I = x M a², then x = x/4 + 1/16.
    double x = 0;
    for (int cut = 0; cut < 40; ++cut) x = x / 4 + 1.0 / 16;
    return of_cuboid(M, {a, b, c}, x, 0);
  });
  e.survivor(".cwiseAbs2() / 12", "Only the squares of the edges enter.");
}
