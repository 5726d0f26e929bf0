// An experiment of your own: any program that calls your functions. `./checker/run try` builds and runs it.
#include <rigid/inertia_tensor.hpp>

#include <iostream>

using namespace rigid;

int main() {
  // The four masses of lecture 03 in kg, and their places in m: a column for each.
  const VectorXd m{{1, 2, 3, 4}};
  const Matrix3Xd r{{1, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 3, 1}};
  const Matrix3d I = inertia_of_points(m, r);
  std::cout << "The inertia tensor about the origin, in kg m²:\n" << I << "\n";
}
