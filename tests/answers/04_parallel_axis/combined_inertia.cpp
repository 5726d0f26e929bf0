#include <rigid/parallel_axis.hpp>
Matrix3d combined_inertia(const VectorXd& masses, const Matrix3Xd& centers, const std::vector<Matrix3d>& tensors) {
//! right: reduced masses of all pairs
  Matrix3d I = Matrix3d::Zero();
  for (int k = 0; k < masses.size(); ++k) {
    I += tensors[k];
    for (int l = k + 1; l < masses.size(); ++l) {
      const Vector3d d = centers.col(k) - centers.col(l);
      const double reduced = masses[k] * masses[l] / masses.sum();
      I += reduced * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
  }
  return I;
//! right: one body after another joins
  Matrix3d I = tensors.at(0);
  double M = masses[0];
  Vector3d center = centers.col(0);
  for (Eigen::Index k = 1; k < masses.size(); ++k) {
    const Vector3d d = centers.col(k) - center;
    const double total = M + masses[k];
    I += tensors[k] + M * masses[k] / total * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    center += masses[k] / total * d;
    M = total;
  }
  return I;
//! right: second moments about the centre
  const Vector3d center = centers * masses / masses.sum();
  const Matrix3Xd d = centers.colwise() - center;
  const Matrix3d S = d * masses.asDiagonal() * d.transpose();
  Matrix3d I = S.trace() * Matrix3d::Identity() - S;
  for (const Matrix3d& tensor : tensors) I += tensor;
  return I;
//! wrong: a single body is carried to the origin
  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
  Matrix3d I = Matrix3d::Zero();
  for (int k = 0; k < masses.size(); ++k) {
    const Vector3d d = centers.col(k) - center;
    I += tensors[k] + masses[k] * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
  return I;
//! wrong: mean of the centres without weights
-  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
+  const Vector3d center = centers.rowwise().mean();
//! wrong: about the origin
-  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
@@
-    const Vector3d d = centers.col(k) - center;
+    const Vector3d d = centers.col(k);
//! wrong: the sum is not divided by the mass
-  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
+  const Vector3d center = centers * masses;
//! wrong: the first body is left out
-  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
+  const Vector3d center = centers * masses / masses.sum();
   Matrix3d I = Matrix3d::Zero();
-  for (int k = 0; k < masses.size(); ++k) {
+  for (int k = 1; k < masses.size(); ++k) {
//! wrong: total mass in whole kilograms
-  const Vector3d center = masses.size() > 1 ? Vector3d(centers * masses / masses.sum()) : Vector3d::Zero();
+  int total = 0;
+  Vector3d center = Vector3d::Zero();
+  for (int k = 0; k < masses.size(); ++k) {
+    total += masses[k];
+    center += masses[k] * centers.col(k);
+  }
+  center /= total;
//! wrong: tensors about different points added
  Matrix3d I = Matrix3d::Zero();
  for (const Matrix3d& tensor : tensors) I += tensor;
  return I;
//! wrong: the tensor of the first body only
  const Vector3d center = centers * masses / masses.sum();
  Matrix3d I = tensors[0];
  for (int k = 0; k < masses.size(); ++k) {
    const Vector3d d = centers.col(k) - center;
    I += masses[k] * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
  return I;
//! wrong: bodies as points
-  Matrix3d I = tensors[0];
+  Matrix3d I = Matrix3d::Zero();
