#include "rigid/eigen.hpp"
#include "solutions/judging/judging.hpp"

using namespace rigid;

void judge_center_of_points(Lecture& lecture) {
  auto& e = lecture.exercise(&center_of_points, {{"r", metre}}, {"center", metre});
  e.domain([](auto& r) { return r.cols() >= 1; });
  e.worked("three points", Matrix3Xd{{1, 2, 6}, {0, 3, -3}, {4, 4, 1}});
  e.special("one point", Matrix3Xd{{1}, {2}, {3}});
  e.special("two opposite points", Matrix3Xd{{1, -1}, {2, -2}, {-3, 3}});
  e.random("some points", 6, [](Random& random) { return random.points(random.whole(3, 7)); });
  e.scale([](auto& r) { return or_one(r.cwiseAbs().maxCoeff()); });
  e.sweep({"The third point moves along x", "x of the third point (m)", "x of the mean (m)"}, {"x"}, {-6, 6},
          [](auto x) {
            return Matrix3Xd{{1, 2, x}, {0, 3, -3}, {4, 4, 1}};
          });
  e.limit("one point", {1, 2, 3}, "One point is its own mean.");

  e.wrong("This is the sum: the division by the number of points is missing.", "sum",
          [](auto& r) -> Vector3d { return r.rowwise().sum(); });
  e.wrong("Your mean divides by 3, the number of rows, not by the number of points r.cols().", "by_rows",
          [](auto& r) -> Vector3d { return r.rowwise().sum() / 3; });
  e.wrong("The first point is left out: columns count from 0.", "first_point_lost", [](auto& r) -> Vector3d {
    return r.rightCols(r.cols() - 1).rowwise().sum() / static_cast<double>(r.cols());
  });
  e.wrong("The last point is left out.", "last_point_lost",
          [](auto& r) -> Vector3d { return r.leftCols(r.cols() - 1).rowwise().sum() / static_cast<double>(r.cols()); });
  e.wrong("You divide by one less than the number of points.", "one_less",
          [](auto& r) -> Vector3d { return r.rowwise().sum() / max(static_cast<double>(r.cols()) - 1, 1.0); });
  e.wrong("Each point is averaged half and half with the mean of those before it, so later ones count more.",
          "half_and_half", [](auto& r) {
            Vector3d mean = r.col(0);
            for (Eigen::Index i = 1; i < r.cols(); ++i) mean = (mean + r.col(i)) / 2;
            return mean;
          });
  e.wrong("This is the middle between the smallest and the largest of each component; all points count in a mean.",
          "middle_of_box", [](auto& r) -> Vector3d { return (r.rowwise().minCoeff() + r.rowwise().maxCoeff()) / 2; });
  e.route("one point after the other", [](auto& r) {
    Vector3d sum = Vector3d::Zero();
    for (Eigen::Index i = 0; i < r.cols(); ++i) sum += r.col(i);
    return Vector3d(sum / static_cast<double>(r.cols()));
  });
  e.route("a product with ones",
          [](auto& r) -> Vector3d { return r * VectorXd::Constant(r.cols(), 1.0 / static_cast<double>(r.cols())); });
  e.route("a mean that moves", [](auto& r) {
    Vector3d mean = r.col(0);
    for (Eigen::Index i = 1; i < r.cols(); ++i) mean += (r.col(i) - mean) / static_cast<double>(i + 1);
    return mean;
  });
}
