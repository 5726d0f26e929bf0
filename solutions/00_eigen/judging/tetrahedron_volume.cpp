#include "rigid/eigen.hpp"
#include "solutions/judging/judging.hpp"

using namespace rigid;

void judge_tetrahedron_volume(Lecture& lecture) {
  auto& e =
      lecture.exercise(&tetrahedron_volume, {{"a", metre}, {"b", metre}, {"c", metre}}, {"V", metre * metre * metre});
  e.worked("a corner of a cube", {2, 0, 0}, {0, 3, 0}, {0, 0, 1});
  e.worked("three points", {1, 2, 0}, {-1, 1, 3}, {0, 2, 1});
  e.special("a left-handed corner", {0, 3, 0}, {2, 0, 0}, {0, 0, 1});
  e.special("points in a plane", {1, 0, 0}, {0, 1, 0}, {2, 3, 0});
  e.random("three points", 6, any::vector(2), any::vector(2), any::vector(2));
  e.scale([](auto& a, auto& b, auto& c) { return or_one(a.norm() * b.norm() * c.norm() / 6); });
  e.sweep({"The third point rises", "z of the third point (m)", "volume (m³)"}, {"V"}, {-3, 3},
          [](auto z) { return tuple(Vector3d(2, 0, 0), Vector3d(0, 3, 0), Vector3d(1, 1, z)); });
  e.limit("a corner of a cube", 1, "A third of the base 3 m² times the height 1 m.");

  const auto box = [](auto& a, auto& b, auto& c) { return a.dot(b.cross(c)); };
  e.wrong("This is the whole box with slanted sides: the sixth is missing.", "box",
          [box](auto& a, auto& b, auto& c) { return box(a, b, c); });
  e.wrong("A tetrahedron is a sixth of the box, a pyramid's third of half the box.", "third",
          [box](auto& a, auto& b, auto& c) { return box(a, b, c) / 3; });
  e.wrong("Your volume has the other sign: a · (b × c) is positive for a right-handed corner.", "other_sign",
          [box](auto& a, auto& b, auto& c) { return -box(a, b, c) / 6; });
  e.wrong("Your volume has lost its sign: it is negative for a left-handed corner.", "no_sign",
          [box](auto& a, auto& b, auto& c) { return abs(box(a, b, c)) / 6; });
  e.route("a determinant", [](auto& a, auto& b, auto& c) { return columns(a, b, c).determinant() / 6; });
  e.route("cyclic", [](auto& a, auto& b, auto& c) { return c.dot(a.cross(b)) / 6; });
  e.route("by components", [](auto& a, auto& b, auto& c) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum += a[i] * (b[j] * c[k] - b[k] * c[j]);
    }
    return sum / 6;
  });
}
