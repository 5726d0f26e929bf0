// The mistakes in students' files, by name and place; the sentences are in golden/compile_findings.txt.
#include "checker/compile/compile.hpp"
#include "tests/running/student.hpp"
#include "tests/support/golden.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/explain/explain.hpp"
#include "checker/judging/judge.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <atomic>
#include <thread>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

struct Mistaken {
  std::string expected;  ///< "undeclared_name 3:8; narrowing 4:2"
  std::string text;
};

/// The body of `double twice(double x)`, from line 3 on.
std::string body(const std::string& text) {
  return "namespace rigid {\ndouble twice(double x) {\n" + text + "\n}\n}\n";
}

/// The body of `Matrix3d scaled(const Matrix3d& A, double factor)`.
std::string scaled(const std::string& text) {
  return "namespace rigid {\nMatrix3d scaled(const Matrix3d& A, double factor) {\n" + text + "\n}\n}\n";
}

const std::vector<Mistaken> files_that_do_not_compile = {
    {"different_sizes 4:13", body("Vector3d a; Vector2d b;\nreturn (a + b)(0);")},
    {"different_sizes 4:6", body("Vector3d a; Matrix3d b;\na -= b; return x;")},
    {"different_sizes 4:14", body("Matrix3d b;\nVector3d a = b; return a(0);")},
    {"different_sizes 4:30", body("Vector3d a;\nVector3d b = a * a.transpose(); return b(0);")},
    {"row_and_column 4:20", body("Vector3d a; Matrix3d I;\nreturn (a + I.row(0))(0);")},
    {"product_sizes 4:25", body("Vector3d a; Matrix3d I;\nreturn (I * a.transpose())(0);")},
    {"product_of_two_vectors 4:12", body("Vector3d a, b;\nreturn a * b;")},
    {"product_of_two_vectors 4:18", body("Vector3d a, b;\nVector3d c = a * b; return c(0);")},
    {"cross_size 4:15", body("VectorXd a(3), b(3);\nreturn a.cross(b)(0);")},
    {"dot_of_matrix 4:13", body("Vector3d a; Matrix3d I;\nreturn a.dot(I);")},
    {"component_count 3:16", body("Vector3d a(x, x);\nreturn a(0);")},
    {"component_count 3:25", body("Vector3d a = {x, x, x, x};\nreturn a(0);")},
    {"matrix_constructor 3:37", body("Matrix3d a(1, 2, 3, 4, 5, 6, 7, 8, 9);\nreturn a(0, 0);")},
    {"matrix_constructor 3:13", body("Matrix3d a(0);\nreturn a(0, 0);")},
    {"xor_for_power 3:9", body("return x^2;")},
    {"xor_for_power 4:22", body("Vector3d v;\nreturn 0.5 * v.norm()^2;")},
    {"double_star_for_power 3:10", body("return x**2;")},
    {"list_with_equals 4:5", body("Vector3d v;\nv = 1, 2, x; return v(0);")},
    {"list_with_equals 3:14", body("Vector3d v = 1, 2, x; return v(0);")},
    {"number_for_matrix 3:14", body("Matrix3d I = 0; return I(0, 0);")},
    {"number_plus_matrix 3:10", scaled("return A + 1;")},
    {"division_by_vector 4:11", body("Vector3d a, b;\nreturn (a / b)(0);")},
    {"function_of_vector 4:16", body("Vector3d a;\nreturn std::pow(a, 2);")},
    {"wrong_kind 4:10", body("Vector3d a;\nreturn 2 * a;")},
    {"wrong_kind 3:8", scaled("return factor;")},
    {"one_by_one_matrix 4:32", body("Vector3d a, b;\nreturn x * (a.transpose() * b) / (b.transpose() * b);")},
    {"std_vector_as_vector 4:11", body("std::vector<double> v(3);\nreturn (v + v)[0];")},
    {"modulo_of_double 3:10", body("return x % 2;")},
    {"arrow_for_comparison 3:8", body("if (x => 0) return 1;\nreturn x;")},
    {"matrix_brackets 4:4", scaled("Matrix3d B;\nB[0][1] = factor; return B;")},
    {"matrix_brackets 4:7", scaled("Matrix3d B;\nB[0, 1] = factor; return B;")},
    {"call_of_value 4:5", scaled("Matrix3d B;\nB(0)(1) = factor; return B;")},
    {"missing_multiplication 3:8", body("return 2x;")},
    {"missing_call 3:20", scaled("return A.transpose * A;")},
    {"missing_call 4:10", body("Vector3d v;\nreturn v.norm;")},
    {"missing_call 3:18", scaled("return Matrix3d::Zero;")},
    {"missing_call 3:8", body("return sin x;")},
    {"method_as_function 4:14", body("Vector3d a, b;\nVector3d c = cross(a, b); return c(0);")},
    {"types_in_call 3:15", body("return scaled(const Matrix3d& A, double f)(0, 0);")},
    {"dot_for_colons 3:22", body("Matrix3d A = Matrix3d.Identity(); return A(0, 0);")},
    {"changed_constant 3:9", scaled("A(0, 1) = factor;\nreturn A;")},
    {"changed_constant 3:3", scaled("A *= factor;\nreturn A;")},
    {"changed_constant 3:14", scaled("A = factor * A;\nreturn A;")},
    {"changed_constant 3:19", scaled("A.transposeInPlace();\nreturn A;")},
    {"result_type 2:10", "namespace rigid {\nVector3d twice(double x) { return {x, x, x}; }\n}\n"},
    {"missing_result_type 2:1", "namespace rigid {\ntwice(double x) { return 2 * x; }\n}\n"},
    {"parameter_types 1:30", "double rigid::twice(double& x) { return 2 * x; }\n"},
    {"compiler_error 2:24", "namespace rigid {\ndouble twice(double x) const { return x; }\n}\n"},
    {"storage_class 2:15", "namespace rigid {\nstatic double twice(double x) { return x; }\n}\n"},
    {"missing_namespace 2:3", "double twice(double x) {\n  Vector3d v;\n  return 2 * x;\n}\n"},
    {"missing_namespace 1:1", "Vector3d twice(double x) { return {x, x, x}; }\n"},
    {"undeclared_name 4:8", body("double result = 2 * x;\nreturn reslut;")},
    {"undeclared_member 4:10", body("Vector3d v;\nreturn v.squaredNrom();")},
    {"undeclared_member 4:10", body("Vector3d v;\nreturn v.length();")},
    {"member_of_number 3:10", body("return x.norm();")},
    {"undeclared_name 5:14",
     "struct S { double a; } one; struct T { double b; };\n" + body("S s{x};\nreturn s.a + y;")},
    {"undeclared_name 4:19", "#define HALF 0.5\n" + body("return HALF * x + y;")},
    {"undeclared_member 4:10", body("Vector3d v;\nreturn v.psi;")},
    {"undeclared_name 3:8", body("return flunk * x;")},
    {"missing_comma 3:13", body("Vector3d v(1 2 x); return v(0);")},
    {"brackets_for_parentheses 3:14", body("return 2 * [x + 1];")},
    {"missing_type 3:1", body("y = 2 * x; return y;")},
    {"missing_prefix 3:1", body("vector<double> v; return x;")},
    {"missing_prefix 3:1", body("RowVector3d v; return x;")},
    {"undeclared_name 3:8", body("return pi * x;")},
    {"undeclared_name 3:8", body("return PI * x;")},
    {"degrees_function 3:8", body("return sind(x);")},
    {"include_in_braces 2:1",
     "namespace rigid {\n#include <set>\ndouble twice(double x) { std::set<int> s; return x; }\n}\n"},
    {"missing_header 3:6", body("std::set<int> s; return x;")},
    {"missing_header 1:10", "#include <Eigen>\n" + body("return x;")},
    {"missing_hash 1:10", "include <cmath>\n" + body("return x;")},
    {"redeclaration 4:10", body("Vector3d v;\nVector3d v; return x;")},
    {"shadowed_parameter 3:8", body("double x = 3; return x;")},
    {"missing_semicolon 3:17", body("double y = 2 * x\nreturn y;")},
    {"missing_semicolon 3:17", body("double y = 2 * x  // twice\n\nreturn y;")},
    {"missing_semicolon 3:13", body("return 2 * x")},
    {"missing_semicolon 3:11", body("Vector3d v\nv << 1, 2, 3; return v(0);")},
    {"missing_operator 3:19", body("return 2 * (x + 1) x;")},
    {"missing_brace 3:14", body("  if (x > 0) {\n    return 2 * x;\n  return x;")},
    {"missing_brace 7:2", body("  if (x > 0) {\n    return 2 * x;\n    return x;")},
    {"surplus_brace 6:1", body("return 2 * x;\n}")},
    {"missing_parenthesis 3:18", body("return 2 * (x + 1;")},
    {"surplus_parenthesis 3:17", body("return 2 * x + 1);")},
    {"condition_parentheses 3:4", body("if x > 0 return x;\nreturn 0;")},
    {"else_without_if 3:20", body("if (x > 0); x = 1; else x = 2;\nreturn x;")},
    {"apostrophe_for_transpose 4:9", body("Vector3d a;\nreturn a' * a;")},
    {"invalid_character 3:10", body("return 2 − x;")},
    {"invalid_character 3:10", body("return 2 · x;")},
    {"list_in_brackets 3:15", body("Vector3d v = [1, 2, 3]; return v(0);")},
    {"unterminated_comment 3:15", body("return 2 * x; /* twice")},
    {"compiler_error 2:2", "// a comment\n#error \"not today\"\n"},
    {"undeclared_name 1:24", "#define HALF(a) ((a) / y)\n" + body("return HALF(x);")},
    {"different_sizes 2:5",
     "template <class T> void f(T t) {\n  t += Eigen::Vector2d(1, 2);\n}\n" + body("f(Vector3d(x, x, x)); return x;")},
    {"no_operator 4:8", body("Vector3d a;\nreturn !a;")},
    {"eigen_assertion 4:14", body("Vector3d a, b;\nreturn (a || b)(0);")},
    {"compiler_error 1:7", "class rigid { double twice(double x) { return x; } };\n"},
    {"compiler_error 3:1", body("inline double v; return x;")},
    {"own_header 1:10", "#include \"helper.hpp\"\n" + body("return x;")},
    {"missing_header 1:10", "#include \"Eigen\"\n" + body("return x;")},
    {"missing_header 1:10", "#include <rigid/nothing.hpp>\n" + body("return x;")},
    {"newer_library 1:10", "#include <mdspan>\n" + body("return x;")},
    {"newer_library 3:6", body("std::format(\"{}\", x); return x;")},
    {"undeclared_member 4:14", body("std::vector<int> v(3);\nstd::ranges::foo(v); return x;")},
    {"assignment_in_condition 4:7", body("const double p = x;\nif (p = 0) return 1;\nreturn x;")},
    {"assignment_in_condition 4:9", body("const Vector3d p(x, x, x);\nif (p = 0) return 1;\nreturn x;")},
    {"comparison_of_vectors 4:7", body("Vector3d p(x, x, x);\nif (p == 0) return 1;\nreturn x;")},
    {"comparison_of_vectors 4:7", body("Vector3d p(x, x, x), q(1,2,3);\nif (p < q) return 1;\nreturn x;")},
    {"mixed_precision 4:21", body("Vector3d omega(x, x, x);\nEigen::Vector3f w = omega;\nreturn w(0);")},
    {"mixed_precision 4:18", body("Eigen::Vector3f w(1, 2, 3);\nVector3d v = x * w; return v(0);")},
    {"row_and_column 4:25", body("Vector3d a; \nreturn (a.transpose() + a)(0);")},
    {"changed_constant 3:38", scaled("A.row(0) = Vector3d(1,2,3).transpose();\nreturn A;")},
    {"function_of_vector 3:36", body("Vector3d a(x,x,x); return std::sqrt(a);")},
    {"argument_kinds 3:34", body("Vector3d a(x,x,x); return a.cross(2)(0);")},
    {"method_as_function 3:15", scaled("return inverse(A);")},
    {"array_and_matrix 3:18", scaled("return A.array() + A;")},
    {"assignment_to_value 3:3", body("2 * x = 3; return x;")},
    {"arrow_for_dot 3:28", body("Vector3d v(1,2,3); return v->norm();")},
    {"argument_count 4:16", body("auto f = [](double a) { return a; };\nreturn std::pow(x);")},
    {"argument_count 4:9", "double h(double a, double b) { return a + b; }\n" + body("return h(x);")},
    {"argument_count 4:9", "double h(double a) { return a; }\n" + body("return h(x, 2);")},
    {"wrong_kind 4:10", "double h(const Eigen::Vector3d& a) { return a(0); }\n" + body("return h(x);")},
    {"wrong_kind 4:22", "double h(double a) { return a; }\n" + body("Vector3d v; return h(v);")},
    {"number_for_matrix 3:14", body("Vector3d v = 3; return v(0);")},
    {"wrong_kind 3:31", body("Vector3d v(1,2,3); double y = v; return y;")},
    {"std_vector_as_vector 3:40", body("std::vector<double> s(3); Vector3d v = s; return v(0);")},
    {"return_without_value 3:1", body("return;")},
    {"missing_call 4:11", body("Vector3d a;\nreturn -a.z;")},
    {"incomplete_type_name 3:1", body("Matrix m; return x;")},
    {"incomplete_type_name 3:1", body("Vector3 w(x, x, x); return x;")},
    {"normalize_in_place 3:23", scaled("return A * A.normalize();")},
    {"normalize_in_place 4:25", body("Vector3d a(x, x, x);\nVector3d n = a.normalize(); return n(0);")},
    {"cross_by_letter 4:16", body("Vector3d a, b;\nVector3d c = a x b; return c(0);")},
    {"cross_by_letter 4:16", body("Vector3d a, b;\nVector3d c = a × b; return c(0);")},
    {"redefinition 7:8", body("return x;\n}\n}\nnamespace rigid {\ndouble twice(double x) {\nreturn x;")},
    {"ambiguous_call 4:13", "namespace rigid { double twice(float x) { return x; } }\n" + body("return twice(1);")},
    {"result_by_assignment 3:7", body("twice = 2 * x;")},
    {"nested_function 3:20", body("double h(double a) { return a; }\nreturn h(x);")},
    {"column_by_colon 3:10", scaled("return A(:, 0);")},
    {"unterminated_text 3:14", body("std::cout << \"a; return x;")},
    {"std_vector_parentheses 3:35", body("std::vector<double> v(3); return v(0);")},
    {"unterminated_text 3:10", body("char c = 'a; return x;")},
    {"changed_constant 3:37", scaled("for (int i = 0; i < 3; ++i) A(i, i) = 0;\nreturn A;")},
    {"newer_library 3:6", body("std::println(\"{}\", x); return x;")},
    {"undeclared_name 3:13", body("return std::pi;")},
    {"missing_header 3:13", scaled("return A.exp();")},
    {"undeclared_member 2:12",
     "template <class T> T f(T t) {\n  return t.foo();\n}\ntemplate <class T> T g(T t) { return f(t); }\n" +
         body("return g(Eigen::Vector3d(x, x, x))(0);")},
    {"size_not_whole 3:15", body("VectorXd v(2.5); return v(0);")},
    {"vector_method_on_matrix 3:21", scaled("return A(0) * A.head(2);")},
    {"number_brackets 3:9", body("return x[0];")},
    {"branch_types 3:19", scaled("return factor > 0 ? A.transpose() : 2.0;")},
    // Places: without a last line end, with those of another system, behind tabs, letters of two bytes, a raw text.
    {"undeclared_name 1:51", "namespace rigid { double twice(double x) { return y; } }"},
    {"undeclared_name 3:10", "namespace rigid {\r\ndouble twice(double x) {\r\n  return y;\r\n}\r\n}\r\n"},
    {"undeclared_name 3:27", body("\tdouble a = 1;\treturn a + y;")},
    {"undeclared_name 3:28", body("double ω = x; return ω + q;")},
    {"undeclared_name 5:12", body("const char* s = R\"(\n  1/2\n)\"; return y;")},
    {"compiler_error 0:5", "#line 500\nint rigid;\n"},
    {"compiler_error 0:0", "#line 7 \"elsewhere.cpp\"\nint rigid;\n"},
};

