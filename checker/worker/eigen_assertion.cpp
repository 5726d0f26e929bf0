#include "checker/worker/prelude.hpp"

#include <string>
#include <string_view>

namespace workbook {
namespace {

struct Explanation {
  std::string_view fragment;  ///< of the condition as Eigen 3.4 writes it
  const char* sentence;
};

constexpr const char* outside_vector =
    "an index lies outside its vector; a vector of size n has the indices 0 to n - 1";
constexpr const char* outside_block = "a block, segment, head or tail reaches beyond its matrix or vector";
constexpr const char* different_sizes = "two operands of a sum, difference or assignment have different sizes";
constexpr const char* not_its_size =
    "a matrix or vector is given a size that is negative or that its type does not allow";
constexpr const char* square_needed = "inverse, determinant and eigenvalues need a square matrix";
constexpr const char* braces = "the rows in the braces do not have the size of their matrix";

/// The first that fits counts: particular ones stand before general ones.
constexpr Explanation explanations[] = {
    {"Too few coefficients", "too few numbers follow <<; it must fill the whole matrix or vector"},
    {"Too many coefficients", "too many numbers follow << for this matrix or vector"},
    {"Too many rows", "too many numbers follow << for this matrix or vector"},
    {"Cannot comma-initialize", "<< puts numbers into a matrix or vector without entries; give it a size first"},
    {"m_currentBlockRows", "the parts joined by << do not have the same number of rows"},
    {"invalid matrix product",
     "in a matrix product the left factor must have as many columns as the right one has rows"},
    {"aliasing detected during transposition",
     "A = A.transpose() overwrites A while reading it; use A.transposeInPlace() or A.transpose().eval()"},
    {"Aliasing problem detected in inverse", "A = A.inverse() overwrites A while reading it; use A.inverse().eval()"},
    {"transposeInPlace() called on a non-square", "transposeInPlace() needs a square matrix"},
    {"you are using an empty matrix", "an empty matrix or vector has no largest, smallest or mean entry"},
    {"eigenvectors have not been computed",
     "the solver was told to compute eigenvalues only, and is asked for eigenvectors"},
    {"is not initialized", "a decomposition is used before compute() was called"},
    {"invalid number of rows of the right hand side",
     "solve() needs a right-hand side with as many rows as the matrix has"},
    {"non-square matrix", square_needed},
    {"index >= 0 && index < size()", outside_vector},
    {"row >= 0 && row < rows()", "a row or column index lies outside its matrix; indices start at 0"},
    {"(i>=0) && (", "row(i) or col(i) is asked for an i that the matrix does not have; indices start at 0"},
    {"startRow >= 0", outside_block},
    {"RowsAtCompileTime==blockRows", outside_block},
    {"aLhs.rows() == aRhs.rows()", different_sizes},
    {"dst.rows() ==", different_sizes},
    {"dst.rows()==", different_sizes},
    {"does not actually allow one to resize", different_sizes},
    {"list_size ==", braces},
    {"list.size() ==", braces},
    {"other.rows() == 1 || other.cols() == 1", "a matrix of several rows and columns is assigned to a vector"},
    {"RowsAtCompileTime == rows", not_its_size},
    {"rows==RowsAtCompileTime", not_its_size},
    {"SizeAtCompileTime == size", not_its_size},
    {"SizeAtCompileTime == vecSize", not_its_size},
    {"rows >= 0 && cols >= 0", not_its_size},
    {"vecSize >= 0", not_its_size},
    {"a_index <= m_matrix.cols()", "diagonal(i) is asked for a diagonal that the matrix does not have"},
    {"rows() == other.rows()", different_sizes},
    {"rows()==other.rows()", different_sizes},
    {"size() == other.size()", "dot() needs two vectors of the same size"},
    {"this->rows() == 1 && this->cols() == 1", "only a matrix with one entry can be used as a number"},
    {"rows() == cols()", square_needed},
    {"cols() == matrix.rows()", square_needed},
};

std::string explain(std::string_view condition) {
  for (const Explanation& explanation : explanations)
    if (condition.find(explanation.fragment) != std::string_view::npos)
      return std::string("Eigen stopped the calculation: ") + explanation.sentence;
  return "Eigen stopped the calculation, because this does not hold: " + std::string(condition);
}

}  // namespace

void report_eigen_assertion(const char* condition) {
  // While `v << 1, f(), 3` is left because f threw, its destructor finds numbers missing; the first exception counts.
  if (std::uncaught_exceptions() > 0 &&
      std::string_view(condition).find("Too few coefficients") != std::string_view::npos)
    return;
  throw EigenError(explain(condition));
}

}  // namespace workbook
