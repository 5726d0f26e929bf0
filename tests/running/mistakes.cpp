// The mistakes that compilers complain about: each file is compiled as a student's, and the sentence must name the
// mistake.
#include "tests/running/student.hpp"

#include "checker/compile/code_text.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

namespace workbook::testing {
namespace {

/// The body of `double twice(double x)` inside the namespace, from line 3 on.
std::string body(const std::string& text) {
  return "namespace rigid {\ndouble twice(double x) {\n" + text + "\n}\n}\n";
}

/// The body of `Matrix3d scaled(const Matrix3d& A, double factor)`.
std::string matrix_body(const std::string& text) {
  return "namespace rigid {\nMatrix3d scaled(const Matrix3d& A, double factor) {\n" + text + "\n}\n}\n";
}

struct BrokenFile {
  std::string about;
  std::string text;
  int line;
  const char* at;  ///< the code above the caret begins so; empty: behind the end of the line
  std::string sentence;
};

/// What stands above the caret.
std::string code_at_caret(const std::string& excerpt) {
  const std::size_t end = excerpt.find('\n');
  const std::size_t caret = excerpt.find('^', end);
  if (end == std::string::npos || caret == std::string::npos) return "no caret";
  const std::string line = excerpt.substr(0, end);
  return line.substr(byte_at_column(line, static_cast<int>(caret - end)));
}

Finding first_error_of(const std::string& text) {
  const Compilation compilation =
      compile_text(text, text.find("scaled(const") == std::string::npos ? "twice" : "scaled");
  CHECK_FALSE(compilation.executable.has_value());
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK_FALSE(compilation.details.empty());
  REQUIRE(compilation.findings.size() == 1);
  const Finding& finding = compilation.findings.front();
  CHECK(compilation.message ==
        "Your file does not compile: the first error is in line " + std::to_string(finding.line) + ".");
  CHECK(refused(compilation).findings.size() == 1);
  return finding;
}

void check(const std::vector<BrokenFile>& files) {
  for (const BrokenFile& file : files) {
    CAPTURE(file.about);
    const Finding finding = first_error_of(file.text);
    CHECK(finding.line == file.line);
    CHECK(finding.sentence == file.sentence);
    CHECK(finding.sentence.size() <= 210);
    const std::string code = code_at_caret(finding.excerpt);
    CHECK_MESSAGE((*file.at == '\0' ? code.empty() : code.starts_with(file.at)), finding.excerpt);
  }
}

const char* const power =
    "^ is not a power in C++ (it combines the bits of whole numbers); write x * x or std::pow(x, 2).";
const char* const uncalled =
    "A function is named here, but not called: its parentheses are missing, as in A.transpose(), v.norm() or cos(x).";
const char* const brackets =
    "An entry of a matrix is A(i, j), with parentheses; the brackets [ ] work with vectors only.";
const char* const list = "A list of numbers is put into a vector or matrix with <<, not with =, as in v << 1, 2, 3;";
const char* const two_vectors =
    "Two vectors cannot be multiplied by *: write a.dot(b) for the scalar product, or a.cross(b) for the cross "
    "product.";
const char* const constant_A = "`A` is const and cannot be changed; make a variable of your own for the result.";
const char* const no_pi = "C++ has no pi of that name: write std::numbers::pi.";
const char* const semicolon = "A ; is missing here, at the end of the statement.";
const char* const outside =
    "`Vector3d` is known in the namespace rigid only: your function must stand between `namespace rigid {` and its "
    "`}`.";
const char* const foreign =
    "Here stands a character that C++ does not know, perhaps copied from a document: type the operators and quotation "
    "marks on the keyboard.";

}  // namespace

TEST_CASE("mistakes with sizes are named") {
  check({
      {"two sizes added", body("Vector3d a; Vector2d b;\nreturn (a + b)(0);"), 4, "b)",
       "The two sides of + have different sizes: a 3×1 vector and a 2×1 vector."},
      {"two sizes subtracted in place", body("Vector3d a; Matrix3d b;\na -= b; return x;"), 4, "b;",
       "The two sides of -= have different sizes: a 3×1 vector and a 3×3 matrix."},
      {"assigned to a smaller one", body("Matrix3d b;\nVector3d a = b; return a(0);"), 4, "b;",
       "A 3×3 matrix does not fit into a 3×1 vector."},
      {"an outer product where a vector is meant", body("Vector3d a;\nVector3d b = a * a.transpose(); return b(0);"), 4,
       ")", "A 3×3 matrix does not fit into a 3×1 vector."},
      {"a row where a column is meant", body("Vector3d a; Matrix3d I;\nreturn (a + I.row(0))(0);"), 4, ")",
       "A row and a column meet at +: a 3×1 vector and a 1×3 row vector. Transpose one of them, as in v.transpose()."},
      {"a matrix times a row", body("Vector3d a; Matrix3d I;\nreturn (I * a.transpose())(0);"), 4, ")",
       "In a product, the left side must have as many columns as the right side has rows; here a 3×3 matrix with 3 "
       "columns stands before a 1×3 row vector with 1 row."},
      {"* for the scalar product", body("Vector3d a, b;\nreturn a * b;"), 4, "b;", two_vectors},
      {"* for the cross product", body("Vector3d a, b;\nVector3d c = a * b; return c(0);"), 4, "b;", two_vectors},
      {"cross product of long vectors", body("VectorXd a(3), b(3);\nreturn a.cross(b)(0);"), 4, "(b)",
       "cross() needs two vectors with exactly three components, and the types must say so: use Vector3d, not "
       "VectorXd."},
      {"dot product with a matrix", body("Vector3d a; Matrix3d I;\nreturn a.dot(I);"), 4, "(I)",
       "dot() needs two vectors with the same number of components; multiply a matrix and a vector by *."},
      {"too few numbers", body("Vector3d a(x, x);\nreturn a(0);"), 3, ");",
       "The number of values in the parentheses or braces does not fit a Vector3d."},
      {"too many numbers", body("Vector3d a = {x, x, x, x};\nreturn a(0);"), 3, "};",
       "The number of values in the parentheses or braces does not fit a Vector3d."},
      {"numbers of a matrix in parentheses", body("Matrix3d a(1, 2, 3, 4, 5, 6, 7, 8, 9);\nreturn a(0, 0);"), 3, ");",
       "The numbers of a matrix do not go into its parentheses: define the matrix, then fill it with <<, as in A << 1, "
       "2, 3, ...;"},
      {"a matrix of zeros by (0)", body("Matrix3d a(0);\nreturn a(0, 0);"), 3, ");",
       "One number in parentheses does not make a Matrix3d: write Matrix3d::Zero(), Matrix3d::Identity() or "
       "Matrix3d::Constant(number)."},
  });
}

TEST_CASE("mistakes with operators are named") {
  check({
      {"^ for power", body("return x^2;"), 3, "^2", power},
      {"^ for the power of a norm", body("Vector3d v;\nreturn 0.5 * v.norm()^2;"), 4, "^2", power},
      {"** for power", body("return x**2;"), 3, "*2", "** is not a power in C++; write x * x or std::pow(x, 2)."},
      {"= for <<", body("Vector3d v;\nv = 1, 2, x; return v(0);"), 4, "1, 2", list},
      {"= with a list at once", body("Vector3d v = 1, 2, x; return v(0);"), 3, "1, 2", list},
      {"a number assigned to a matrix", body("Matrix3d I = 0; return I(0, 0);"), 3, "0;",
       "A number is assigned to a Matrix3d: write Matrix3d::Zero() for zeros, or Matrix3d::Constant(number)."},
      {"a number added to a matrix", matrix_body("return A + 1;"), 3, "+ 1",
       "A number and a matrix or vector cannot be joined by +; multiply the number by Identity() if a matrix is meant, "
       "as in x * Matrix3d::Identity()."},
      {"division by a vector", body("Vector3d a, b;\nreturn (a / b)(0);"), 4, "/ b",
       "One cannot divide by a 3×1 vector: a.cwiseQuotient(b) divides component by component, and A.inverse() is the "
       "inverse of a matrix."},
      {"pow of a vector", body("Vector3d a;\nreturn std::pow(a, 2);"), 4, "(a",
       "pow takes a number, but here it is given a 3×1 vector; a vector's length is v.norm(), its square "
       "v.squaredNorm()."},
      {"a vector returned for a number", body("Vector3d a;\nreturn 2 * a;"), 4, "* a",
       "The function returns a number, but what is returned here is a 3×1 vector."},
      {"a number returned for a matrix", matrix_body("return factor;"), 3, "factor",
       "The function returns a 3×3 matrix, but what is returned here is a number."},
      {"a matrix with one entry for a number",
       body("Vector3d a, b;\nreturn x * (a.transpose() * b) / (b.transpose() * b);"), 4, "/ (b",
       "This is a matrix with one entry, not a number: write a.dot(b) in place of a.transpose() * b, or put .value() "
       "behind the product in parentheses."},
      {"std::vector as a vector", body("std::vector<double> v(3);\nreturn (v + v)[0];"), 4, "+ v",
       "A std::vector or an array is only a list: it cannot be added, multiplied or turned into a vector of Eigen. Use "
       "Vector3d or VectorXd for calculating."},
      {"% of doubles", body("return x % 2;"), 3, "% 2",
       "% is the remainder of whole numbers only; for doubles write std::fmod(a, b)."},
      {"=> for >=", body("if (x => 0) return 1;\nreturn x;"), 3, "> 0",
       "=> does not exist in C++; greater or equal is >=."},
  });
}

TEST_CASE("mistakes with brackets and calls are named") {
  check({
      {"A[i][j]", matrix_body("Matrix3d B;\nB[0][1] = factor; return B;"), 4, "[1]", brackets},
      {"A[i, j]", matrix_body("Matrix3d B;\nB[0, 1] = factor; return B;"), 4, "] =", brackets},
      {"A(i)(j)", matrix_body("Matrix3d B;\nB(0)(1) = factor; return B;"), 4, "(1)",
       "What stands here is no function, but ( stands behind it: write * if a product is meant; an entry of a matrix "
       "is A(i, j)."},
      {"a missing * before a parenthesis", body("return x(x + 1);"), 3, "(x",
       "`x` is no function, but ( stands behind it: write * if a product is meant; an entry of a matrix is A(i, j)."},
      {"a missing * after a number", body("return 2x;"), 3, "2x",
       "A * is missing behind a number: a product is written 2 * x, not 2x."},
      {"a method without parentheses", matrix_body("return A.transpose * A;"), 3, "* A", uncalled},
      {"norm without parentheses", body("Vector3d v;\nreturn v.norm;"), 4, "norm", uncalled},
      {"Zero without parentheses", matrix_body("return Matrix3d::Zero;"), 3, "Zero", uncalled},
      {"sin without parentheses", body("return sin x;"), 3, "sin", uncalled},
      {"cross as a free function", body("Vector3d a, b;\nVector3d c = cross(a, b); return c(0);"), 4, "cross",
       "`cross` is a method: it stands behind a vector or matrix and a dot, as in a.cross(b)."},
      {"types in a call", body("return scaled(const Matrix3d& A, double f)(0, 0);"), 3, "const",
       "Where a function is called, only values stand in the parentheses, without their types."},
      {"a dot for ::", body("Matrix3d A = Matrix3d.Identity(); return A(0, 0);"), 3, ".Identity",
       "Behind the name of a type or namespace stands ::, not a dot, as in Matrix3d::Identity() or std::sqrt(x)."},
  });
}

TEST_CASE("mistakes with const, types and names are named") {
  check({
      {"an entry of an argument changed", matrix_body("A(0, 1) = factor;\nreturn A;"), 3, "= factor", constant_A},
      {"an argument scaled", matrix_body("A *= factor;\nreturn A;"), 3, "*= factor", constant_A},
      {"an argument assigned", matrix_body("A = factor * A;\nreturn A;"), 3, "A;", constant_A},
      {"an argument transposed in place", matrix_body("A.transposeInPlace();\nreturn A;"), 3, "(", constant_A},
      {"another result type", "namespace rigid {\nVector3d twice(double x) { return {x, x, x}; }\n}\n", 2, "twice",
       "The result type differs from the contract: it says `double twice(double x)`."},
      {"no result type", "namespace rigid {\ntwice(double x) { return 2 * x; }\n}\n", 2, "twice",
       "The result type is missing before the name of the function, as the double in double f(double x)."},
      {"other parameters", "double rigid::twice(double& x) { return 2 * x; }\n", 1, ")",
       "The contract has no `double rigid::twice(double&)`; keep the result, the name and the parameters of `double "
       "twice(double x)`."},
      {"const behind the parentheses", "namespace rigid {\ndouble twice(double x) const { return x; }\n}\n", 2, "const",
       "The const behind the parentheses is for methods of a class only; leave it out."},
      {"a static function", "namespace rigid {\nstatic double twice(double x) { return x; }\n}\n", 2, "twice",
       "The function of an exercise must not be static: leave out this word."},
      {"outside the namespace", "double twice(double x) {\n  Vector3d v;\n  return 2 * x;\n}\n", 2, "Vector3d",
       outside},
      {"a result type outside the namespace", "Vector3d twice(double x) { return {x, x, x}; }\n", 1, "Vector3d",
       outside},
      {"a misspelt name", body("double result = 2 * x;\nreturn reslut;"), 4, "reslut",
       "There is no `reslut`; did you mean `result`?"},
      {"a misspelt method", body("Vector3d v;\nreturn v.squaredNrom();"), 4, "squaredNrom",
       "A Vector3d has nothing called `squaredNrom`; did you mean `squaredNorm`?"},
      {"length for norm", body("Vector3d v;\nreturn v.length();"), 4, "length",
       "A Vector3d has nothing called `length`; did you mean `norm`?"},
      {"a method of a number", body("return x.norm();"), 3, "norm", "`x` is a number and has no `norm`."},
      {"an undeclared name", body("y = 2 * x; return y;"), 3, "y",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"std:: left out", body("vector<double> v; return x;"), 3, "vector",
       "The namespace is missing: write `std::vector` for `vector`."},
      {"Eigen:: left out", body("RowVector3d v; return x;"), 3, "RowVector3d",
       "The namespace is missing: write `Eigen::RowVector3d` for `RowVector3d`."},
      {"pi", body("return pi * x;"), 3, "pi", no_pi},
      {"M_Pi", body("return PI * x;"), 3, "PI", no_pi},
      {"sine of degrees", body("return sind(x);"), 3, "sind",
       "There is no function `sind`: sin and its relatives work in radians, as all angles of the course do."},
      {"a missing header", body("std::set<int> s; return x;"), 3, "set",
       "`std::set` needs a header: write #include <set> at the top of your file."},
      {"a wrong header", "#include <Eigen>\n" + body("return x;"), 1, "<Eigen>",
       "There is no header `Eigen`: Eigen is <Eigen/Dense>, and the header of the lecture is named at the top of the "
       "file you were given."},
      {"include without #", "include <cmath>\n" + body("return x;"), 1, "cmath", "A # is missing: write #include."},
      {"declared twice", body("Vector3d v;\nVector3d v; return x;"), 4, "v;",
       "`v` is declared for the second time; to give it a new value, leave out the type."},
      {"an argument declared again", body("double x = 3; return x;"), 3,
       "x =", "`x` is an argument of the function already: leave out the type to change it, or choose another name."},
  });
}

TEST_CASE("mistakes with punctuation are named, where they were made") {
  check({
      {"a missing ; before the next line", body("double y = 2 * x\nreturn y;"), 3, "", semicolon},
      {"a missing ; before a comment", body("double y = 2 * x  // twice\n\nreturn y;"), 3, " ", semicolon},
      {"a missing ; before a brace", body("return 2 * x"), 3, "", semicolon},
      {"a missing ; after a declaration", body("Vector3d v\nv << 1, 2, 3; return v(0);"), 3, "", semicolon},
      {"a missing operator", body("return 2 * (x + 1) x;"), 3, " x;",
       "Before `x` something is missing, such as an operator (a * is never left out), a comma or a ;"},
      {"a missing }",
       "namespace rigid {\ndouble twice(double x) {\n  if (x > 0) {\n    return 2 * x;\n  return x;\n}\n}\n", 7, "",
       "A closing brace } is missing: the file ends while a { is still open. Count the braces from here upwards."},
      {"a } too many", body("return 2 * x;\n}"), 6, "}",
       "There is one } too many: all braces are closed before this one."},
      {"a missing )", body("return 2 * (x + 1;"), 3, ";", "A ) is missing here."},
      {"a ) too many", body("return 2 * x + 1);"), 3, ")", "There is a ) too many, or its ( is missing."},
      {"if without parentheses", body("if x > 0 return x;\nreturn 0;"), 3, "x >",
       "Behind if, for and while stand parentheses, as in if (x > 0) or for (int i = 0; i < 3; ++i)."},
      {"; behind if", body("if (x > 0); x = 1; else x = 2;\nreturn x;"), 3, "else",
       "This else belongs to no if: look for a ; directly behind the if (...), or put the statements before the else "
       "into braces."},
      {"' for the transpose", body("Vector3d a;\nreturn a' * a;"), 4, "' *",
       "An apostrophe does not transpose in C++; write A.transpose()."},
      {"a minus sign from a document", body("return 2 − x;"), 3, "−", foreign},
      {"a centred dot", body("return 2 · x;"), 3, " ·", foreign},
      {"a list in brackets", body("Vector3d v = [1, 2, 3]; return v(0);"), 3, "1",
       "A list of numbers stands in braces or behind <<, not in [ ]: write Vector3d v(1, 2, 3);"},
      {"a comment without end", body("return 2 * x; /* twice"), 3, "/*",
       "The comment that begins here has no end: */ is missing."},
  });
}

TEST_CASE("of an error without a name, the line, the caret and the compiler's words are shown") {
  check({
      {"an #error", "// a comment\n#error \"not today\"\n", 2, "error", "The compiler says: #error \"not today\"."},
      {"an error in a macro", "#define HALF(a) ((a) / y)\n" + body("return HALF(x);"), 1, "y)",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"inside a template that another one calls",
       "template <class T> T f(T t) {\n  return t.foo();\n}\ntemplate <class T> T g(T t) { return f(t); }\n" +
           body("return g(Eigen::Vector3d(x, x, x))(0);"),
       2, "foo", "A Vector3d has nothing called `foo`."},
      {"sizes inside a template",
       "template <class T> void f(T t) {\n  t += Eigen::Vector2d(1, 2);\n}\n" + body("f(Vector3d(x, x, x)); return x;"),
       2, "+=", "The two sides of += have different sizes: a 3×1 vector and a 2×1 vector."},
      {"on the last line, which has no end", "namespace rigid { double twice(double x) { return y; } }", 1, "y;",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"in lines with the ends of another system",
       "namespace rigid {\r\ndouble twice(double x) {\r\n  return y;\r\n}\r\n}\r\n", 3, "y;",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"behind tabs", body("\tdouble a = 1;\treturn a + y;"), 3, "y;",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"in a foreign alphabet, which is none", body("double ω = x; return ω + q;"), 3, "q;",
       "`q` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"behind a text over several lines", body("const char* s = R\"(\n  1/2\n)\"; return y;"), 5, "y;",
       "`y` is not known here: is it spelt as where it was declared, and was that before this line?"},
      {"an operator that nobody has", body("Vector3d a;\nreturn !a;"), 4, "!a",
       "The compiler says: no match for 'operator!' (operand type is 'Vector3d')."},
      {"advice of Eigen", body("Vector3d a, b;\nreturn (a || b)(0);"), 4, "b)",
       "Eigen says: this method is only for expressions of bool."},
      {"a class in place of the namespace", "class rigid { double twice(double x) { return x; } };\n", 1, "rigid",
       "The compiler says: 'struct rigid' redeclared as different kind of entity."},
      {"a wrong use of a keyword", body("inline double v; return x;"), 3, "inline",
       "The compiler says: 'inline' specifier invalid for variable 'v' declared at block scope."},
  });
}