const std::vector<Mistaken> files_that_compile = {
    {"integer_division 4:1", body("return\n1/2 * x;")},
    {"integer_division 3:13", body("return x * (3 / 2);")},
    {"degrees_literal 3:17", body("return x * std::sin(30);")},
    {"degrees_literal 3:12", body("return x * cos(-90.0);")},
    {"degrees_argument 3:13", body("return std::tan(x * 180 / std::numbers::pi);")},
    {"xor_for_power 4:13", body("int n = 3;\nreturn x * (n^2);")},
    {"discarded_result 4:1", body("Matrix3d A = x * Matrix3d::Identity();\nA.transpose(); return A(0, 1);")},
    {"empty_body 3:1", body("for (int i = 0; i < 3; ++i);\nx += 1; return x;")},
    {"uninitialized_variable 3:1",
     body("Matrix3d I;\nfor (int i = 0; i < 3; ++i) I += x * Matrix3d::Identity();\nreturn I.trace();")},
    {"rounded_pi 3:8", body("return 3.1416 * x;")},
    {"float_precision 3:1", body("float y = 2;\nreturn y * x;")},
    {"missing_return 4:1", body("x *= 2;")},
    {"uninitialized_variable 4:31", body("double s;\nfor (int i = 0; i < 2; ++i) s += x;\nreturn s;")},
    {"narrowing 3:13", body("int y = 0.5 * x;\nreturn y;")},
    {"assignment_in_condition 3:7", body("if (x = 2) return 1;\nreturn 2 * x;")},
    {"chained_comparison 3:7", body("if (0 < x < 2) return 1;\nreturn 2 * x;")},
    {"comma_in_number 3:8", body("return 0,5 * x;")},
    {"unused_value 3:3", body("x == 2;\nreturn x;")},
    {"unsigned_comparison 3:24", body("for (unsigned i = 3; i >= 0; --i) x += i;\nreturn x;")},
    {"shadowed_variable 4:10", body("double y = 2;\n{ double y = 3; y += x; }\nreturn y;")},
    {"fall_through 4:11", body("switch (int(x)) {\ncase 1: x = 2;\ncase 2: x = 3;\n}\nreturn x;")},
    {"never_used 3:8", body("double y = 2 * x;\nreturn 2;")},
    {"never_used 2:21", body("return 2;")},
    {"reference_to_local 3:10",
     "const Eigen::Vector3d& f(double x) {\n  Eigen::Vector3d a(x, x, x);\n  return a;\n}\n" + body("return f(x)(0);")},
    {"misleading_indentation 3:3", body("  for (int i = 0; i < 3; ++i)\n    x += i;\n    x *= 2;\n  return x;")},
    {"kept_expression 4:1", body("Vector3d a(x, x, x);\nauto b = a + a; return b(0);")},
    {"kept_expression 3:26", body("Vector3d a(x,x,x); const auto& r = a + a; return r(0);")},
    {"kept_expression 3:1", body("auto doubled = [&](const Vector3d& v) { const Vector3d w = 2 * v; return w + v; "
                                 "};\nreturn doubled({x, x, x})(0);")},
    {"", body("const auto doubled = [](double y) { return 2 * y; };\nconst auto twice = [](const Vector3d& v) -> "
              "Vector3d { return v + v; };\nreturn doubled(twice({x, x, x})(0));")},
    {"kept_expression 1:1",
     "auto helper(const Eigen::Vector3d& a) { return 2 * a; }\n" + body("return helper(Vector3d(x,x,x))(0);")},
    {"kept_expression 7:1", "#include <set>\n#include <ranges>\n#include <random>\n" +
                                body("Vector3d a(x,x,x);\nauto v = a.transpose() * 2; return v(0);")},
    {"kept_expression 5:1",
     body("Vector3d a(x,x,x);\nauto f = [](auto v) { return v; }; auto y = f(a); for (auto z : {1.0, 2.0}) x += z; "
          "auto [p, q] = std::pair(1, 2);\nauto w = y - a; return w(0) + p + q;")},
    {"integer_division_by_zero 3:14", body("return x + 1 / 0;")},
    {"never_used 2:21; integer_division 3:22; float_precision 3:27; uninitialized_variable 3:49",
     body("double a; double b = 1/2; float c = 3; return a + b + c;")},
    // Right code that looks like a mistake.
    {"", "// 1/2, sin(30), x ^ 2 and 3.14 in a comment\n/* 1/2\n 1/2 */\n#include <cmath>\n#define HALF 1/2\n" +
             body(R"code(const char* text = "1/2 sin(30) 3.14 float"; char letter = '/';
const char* raw = R"(1/2 sin(30))"; (void)text; (void)letter; (void)raw;
double a = 4/2 + 1.0/2 + 1/2.0 + x*1/2 + x/1/2 + (double)1/2 + 1./2 + 1e0/2 + 0x10/3.0;
double b = std::sin(0.5) + std::cos(30 * std::numbers::pi / 180) + std::sin(2) + std::cos(0);
int mask = 3; mask = mask ^ mask; int n = static_cast<int>(x); int k = std::lround(x);
if (x > 0) n = 1 + static_cast<int>(x / 0.01);
Matrix3d I = Matrix3d::Zero(); I += Matrix3d::Identity(); I.transposeInPlace(); I.setZero();
Matrix3d J; J.setZero(); J += I; Matrix3d K; K << 1, 2, 3, 4, 5, 6, 7, 8, 9; K += J;
double s = 0; for (int i = 0; i < 3; ++i) s += i; while (s > 100) s /= 2;
std::vector<int> v(3); std::size_t m = v.size() - 1; s += v[m/2] + v[1/2];
double pi = 3.14159265358979323846; do { s -= 1; } while (s > 1e6);
return a + b + mask + n + k + K(0, 0) + s + pi;)code")},
    // auto that holds a value.
    {"", "#include <random>\n#include <ranges>\n" +
             body("Vector3d a(x, 1, 2), b(x, x, x); static auto zero = Vector3d(0, 0, 0);\n"
                  "auto n = a.norm(); auto c = a.cross(b); auto d = a.dot(b); auto u = a.normalized();\n"
                  "auto I = Matrix3d::Identity(); auto two = 2 * Matrix3d::Identity(); auto e = (a + b).eval();\n"
                  "auto t = a.transpose(); auto first = a.head(2); auto f = [&](double y) { return y * n; };\n"
                  "auto g = [](const Vector3d& v) -> Vector3d { return 2 * v; }; auto i = 3; auto s = x;\n"
                  "for (auto y : std::vector<double>{x}) s += y; const auto& r = a; auto [p, q] = std::pair(1, 2);\n"
                  "auto h = [](auto y) { return y; }; decltype(auto) w = (a); auto* at = &a; s += h(zero(0)) + w(0) + "
                  "at->x();\n"
                  "return c(0) + d + u(0) + I(0, 0) + two(0, 0) + e(0) + t(0) + first(0) + f(1) + g(a)(0) + i + s + "
                  "r(0) + p + q;")},
    // A sum that another statement may have given a value; a method of one's own type may do anything.
    {"", body("Matrix3d I;\nif (x > 0) I += Matrix3d::Identity(); else I = Matrix3d::Zero();\nreturn I.trace();")},
    {"", body("auto fill = [](Matrix3d& A) { A.setZero(); };\nMatrix3d I;\nfill(I); I += Matrix3d::Identity(); return "
              "x * I.trace();")},
    {"static_variable 3:1", body("static Matrix3d I;\nI += Matrix3d::Identity(); return x * I(0, 0);")},
    {"overwritten 4:1", body("double a = x, b = 2;\na = b;\nb = a; return a * b;")},
    {"", "struct Frame { void transpose() {} };\n" + body("Frame f;\nf.transpose(); return x;")},
};

struct Result {
  bool compiles = false;
  std::vector<Reason> findings;
};

Result findings_in(const std::string& text) {
  const std::string exercise =
      text.find("scaled(const Matrix3d& A, double factor) {") == std::string::npos ? "twice" : "scaled";
  const Submission submission = submit(text, exercise);
  const CompileTask task{submission, exercise, signature(exercise)};
  const Compilation compilation = compile(task, toolchain(), shared_cache());
  const bool compiles = compilation.executable.has_value();
  return {compiles, compiles ? source_findings(task, compilation, toolchain(), shared_cache()) : compilation.errors};
}

void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < count; k = next++) work(k);
    });
}

