#include <rigid/eigen.hpp>
Vector3d center_of_points(const Matrix3Xd& r) {
//! right: a running mean
  Vector3d mean = r.col(0);
  for (int i = 1; i < r.cols(); ++i) mean += (r.col(i) - mean) / (i + 1);
  return mean;
//! wrong: half the mean so far and half the next point
-  for (int i = 1; i < r.cols(); ++i) mean += (r.col(i) - mean) / (i + 1);
+  for (int i = 1; i < r.cols(); ++i) mean = 0.5 * (mean + r.col(i));
