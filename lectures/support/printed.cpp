#include "lectures/support/printed.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace workbook {

namespace {

/// A rounded zero is printed as 0, never as −0 or 1e-17.
double tidy(double number, double size) { return std::abs(number) <= 1e-15 * size ? 0.0 : number; }

}  // namespace

Printed::~Printed() {
  const char* file = std::getenv("WORKBOOK_PRINTED");
  if (file == nullptr) return;
  std::ofstream out(file, std::ios::app);
  out << '[' << region_ << "]\n" << text_ << '[' << region_ << "]\n\n";
}

void Printed::matrix(const Eigen::MatrixXd& matrix, const std::string& format) {
  const double size = matrix.size() > 0 ? matrix.cwiseAbs().maxCoeff() : 0.0;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      text_ += "  " + fmt::format(fmt::runtime(format), tidy(matrix(i, j), size));
    }
    text_ += '\n';
  }
}

std::string row(const Eigen::VectorXd& vector, const std::string& format) {
  const double size = vector.size() > 0 ? vector.cwiseAbs().maxCoeff() : 0.0;
  std::string text;
  for (const double component : vector) {
    text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(format), tidy(component, size));
  }
  return '(' + text + ')';
}

}  // namespace workbook