std::vector<Result> findings_in(const std::vector<Mistaken>& files) {
  std::vector<Result> results(files.size());
  on_all_processors(files.size(), [&](std::size_t k) { results[k] = findings_in(files[k].text); });
  return results;
}

std::string names_of(const std::vector<Reason>& findings) {
  std::string names;
  for (const Reason& one : findings)
    names += fmt::format("{}{} {}:{}", names.empty() ? "" : "; ", one.name, one.line, one.column);
  return names;
}

/// A file of beginners.txt.
struct Beginner {
  std::string title;
  std::vector<std::string> words;  ///< of which a sentence holds one
  std::string exercise;
  std::string text;
};

std::vector<Beginner> beginners() {
  std::vector<Beginner> all;
  std::string text = read_file(fs::path(WORKBOOK_TEST_SOURCES) / "beginners.txt").value_or("");
  for (const std::string& line : lines_of(text.substr(text.find("\n### ") + 1))) {
    if (const Match head = search(line, R"(^### (.*) \| (.*)$)")) {
      all.push_back({head[1], {}, "", ""});
      std::string words = head[2];
      for (std::size_t end; (end = words.find(" / ")) != std::string::npos; words.erase(0, end + 3))
        all.back().words.push_back(words.substr(0, end));
      all.back().words.push_back(words);
    } else if (all.back().exercise.empty()) {
      all.back().exercise = line;
    } else {
      all.back().text += line + "\n";
    }
  }
  for (Beginner& each : all) {
    if (each.exercise == "twice") each.text = body(each.text);
    if (each.exercise == "scaled") each.text = scaled(each.text);
    each.exercise = each.text.find("scaled(const Matrix3d& A") != std::string::npos &&
                            each.text.find("double twice(") == std::string::npos
                        ? "scaled"
                        : "twice";
  }
  return all;
}