TEST_CASE("the caret finds its place behind wide and accented letters") {
  const Finding finding = first_error_of(body("/* Trägheit ω 角速度 */ return y;"));
  CHECK(finding.line == 3);
  // Three letters that are two columns wide.
  CHECK(finding.excerpt == "/* Trägheit ω 角速度 */ return y;\n" + std::string(31, ' ') + "^");
}

TEST_CASE("of a very long line, the part around the caret is shown") {
  const Finding finding =
      first_error_of(body("/* " + std::string(2000, 'a') + " */ return y; // " + std::string(8000, 'b')));
  CHECK(finding.line == 3);
  CHECK(finding.excerpt.find("return y;") != std::string::npos);
  CHECK(finding.excerpt.starts_with("…"));
  CHECK(finding.excerpt.size() < 250);
}

TEST_CASE("a line too long for the compiler to count is shown with its beginning") {
  const Finding finding = first_error_of(body("double z = 0" + std::string(20000, ' ') + "+ y; return z;"));
  CHECK(finding.line == 3);
  CHECK(finding.excerpt.size() < 250);
}

TEST_CASE("an error message of a template without end stays short") {
  const Finding finding = first_error_of(
      "template <int n, class T> struct Deep { using type = typename Deep<n - 1, std::vector<T>>::type; };\n"
      "template <class T> struct Deep<0, T> { using type = typename T::missing; };\n" +
      body("Deep<8, double>::type d; return x;"));
  CHECK(finding.line > 0);
  CHECK(finding.sentence.size() <= 400);
  CHECK_FALSE(finding.excerpt.empty());
}

TEST_CASE("control characters of the file do not reach the terminal") {
  const Finding finding = first_error_of(body("/* \x1b[31m */ return y;"));
  CHECK(finding.excerpt.find('\x1b') == std::string::npos);
  CHECK(finding.excerpt.find("return y;") != std::string::npos);
}

TEST_CASE("an error that a file places in another file has no line") {
  const Compilation compilation = compile_text("#line 7 \"elsewhere.cpp\"\nint rigid;\n");
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK(compilation.findings.empty());
  CHECK(compilation.message.starts_with("Your file does not compile: 'int rigid' redeclared"));
}

TEST_CASE("an error behind the end of the file, as the file counts, has no excerpt") {
  const Finding finding = first_error_of("#line 500\nint rigid;\n");
  CHECK(finding.line == 500);
  CHECK(finding.excerpt.empty());
}

}  // namespace workbook::testing
