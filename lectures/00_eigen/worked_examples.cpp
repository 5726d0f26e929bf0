// Worked examples of lecture 00. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/eigen.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;
using workbook::result;

//! [vectors]
TEST_CASE("vectors: A vector takes its numbers in parentheses, a matrix behind <<") {
  //! [vectors in brief]
  Vector3d v(1, 2, 3);
  Matrix3d A;
  A << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // row by row
  Vector3d w = A * v;
  //! [vectors in brief]

  CHECK(agrees(w, Vector3d(-2, 1, 3)));
  CHECK(agrees(A, rotation_about_z(std::numbers::pi / 2), 1e-15));
  result(R"(\vec w)", w, "", "x goes to y, and y to −x");
}
//! [vectors]

//! [columns]
TEST_CASE("columns: Points stand in columns, and each column is a vector") {
  //! [columns in brief]
  Matrix3Xd r(3, 2);  // two points
  r.col(0) << 1, 0, 4;
  r.col(1) = Vector3d(3, 2, 0);
  double z = r.col(0).z();  // the same as r(2, 0)
  Vector3d middle = (r.col(0) + r.col(1)) / 2;
  //! [columns in brief]

  CHECK(z == r(2, 0));
  CHECK(agrees(middle, center_of_points(r)));
  result("z", z, "");
  result(R"(\bar{\vec r})", middle, "");
}
//! [columns]

//! [products]
TEST_CASE("products: Two vectors have three products") {
  //! [products in brief]
  Vector3d a(1, 2, 0), b(-1, 1, 3);
  double number = a.dot(b);
  Vector3d vector = a.cross(b);
  Matrix3d matrix = a * b.transpose();
  //! [products in brief]

  CHECK(number == matrix.trace());
  CHECK(agrees(tetrahedron_volume(a, b, vector), vector.squaredNorm() / 6));
  result(R"(\vec a\cdot\vec b)", number, "");
  result(R"(\vec a\times\vec b)", vector, "");
  result(R"(\vec a\,\vec b)", matrix, "");
}
//! [products]

// NOLINTBEGIN(bugprone-integer-division): what it drops is shown
//! [numbers]
TEST_CASE("numbers: Whole numbers divide without a rest") {
  //! [numbers in brief]
  double lost = 1 / 2 * 3.0;
  double kept = 1.0 / 2 * 3.0;
  double angle = 30 * std::numbers::pi / 180;  // 30 degrees
  double sine = std::sin(angle);
  //! [numbers in brief]

  CHECK(lost == 0);
  CHECK(kept == 1.5);
  CHECK(agrees(sine, 0.5));
  result(R"(\mathtt{lost})", lost, "");
  result(R"(\mathtt{kept})", kept, "");
  result(R"(\mathtt{sine})", sine, "");
}
//! [numbers]
// NOLINTEND(bugprone-integer-division)

//! [kept]
TEST_CASE("kept: auto keeps a formula, a type keeps the result") {
  //! [kept in brief]
  Vector3d a(1, 0, 0), b(0, 1, 0);
  auto formula = a + b;
  Vector3d sum = a + b;
  a.setZero();
  //! [kept in brief]

  CHECK(agrees(Vector3d(formula), b));
  CHECK(agrees(sum, Vector3d(1, 1, 0)));
  result(R"(\mathtt{formula})", Vector3d(formula), "", "computed only now, from the new a");
  result(R"(\mathtt{sum})", sum, "");
}
//! [kept]