/// 2x and factor · A, at a few inputs.
ExerciseReference reference_of(const std::string& exercise) {
  ExerciseReference reference;
  reference.name = exercise;
  reference.signature = signature(exercise);
  const bool is_number = exercise == "twice";
  if (!is_number) reference.arguments.push_back({"A", Kind::matrix3, {}});
  reference.arguments.push_back({is_number ? "x" : "factor", Kind::number, {}});
  reference.result_kind = is_number ? Kind::number : Kind::matrix3;
  reference.result_units = {units::none};
  for (const double x : {1.0, 2.0, -0.5, 7.25, 0.0, -3.0}) {
    Case one = twice_case(x);
    one.name = "made up";
    one.tolerance = 1e-12;
    if (!is_number) {
      one.inputs = {Value{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 10}}, Value{1, 1, {x}}};
      one.expected = one.inputs.front();
      for (double& number : one.expected.numbers) number *= x;
    }
    one.scale.assign(one.expected.numbers.size(), 1.0);
    reference.cases.push_back(one);
  }
  return reference;
}

/// What a student reads of the file.
struct Told {
  Verdict verdict = Verdict::passed;
  std::string sentences;
  std::vector<Reason> physics;
};

Told told(const Beginner& beginner) {
  const Submission submission = submit(beginner.text, beginner.exercise);
  const ExerciseReference reference = reference_of(beginner.exercise);
  const CompileTask task{submission, beginner.exercise, reference.signature};
  const Compilation compilation = compile(task, toolchain(), shared_cache());
  std::optional<ExerciseRunner> runner;
  if (compilation.executable) runner.emplace(compilation.program(), short_limits());
  const Observation observation =
      runner ? runner->observe(plan_calls(reference.cases), plan_repeats(reference)) : refused(compilation);
  const Judgement judgement = judge(reference, observation);
  std::vector<Reason> reasons = observation.errors;
  const Ask ask = [&](const std::vector<PlannedCall>& calls) { return runner->evaluate(calls); };
  if (runner && !judgement.passed())
    reasons =
        explain({{submission, reference, observation, judgement}, task, compilation, ask, toolchain(), shared_cache()});
  Told told{judgement.verdict, "", {}};
  for (const Reason& reason : reasons)
    if (reason.is_in_code())
      told.sentences += fmt::format("{} {}:{} {}\n", reason.name, reason.line, reason.column, reason.sentence);
    else
      told.physics.push_back(reason);
  if (told.sentences.empty()) told.sentences = judgement.message + "\n";
  return told;
}

}  // namespace

