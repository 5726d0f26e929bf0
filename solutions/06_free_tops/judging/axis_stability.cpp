#include "solutions/06_free_tops/shared.hpp"

/// How the moment compares with those of the two other axes: +1 larger, −1 smaller, 0 equal.
static Vector2d compared(const Vector3d& I, int axis) {
  return (I[axis] - turned_round(I, axis).head<2>().array()).sign();
}

/// A rule that says `at_tie` where another moment equals this one, and otherwise +1 where the rule holds, −1 where not.
template <class Rule>
static auto with_ties(int at_tie, const Rule& rule) {
  return [=](auto& I, int axis) { return (compared(I, axis).array() == 0).any() ? at_tie : rule(I, axis) ? 1 : -1; };
}

void judge_axis_stability(Lecture& lecture) {
  auto& e = lecture.exercise(&axis_stability, {{"I", positive(kg_m2)}, {"axis", none}}, {"stability", none});
  e.domain([](auto&, int axis) { return 0 <= axis && axis <= 2; });
  e.worked("moments 2, 3, 1: the intermediate moment", {2, 3, 1}, 0);
  e.worked("moments 2, 3, 1: the largest moment", {2, 3, 1}, 1);
  e.worked("moments 2, 3, 1: the smallest moment", {2, 3, 1}, 2);
  e.worked("moments 3, 2, 1: the intermediate moment", {3, 2, 1}, 1);
  e.worked("a flattened symmetric top about its symmetry axis", {1, 1, 1.8}, 2);
  e.worked("a flattened symmetric top across its symmetry axis", {1, 1, 1.8}, 0);
  e.worked("a long symmetric top about its symmetry axis", {2, 0.5, 2}, 1);
  e.worked("a long symmetric top across its symmetry axis", {2, 0.5, 2}, 2);
  e.worked("a flattened symmetric top across its symmetry axis, the other way", {1, 1, 1.8}, 1);
  e.worked("a long symmetric top across its symmetry axis, the other way", {2, 0.5, 2}, 0);
  e.worked("a sphere", {2, 2, 2}, 1);
  e.special("moments that differ by a thousandth, about the middle one", {1.001, 1, 1.002}, 0);
  e.special("moments that differ by a thousandth, about the largest", {1.001, 1, 1.002}, 2);
  for (int k = 0; k < 3; ++k)
    e.random("a random body, axis " + std::to_string(k), 4, &Random::principal_moments, [k](Random&) { return k; });
  e.scale(1);
  e.sweep({"Spin about axis 3 of a body with I₁ = 2, I₂ = 3 kg m²", "I₃ (kg m²)",
           "stable (+1), neutral (0) or unstable (−1)"},
          {"stability"}, {1, 5, 60}, [](auto I3) { return tuple(Vector3d(2, 3, I3), 2); });

  // What a wrong rule makes of ties is its author's choice: each comes in the plausible versions, with one message.
  const auto largest = [](auto& I, int axis) { return I[axis] == I.maxCoeff(); };
  const auto smallest = [](auto& I, int axis) { return I[axis] == I.minCoeff(); };
  const auto extreme = [](auto& I, int axis) { return axis_stability(I, axis) > 0; };
  const auto outer = [](auto&, int axis) { return axis != 1; };
  const Sentence only_largest = "Only the axis of largest moment is called stable here; so is that of the smallest.";
  const Sentence only_smallest = "Only the axis of smallest moment is called stable here; so is that of the largest.";
  const Sentence by_number =
      "Your answer goes by the number of the axis; what counts is which moment lies between the others.";
  const Sentence ties =
      "Another moment equals this one: neutral, 0, as a disturbance neither grows exponentially nor is restored.";
  for (const int at_tie : {0, 1, -1}) {
    const std::string version = at_tie == 0 ? "" : at_tie > 0 ? "_ties_stable" : "_ties_unstable";
    e.wrong(only_largest, "only_largest" + version, with_ties(at_tie, largest));
    e.wrong(only_smallest, "only_smallest" + version, with_ties(at_tie, smallest));
    e.wrong(by_number, "by_number" + version, with_ties(at_tie, outer));
    if (at_tie != 0) e.wrong(ties, "no_neutral_axis" + version, with_ties(at_tie, extreme));
  }
  e.wrong(only_largest, "largest_with_ties", [=](auto& I, int axis) { return largest(I, axis) ? 1 : -1; });
  e.wrong(only_smallest, "smallest_with_ties", [=](auto& I, int axis) { return smallest(I, axis) ? 1 : -1; });
  e.wrong(by_number, "by_number_first",
          [=](auto& I, int axis) { return axis == 1 ? -1 : with_ties(0, outer)(I, axis); });
  e.wrong(by_number, "by_number_alone", [=](auto& I, int axis) { return outer(I, axis) ? 1 : -1; });
  e.wrong_output("Stable and unstable are exchanged: +1 means stable.", "opposite", negated);
  e.wrong_input<1>("This comes out when the axes count from 1; here they are 0, 1 and 2.", "counted_from_one",
                   [](int axis) { return (axis + 2) % 3; });
  e.wrong("Every axis of a body with two equal moments is neutral here; its symmetry axis is stable.",
          "symmetric_top_neutral", [](auto& I, int axis) {
            return axis_stability(I, 0) * axis_stability(I, 1) == 0 ? 0 : axis_stability(I, axis);
          });
  e.wrong_output("The intermediate axis is neutral here; a disturbance grows there exponentially: −1.",
                 "unstable_as_neutral", [](int stability) { return max(stability, 0); });
  e.wrong("Every axis is stable here; the intermediate one is not.", "always_stable", [](auto&, int) { return 1; });
  for (const int k : {0, 1})
    e.wrong("Only one of the two other moments makes an axis neutral here by being equal; either does.",
            k == 0 ? "next_equal_only" : "previous_equal_only", [=](auto& I, int axis) {
              const Vector2d signs = compared(I, axis);
              return signs[k] == 0 ? 0 : signs.prod() < 0 ? -1 : 1;
            });
  e.wrong("This compares with only one of the other two moments; both decide.", "compares_one_neighbour",
          [](auto& I, int axis) { return static_cast<int>(compared(I, axis)[0]); });
  e.route("rank among the moments", [](auto& I, int axis) {
    const auto smaller = (I.array() < I[axis]).count(), larger = (I.array() > I[axis]).count();
    return smaller + larger < 2 ? 0 : smaller == larger ? -1 : 1;
  });
  e.route("signs of the two rates", [](auto& I, int axis) {
    const double product = linearized_rates(turned_round(I, axis), 1).prod();
    return (product > 0) - (product < 0);
  });
  e.route("sorted", [](auto& I, int axis) {
    Vector3d sorted = I;
    std::sort(sorted.begin(), sorted.end());
    if (std::count(sorted.begin(), sorted.end(), I[axis]) > 1) return 0;
    return I[axis] == sorted[1] ? -1 : 1;
  });
  e.survivor("return sign(I[axis]", "The same two other axes.");
}