TEST_CASE("mistakes have a name, a place and a sentence" * doctest::test_suite("thorough")) {
  std::string sentences;
  for (const auto* files : {&files_that_do_not_compile, &files_that_compile}) {
    const std::vector<Result> results = findings_in(*files);
    for (std::size_t i = 0; i < files->size(); ++i) {
      CAPTURE((*files)[i].text);
      CHECK(results[i].compiles == (files == &files_that_compile));
      CHECK(names_of(results[i].findings) == (*files)[i].expected);
      for (const Reason& finding : results[i].findings) {
        CHECK(finding.sentence.size() <= 200);
        CHECK((finding.excerpt.empty() || finding.excerpt.ends_with("^")));
        const std::string sentence = finding.name + ": " + finding.sentence + "\n";
        if (sentences.find(sentence) == std::string::npos) sentences += sentence;
      }
    }
  }
  compare_with_golden(golden("compile_findings.txt"), sentences);
}

TEST_CASE("what clang says has the names that GCC's messages have") {
  struct Said {
    std::string message;  // at line 1, column 20
    std::string name;
    std::string code = "                   x";
  };
  const Said all[] = {
      {"error: use of undeclared identifier 'cso'", "undeclared_name"},
      {"error: use of undeclared identifier 'pi'", "undeclared_name"},
      {"error: use of undeclared identifier 'omeg'; did you mean 'omega'?", "undeclared_name"},
      {"error: unknown type name 'Vektor3d'; did you mean 'Vector3d'?", "undeclared_name"},
      {"error: no member named 'transposed' in 'Eigen::Matrix<double, 3, 3>'", "undeclared_member"},
      {"error: no member named 'sine' in namespace 'std'", "undeclared_member"},
      {"error: reference to non-static member function must be called; did you mean to call it with no arguments?",
       "missing_call", "double z =      a.z;"},
      {"error: expected ';' after expression", "missing_semicolon", "Matrix3d R = A + B "},
      {"error: expected '}'", "missing_brace", "}"},
      {"error: extraneous closing brace ('}')", "surplus_brace"},
      {"error: expected ')'", "missing_parenthesis", "double z = 2*(a + 1;"},
      {"error: expected '}'", "missing_comma", "return {a+b+a+b+a+b; b};"},
      {"error: invalid operands to binary expression ('RealScalar' (aka 'double') and 'Eigen::Matrix<double, 3, 3>')",
       "number_plus_matrix", "Matrix3d R = a*a*a - B;"},
      {"error: no viable overloaded '+='", "compiler_error"},
      {"error: called object type 'double' is not a function or function pointer", "call_of_value"},
      {"error: no matching function for call to 'square'", "argument_kinds"},
      {"error: no matching constructor for initialization of 'Eigen::AngleAxisd' (aka 'AngleAxis<double>')",
       "axis_and_angle"},
      {"error: no viable constructor or deduction guide for deduction of template arguments of 'Matrix'",
       "incomplete_type_name", "          Matrix A(a);"},
      {"error: cannot initialize return object of type 'int' with an lvalue of type 'const char[7]'",
       "text_for_number"},
      {"error: assigning to 'double' from incompatible type 'const std::complex<double>'", "complex_number"},
      {"error: non-const lvalue reference to type 'Vector3d' (aka 'Matrix<double, 3, 1>') cannot bind to a temporary "
       "of "
       "type 'double'",
       "reference_to_temporary"},
      {"error: 'rigid/nothing.hpp' file not found", "missing_header"},
      {"error: expected expression", "else_without_if", "                   else"},
      {"error: no viable conversion from returned value of type 'double' to function return type "
       "'rigid::Matrix3d' (aka 'Matrix<double, 3, 3>')",
       "wrong_kind", "            return x;"},
      {"warning: non-void function does not return a value in all control paths [-Wreturn-type]", "missing_return"},
      {"warning: variable 's' is uninitialized when used here [-Wuninitialized]", "uninitialized_variable"},
      {"warning: implicit conversion turns floating-point number into integer: 'double' to 'int' [-Wfloat-conversion]",
       "narrowing"},
      {"warning: using the result of an assignment as a condition without parentheses [-Wparentheses]",
       "assignment_in_condition"},
      {"warning: left operand of comma operator has no effect [-Wunused-value]", "unused_value"},
      {"warning: unused variable 's' [-Wunused-variable]", "never_used"}};
  for (const Said& one : all) {
    CAPTURE(one.message);
    const CompilerOutput output = read_compiler_output(unit_name + ":1:20: " + one.message + "\n", "a.cpp",
                                                       [](const std::string&) { return false; });
    REQUIRE(output.diagnostics.size() == 1);
    const std::string text = one.code + "\n";
    const SourceText source(text);
    const std::optional<Reason> error = first_error(output.diagnostics, source, "");
    const std::vector<Reason> warned = warned_mistakes(output.diagnostics, source);
    CHECK((error ? error->name : warned.empty() ? std::string() : warned[0].name) == one.name);
  }
}

TEST_CASE("each of the beginners' mistakes is told in a tutor's words, and none as physics" *
          doctest::test_suite("thorough")) {
  const std::vector<Beginner> files = beginners();
  CHECK(files.size() >= 200);
  std::vector<Told> all(files.size());
  on_all_processors(files.size(), [&](std::size_t k) { all[k] = told(files[k]); });
  std::string names;
  for (std::size_t k = 0; k < files.size(); ++k) {
    CAPTURE(files[k].title);
    CAPTURE(files[k].text);
    CAPTURE(to_string(all[k].verdict));
    CAPTURE(all[k].sentences);
    CHECK(all[k].verdict != Verdict::passed);
    CHECK(std::ranges::any_of(
        files[k].words, [&](const std::string& words) { return all[k].sentences.find(words) != std::string::npos; }));
    for (const Reason& diagnosis : all[k].physics) CHECK(diagnosis.sentence == "");
    names += all[k].sentences;
  }
  CHECK(nothing_left_running());

  // Every mistake of the tables is in a file, or made by another compiler.
  for (const auto* list : {&files_that_do_not_compile, &files_that_compile})
    for (const Mistaken& file : *list) names += boost::replace_all_copy(file.expected, "; ", "\n") + "\n";
  for (const auto* table : {&error_table, &warning_table})
    for (const MessageMistake& mistake : *table) {
      INFO(std::string(mistake.name));
      CHECK((*mistake.name == '\0' || ("\n" + names).find(fmt::format("\n{} ", mistake.name)) != std::string::npos));
    }
}

/// What the text of a function shows, each name with a space behind.
static std::string names(const std::string& text) {
  std::string all;
  for (const auto& found : text_mistakes(SourceText(body(text)))) all += found.name + " ";
  return all;
}

TEST_CASE("a list that goes on behind its ; is told, not a declaration or a call in the next line") {
  CHECK(names("Vector3d v;\nv << x, x;\n     std::swap(v[0], v[1]);\nreturn v[0];").empty());
  CHECK(names("Matrix2d A;\nA << 1, x;\n  x, std::cos(x);\nreturn A(0, 0);") == "semicolon_in_list ");
  CHECK(names("Matrix2d A;\nA << 1, x, x, 1;\nconst Vector2d b(x, 1);\nreturn A.inverse().row(0).dot(b);").empty());
  CHECK(names("Matrix2d A;\nA << 1, x, x, 1;\nEigen::Vector2d b(x, 1), c(1, x);\nreturn b.dot(A * c);").empty());
}

TEST_CASE("what a variable is given and nobody reads is told, not what a loop, a lambda or another name of it reads") {
  CHECK(names("Vector3d v(1, 2, x);\nv = 2 * v;\nreturn x;") == "never_read ");
  CHECK(names("double y = x;\ny = 2 * y;\nreturn y;").empty());
  CHECK(names("double old = 0;\nwhile (x > old) {\nold = x;\nx /= 2;\n}\nreturn x;").empty());
  CHECK(names("double y = x;\nconst auto f = [&] { return y; };\ny = 3;\nreturn f();").empty());
  CHECK(names("double y = x;\ndouble& same = y;\ny = 3;\nreturn same;").empty());
  CHECK(names("Vector3d v(1, 2, x);\nv(0) = 2;\nreturn v(0);").empty());
}

TEST_CASE("a loop whose condition nothing changes is told, not one that hands its variable to a function") {
  CHECK(names("double y = 1;\ndo {\ny += 1;\n} while (x < 3);\nreturn y;") == "endless_loop ");
  CHECK(names("while (true) {\nx += 1;\n}\nreturn x;") == "endless_loop ");
  CHECK(names("do {\nx += 1;\n} while (x < 3);\nreturn x;").empty());
  CHECK(names("while (x < 3) {\nadvance(x);\n}\nreturn x;").empty());
  CHECK(names("while (true) {\nx += 1;\nif (x > 3) break;\n}\nreturn x;").empty());
  CHECK(names("while (next()) {\nx += 1;\n}\nreturn x;").empty());
}

TEST_CASE("a result that is dropped is told, not a call that changes its argument") {
  CHECK(names("std::sqrt(x);\nreturn x;") == "discarded_result ");
  CHECK(names("Matrix3d A, B;\nA * B;\nreturn x;") == "discarded_result ");
  CHECK(names("Matrix3d* p;\nx -= 1;\nx++;\ny = A * B;\nreturn x;").empty());
  CHECK(names("return x;\n}\ndouble wrap(double y) {\nif (y > 3) wrap(y - 3);\nreturn y;") == "discarded_result ");
  CHECK(names("using Rows = Matrix3d;\nRows* p;\nreturn x;").empty());
  CHECK(
      names("return x;\n}\ndouble half(double y) {\nreturn y / 2;\n}\ndouble other(double x) {\nhalf(x);\nreturn x;") ==
      "discarded_result ");
  CHECK(names("return x;\n}\ndouble next(double& y) {\ny += 1;\nreturn y;\n}\ndouble other(double x) "
              "{\nnext(x);\nreturn x;")
            .empty());
}

TEST_CASE("sums of vectors, loops that count in their condition and lists before a declaration are not blamed") {
  CHECK(names("return std::accumulate(v.begin(), v.end(), 0);") == "whole_sum ");
  CHECK(names("const Vector3d s = std::accumulate(v.begin(), v.end(), Vector3d(0, 0, 0));\nreturn s(0);").empty());
  CHECK(names("const Matrix3d A = x * A;\nreturn A(0, 0);") == "uninitialized_variable ");
  CHECK(names("const double a = x, b = 2 * a;\nreturn b;").empty());
  CHECK(names("while (n > 0) {\nx = 2 * x;\n}\nreturn x;") == "endless_loop ");
  CHECK(names("while (n--) {\nx = 2 * x;\n}\nreturn x;").empty());
  CHECK(names("do {\nx = 2 * x;\n} while (--n > 0);\nreturn x;").empty());
  CHECK(names("Matrix3d A;\nA << x, 0, 0,\n0, 1, 0;\n0, 0, 1;\nreturn A(0, 0);") == "semicolon_in_list ");
  CHECK(names("Vector2d a;\na << x, 2 * x;\nEigen::Matrix<double, 3, 6> J;\nreturn a(0);").empty());
}

TEST_CASE("sizes and ends of loops are told, not those that are given or hold") {
  CHECK(names("VectorXd v;\nv(0) = x;\nreturn v(0);") == "no_size ");
  CHECK(names("VectorXd v;\nv.resize(3);\nv(0) = x;\nreturn v(0);").empty());
  CHECK(names("const std::string after = \"for (int i = 0; i < v.size(); ++i) v(i + 1)\";\nreturn x;").empty());
  const std::string loop = "VectorXd v(3);\ndouble s = 0;\nfor (int i = 0; {}; ++i) {{\ns += {};\n}}\nreturn s;";
  CHECK(names(fmt::format(fmt::runtime(loop), "i < v.size()", "v(i + 1) - v(i)")) == "one_too_far ");
  CHECK(names(fmt::format(fmt::runtime(loop), "i + 1 < v.size()", "v(i + 1) - v(i)")).empty());
  CHECK(names(fmt::format(fmt::runtime(loop), "i < v.size()", "v((i + 1) % 3)")).empty());
  CHECK(names(fmt::format(fmt::runtime(loop), "i < v.size()", "0;\nif (i + 1 < v.size()) s += v(i + 1)")).empty());
  CHECK(names("for (int k = 0; k < A.cols(); k += 3) {\nx += A.col(k + 1).norm();\n}\nreturn x;").empty());
  CHECK(names("for (int i = 0; i < 2; ++i) {\ny = i * x;\nz = i + x;\n}\nreturn y + z;") == "last_turn_only ");
  CHECK(names("for (int i = 0; i < 2; ++i) {\ny = i * x;\nz += y;\n}\nreturn z;").empty());
  CHECK(names("Eigen::EigenSolver<Matrix3d> s(A);\nreturn x;") == "unsorted ");
  CHECK(names("Eigen::SelfAdjointEigenSolver<Matrix3d> s(A);\nreturn x;").empty());
  CHECK(names("return (1 - x) / 1 + x;") == "divisor ");
  CHECK(names("return (1 - x) / 1.5 + x;").empty());
}

TEST_CASE("a lambda that changes copies is told, not one that keeps a counter or changes what is outside") {
  CHECK(names("double s = 0;\nauto add = [s](double y) mutable { s += y; };\nadd(x);\nreturn s;") == "captured_copy ");
  CHECK(names("return x;\n}\nvoid turn(Vector3d v, double y) {\nv(0) = y * v(0);\n}\ndouble other(double x) {\nreturn "
              "x;") == "changed_copy ");
  const std::string turn = "return x;\n}}\nvoid turn({}) {{\n{}\n}}\ndouble other(double y) {{\nreturn y;";
  CHECK(names(fmt::format(fmt::runtime(turn), "Vector3d v", "v.head<2>() *= 2;")) == "changed_copy ");
  CHECK(names(fmt::format(fmt::runtime(turn), "Vector3d& v", "v.head<2>() *= 2;")).empty());
  CHECK(names(fmt::format(fmt::runtime(turn), "Vector3d& v, int i", "v[(i + 1) % 3] *= 2;")).empty());
  CHECK(names(fmt::format(fmt::runtime(turn), "Vector3d v, Vector3d& w", "v(0) = 2;\nw = v;")).empty());
  CHECK(names("auto next = [n = 0.0]() mutable { return ++n; };\nreturn next() * x;").empty());
  CHECK(names("double s = 0;\nauto add = [&s](double y) mutable { s += y; };\nadd(x);\nreturn s;").empty());
}

TEST_CASE("a lambda that keeps an old value is told, not one that is called before the change or sees it") {
  CHECK(names("double a = x;\nauto f = [a]() { return 2 * a; };\na = 3;\nreturn f();") == "captured_value ");
  CHECK(names("double a = x;\nauto f = [=]() { return 2 * a; };\na += 3;\nreturn f();") == "captured_value ");
  CHECK(names("double a = x;\nauto f = [=](double a) { return 2 * a; };\na = 3;\nreturn f(a);").empty());
  CHECK(names("double a = x;\nauto f = [=]() { double a = 2; return a; };\na = 3;\nreturn a + f();").empty());
  CHECK(names("double a = x;\nauto f = [&a]() { return 2 * a; };\na = 3;\nreturn f();").empty());
  CHECK(names("double a = x;\nauto f = [a]() { return 2 * a; };\nx = f();\na = 3;\nreturn a + x;").empty());
}

TEST_CASE("signs that C++ reads otherwise are told, not those that are meant so") {
  CHECK(names("x =- 2 * x;\nreturn x;") == "unary_minus ");
  CHECK(names("x = -2 * x;\nx =-2;\nreturn x;").empty());
  CHECK(names("x =+ 2 * x;\nreturn x;") == "unary_plus ");
  CHECK(names("x = +2 * x;\nreturn x;").empty());
  CHECK(names("v[i] = w[i++];\nreturn v[0];") == "changed_in_statement ");
  CHECK(names("v[i] = w[i];\ni++;\nreturn v[0];").empty());
  CHECK(names("for (unsigned k = 0; k < 2; ++k) x += (1 - 2 * k) * x;\nreturn x;") == "unsigned_difference ");
  CHECK(names("for (unsigned k = 0; k < 2; ++k) x += w[1 - k];\nreturn x;").empty());
  CHECK(names("return v[i + 1 % 3];") == "modulo_first ");
  CHECK(names("return v[(i + 1) % 3];").empty());
  CHECK(names("return v[(i - 1) % 3];") == "negative_remainder ");
  CHECK(names("return v[(i - 1 + 3) % 3];").empty());
  CHECK(names("return x\n+ x;\n+ x;") == "semicolon_in_sum ");
  CHECK(names("return '2' * x;") == "character ");
  CHECK(names("std::cout << '2';\nreturn x;") == "character ");
}

TEST_CASE("what is not what it seems to be is told, not what is") {
  CHECK(names("Matrix3d A = Matrix3d::Ones();\nreturn A(0, 0) * x;") == "ones ");
  CHECK(names("while (std::abs(a - b) > 1e-18) x = next(x);\nreturn x;") == "bound_below_rounding ");
  CHECK(names("while (std::abs(a - b) > 1e-12) x = next(x);\nreturn x;").empty());
  CHECK(names("static const double y = 2 * x;\nreturn y;") == "static_variable ");
  CHECK(names("static const double y = std::sqrt(2.0);\nreturn y * x;").empty());
  CHECK(names("Vector3d v(3);\nv += Vector3d(x, 0, 0);\nreturn v[0];") == "matrix_constructor uninitialized_variable ");
  CHECK(names("Vector3d v(1, 2, 3);\nv += Vector3d(x, 0, 0);\nreturn v[0];").empty());
  CHECK(names("Vector3d v(3);\nv << x, 0, 0;\nreturn v[0];") == "matrix_constructor ");
  CHECK(names("const auto v = rates(x).transpose();\nreturn v(0);") == "kept_expression ");
  CHECK(names("A.lu().solve(b);\nreturn b[0];") == "discarded_result ");
  const auto of_macro = [](const char* text, const char* used) {
    std::string all;
    const std::string file = fmt::format("#define SQUARE(y) {}\n{}", text, body(fmt::format("return {};", used)));
    for (const Reason& found : text_mistakes(SourceText(file))) all += found.name + " ";
    return all;
  };
  CHECK(of_macro("y * y", "1 / SQUARE(x)") == "macro ");
  CHECK(of_macro("y * y", "SQUARE(x + 1)") == "macro ");
  CHECK(of_macro("y * y", "2 + SQUARE(x)").empty());
  CHECK(of_macro("((y) * (y))", "1 / SQUARE(x + 1)").empty());
}

TEST_CASE("an index behind an array is told in the array's block, and not of another variable of that name") {
  CHECK(names("double w[3] = {x, x, x};\nfor (int i = 0; i < 3; ++i) {\n  w[i] += x;\n}\nreturn w[3];") ==
        "index_out_of_range ");
  CHECK(names("{\n  double w[2] = {x, x};\n  x += w[1];\n}\nVector3d w(x, x, x);\nreturn w[2];").empty());
  CHECK(names("double w[2] = {x, x};\nconst auto last = [](const Vector3d& w) { return w[2]; };\n"
              "return last(Vector3d(w[0], w[1], x));")
            .empty());
}

TEST_CASE("a return that ends a loop in its first turn is told, not one behind a condition; so is a wrong counter") {
  CHECK(names("for (int i = 0; i < 2; ++i) {\nx += 1;\nreturn x;\n}\nreturn x;") == "return_in_loop ");
  CHECK(names("for (int i = 0; i < 2; ++i) {\nif (x > 1) return x;\nx += 1;\n}\nreturn x;").empty());
  CHECK(names("for (int i = 0; i < 2; ++i) {\nif (x > 1) {\nx -= 1;\n}\nreturn x;\n}\nreturn x;") == "return_in_loop ");
  CHECK(names("for (int i = 0; i < 2; ++i) {\nif (x > 1) continue;\nreturn x;\n}\nreturn x;").empty());
  CHECK(names("for (int i = 0; i < 2; ++i) {\ndouble s = 0;\ny = x * x;\ns += y;\nv[i] = s;\n}\nreturn v[0];") ==
        "restarted_sum ");
  CHECK(names("for (int i = 0; i < 2; ++i) {\ndouble s = 0;\nfor (int k = 0; k < 2; ++k) {\ns += x;\n}\nv[i] = "
              "s;\n}\nreturn "
              "v[0];")
            .empty());
  CHECK(names("for (int i = 0; i < 2; ++i) {\ndouble s = 0;\ns += x;\ns += y;\nv[i] = s;\n}\nreturn v[0];").empty());
  CHECK(names("const Matrix3d T = A.block(0, k, 3, k + 3);\nreturn T(0, 0);") == "size_for_end ");
  CHECK(names("const Matrix3d T = A.block(0, k, 3, 3);\nreturn T(0, 0);").empty());
  CHECK(names("for (int i = 0; i < 3; i++)\nfor (int j = 0; j < 3; i++) x += 1;\nreturn x;") == "other_counter ");
  CHECK(names("for (int i = 0; i < 2; ++i) {\nif (x > 1) {\nreturn x;\n}\nx += 1;\n}\nreturn x;").empty());
}

// Students' copies of the workbook have no solutions.
TEST_CASE("no solution of the course has a mistake in its text" * doctest::skip(!fs::exists(WORKBOOK_TEST_SOLUTIONS))) {
  std::size_t solutions = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(WORKBOOK_TEST_SOLUTIONS)) {
    const std::string name = entry.path().filename().string();
    const std::string text = entry.path().extension() == ".cpp" ? read_file(entry.path()).value_or("") : "";
    if (name == "main.cpp" || text.find("namespace rigid {") == std::string::npos) continue;
    CAPTURE(name);
    CHECK(names_of(text_mistakes(SourceText(text))) == "");
    ++solutions;
  }
  CHECK(solutions >= 48);
}

TEST_CASE("at most four mistakes are named, in the order of the lines") {
  CHECK(names_of(findings_in(body("double a;\ndouble b = 1/2;\ndouble c = 1/3;\ndouble d = 1/4;\ndouble e = 1/5;"
                                  "\ndouble f = 1/6;\nreturn x;"))
                     .findings) ==
        "integer_division 4:12; integer_division 5:12; integer_division 6:12; integer_division 7:12");
}

TEST_CASE("a message of a template without end stays short") {
  const std::vector<Reason> found =
      findings_in(
          "template <int n, class T> struct Deep { using type = typename Deep<n - 1, std::vector<T>>::type; };\n"
          "template <class T> struct Deep<0, T> { using type = typename T::missing; };\n" +
          body("Deep<8, double>::type d; return x;"))
          .findings;
  REQUIRE(found.size() == 1);
  CHECK(found[0].line > 0);
  CHECK(found[0].sentence.size() <= 400);
}

TEST_CASE("a line that is too long, or holds control characters, is shown in part and safely") {
  for (const std::string& text :
       {body("/* " + std::string(2000, 'a') + " */ return y; // " + std::string(8000, 'b')),
        body("double z = 0" + std::string(20000, ' ') + "+ y; return z;"), body("/* \x1b[31m */ return y;")}) {
    const std::vector<Reason> found = findings_in(text).findings;
    REQUIRE(found.size() == 1);
    CHECK(found[0].line == 3);
    CHECK(found[0].excerpt.size() < 250);
    CHECK(found[0].excerpt.find('\x1b') == std::string::npos);
  }
}

TEST_CASE("where the search for mistakes itself fails, it finds nothing and says nothing") {
  const fs::path directory = fresh_directory("findings-trouble");
  const Submission submission = submit(body("Vector3d a;\nauto b = a + a; return x + b(0);"), "twice");
  const CompileTask task{submission, "twice", "double twice(double x)"};
  Toolchain broken = toolchain();
  broken.compiler = "/nowhere/c++";
  CHECK(source_findings(task, {}, broken, shared_cache()).empty());
  CHECK(source_findings(task, {}, toolchain(), write(directory / "in-the-way", "") / "cache").empty());
  CHECK(source_findings(task, {}, toolchain(), shared_cache(), {.time = std::chrono::milliseconds(1)}).empty());
  CHECK(nothing_left_running());
}

}  // namespace workbook::testing
