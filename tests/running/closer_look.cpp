// What a closer look finds in files that compile: every sentence must be true, and right files are never accused.
#include "tests/running/student.hpp"

#include "checker/compile/source_findings.hpp"
#include "checker/compile/text_mistakes.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

/// The body of `double twice(double x)` inside the namespace, from line 3 on.
std::string body(const std::string& text) {
  return "namespace rigid {\ndouble twice(double x) {\n" + text + "\n}\n}\n";
}

std::vector<Finding> look(const std::string& text, Depth depth = Depth::compiler) {
  const fs::path file = write(fresh_directory("closer-look") / "twice.cpp", text);
  return source_findings({file, "twice", "double twice(double x)"}, toolchain(), shared_cache(), depth);
}

struct SilentMistake {
  std::string about;
  std::string text;
  int line;
  std::string sentence;
};

void check(const std::vector<SilentMistake>& files, Depth depth) {
  for (const SilentMistake& file : files) {
    CAPTURE(file.about);
    CHECK_MESSAGE(compile_text(file.text).executable.has_value(), compile_text(file.text).details);
    const std::vector<Finding> found = look(file.text, depth);
    REQUIRE(found.size() == 1);
    CHECK(found[0].line == file.line);
    CHECK(found[0].sentence == file.sentence);
    CHECK(found[0].sentence.size() <= 210);
    CHECK(found[0].excerpt.find("\n") != std::string::npos);
    CHECK(found[0].excerpt.ends_with("^"));
  }
}

std::string all_of(const std::vector<Finding>& found) {
  std::string text;
  for (const Finding& finding : found) text += std::to_string(finding.line) + ": " + finding.sentence + "\n";
  return text;
}

}  // namespace

TEST_CASE("mistakes are read off the text of a file") {
  check(
      {
          {"1/2", body("return\n1/2 * x;"), 4,
           "`1/2` divides whole numbers and gives 0; write at least one of them with a decimal point, as in 1.0."},
          {"3 / 2 in parentheses", body("return x * (3 / 2);"), 3,
           "`3/2` divides whole numbers and gives 1; write at least one of them with a decimal point, as in 1.0."},
          {"degrees in sin", body("return x * std::sin(30);"), 3,
           "sin takes radians: sin(30) is not the sine of 30 degrees. Multiply degrees by std::numbers::pi / 180."},
          {"degrees in cos", body("return x * cos(-90.0);"), 3,
           "cos takes radians: cos(-90.0) is not the cosine of -90.0 degrees. Multiply degrees by std::numbers::pi / "
           "180."},
          {"radians turned into degrees", body("return std::tan(x * 180 / std::numbers::pi);"), 3,
           "tan takes radians, but 180 / pi turns its argument into degrees."},
          {"^ of whole numbers", body("int n = 3;\nreturn x * (n^2);"), 4,
           "`n ^ 2` is not a power in C++: ^ combines the bits of whole numbers. Write x * x or std::pow(x, 2)."},
          {"a transpose that nobody keeps",
           body("Matrix3d A = x * Matrix3d::Identity();\nA.transpose(); return A(0, 1);"), 4,
           "transpose() changes nothing: it returns a new value, and here nobody keeps it. Write A = ..., or use a "
           "method that works in place."},
          {"; behind for", body("for (int i = 0; i < 3; ++i);\nx += 1; return x;"), 3,
           "The ; directly behind for (...) is all that it does: what follows does not belong to it. Leave out this ;"},
          {"a sum without a start",
           body("Matrix3d I;\nfor (int i = 0; i < 3; ++i) I += x * Matrix3d::Identity();\nreturn I.trace();"), 4,
           "`I` has no value yet when something is added to it here: begin with Matrix3d I = Matrix3d::Zero();"},
          {"a rounded pi", body("return 3.1416 * x;"), 3, "3.1416 is only near π; write std::numbers::pi."},
          {"float", body("float y = 2;\nreturn y * x;"), 3, "A float keeps only about 7 digits; use double."},
      },
      Depth::text);
}

TEST_CASE("mistakes are heard from the compiler's warnings") {
  check(
      {
          {"no return at all", body("x *= 2;"), 4,
           "The function can reach its end without a return; then its result is arbitrary. Return a value on every way "
           "through it."},
          {"no return on one way", body("if (x > 0) return 2 * x;\nelse if (x < 0) return -2 * x;"), 5,
           "The function can reach its end without a return; then its result is arbitrary. Return a value on every way "
           "through it."},
          {"a sum without a start", body("double s;\nfor (int i = 0; i < 2; ++i) s += x;\nreturn s;"), 4,
           "`s` is used here before it, or this part of it, was given a value."},
          {"int for double", body("int y = 0.5 * x;\nreturn y;"), 3,
           "A double is turned into a whole number (int) here: what stands behind the decimal point is lost."},
          {"= for ==", body("if (x = 2) return 1;\nreturn 2 * x;"), 3,
           "The = in this condition assigns a new value; to compare, write ==."},
          {"a < b < c", body("if (0 < x < 2) return 1;\nreturn 2 * x;"), 3,
           "a < b < c does not compare three numbers in C++ (a < b becomes 0 or 1 first); write a < b && b < c."},
          {"a decimal comma", body("return 0,5 * x;"), 3,
           "A comma is not a decimal point: what stands before it is thrown away. Write 0.5, not 0,5."},
          {"== for =", body("x == 2;\nreturn x;"), 3, "This statement has no effect: what it computes is not kept."},
          {"an unsigned count downwards", body("for (unsigned i = 3; i >= 0; --i) x += i;\nreturn x;"), 3,
           "This compares an unsigned number with 0, which it is never below, so that the result is always the same; "
           "count with int."},
          {"a second variable of the same name", body("double y = 2;\n{ double y = 3; y += x; }\nreturn y;"), 4,
           "This is a second, new `y`: the one outside of these braces stays as it was. To change that one, leave out "
           "the type."},
          {"a case without break", body("switch (int(x)) {\ncase 1: x = 2;\ncase 2: x = 3;\n}\nreturn x;"), 4,
           "Behind this statement the switch runs on into the next case; write break; if it should not."},
          {"a result that is never used", body("double y = 2 * x;\nreturn 2;"), 3,
           "`y` is declared, but its value is never used."},
          {"an argument that is never used", body("return 2;"), 2, "The argument `x` is never used."},
          {"a reference to what is gone",
           "const Eigen::Vector3d& f(double x) {\n  Eigen::Vector3d a(x, x, x);\n  return a;\n}\n" +
               body("return f(x)(0);"),
           3, "This returns a reference to `a`, which is gone when the function ends; return the value itself."},
          {"statements that only look as if they belonged to the loop",
           body("  for (int i = 0; i < 3; ++i)\n    x += i;\n    x *= 2;\n  return x;"), 3,
           "Only the first statement behind this for belongs to it, although more are indented; put them into braces."},
      },
      Depth::compiler);
}

TEST_CASE("auto that keeps an expression is found, with its name and place") {
  const std::string kept =
      " holds no result but a formula that Eigen computes at every use, from operands that may have changed or gone by "
      "then: write its type in place of auto.";
  check(
      {
          {"a sum", body("Vector3d a(x, x, x);\nauto b = a + a; return b(0);"), 4, "With auto, `b`" + kept},
      },
      Depth::compiler);
  const std::vector<Finding> found =
      look(body("Vector3d a(x, x, x);\n\t/* ω */ auto p = a(0); const auto q = a * 2; return p + q(0);\n}\n"
                "auto helper(const Vector3d& a) { return 2 * a; }\n"
                "double g() {\nauto T = Vector3d(1, 2, 3).transpose() * Vector3d(1, 2, 3);\nreturn T;"));
  CHECK(all_of(found) == "4: With auto, `q`" + kept +
                             "\n6: With auto, `helper` returns no result but a formula over its operands, which may be "
                             "gone when it is computed: write the type in place of auto.\n8: With auto, `T`" +
                             kept + "\n");
}

TEST_CASE("auto that holds a value is not accused") {
  CHECK(all_of(look(
            body("Vector3d a(x, 1, 2), b(x, x, x);\n"
                 "auto n = a.norm(); auto c = a.cross(b); auto d = a.dot(b); auto u = a.normalized();\n"
                 "auto I = Matrix3d::Identity(); auto two = 2 * Matrix3d::Identity(); auto e = (a + b).eval();\n"
                 "auto t = a.transpose(); auto first = a.head(2); auto f = [&](double y) { return y * n; };\n"
                 "auto g = [](const Vector3d& v) -> Vector3d { return 2 * v; }; auto i = 3; auto s = x;\n"
                 "for (auto y : std::vector<double>{x}) s += y; const auto& r = a; auto [p, q] = std::pair(1, 2);\n"
                 "return c(0) + d + u(0) + I(0, 0) + two(0, 0) + e(0) + t(0) + first(0) + f(1) + g(a)(0) + i + s + "
                 "r(0) + p + q;"))) == "");
}

TEST_CASE("right code that looks like a mistake is not accused") {
  CHECK(all_of(look("// 1/2, sin(30), x ^ 2 and 3.14 in a comment\n/* 1/2\n 1/2 */\n#include <cmath>\n" +
                    body(R"code(const char* text = "1/2 sin(30) 3.14 float"; char letter = '/';
const char* raw = R"(1/2 sin(30))"; (void)text; (void)letter; (void)raw;
double a = 4/2 + 1.0/2 + 1/2.0 + x*1/2 + x/1/2 + (double)1/2 + 1./2 + 1e0/2 + 0x10/3.0;
double b = std::sin(0.5) + std::cos(30 * std::numbers::pi / 180) + std::sin(2) + std::cos(0);
int mask = 3; mask = mask ^ mask; int n = static_cast<int>(x); int k = std::lround(x);
Matrix3d I = Matrix3d::Zero(); I += Matrix3d::Identity(); I.transposeInPlace(); I.setZero();
Matrix3d J; J.setZero(); J += I; Matrix3d K; K << 1, 2, 3, 4, 5, 6, 7, 8, 9; K += J;
double s = 0; for (int i = 0; i < 3; ++i) s += i; while (s > 100) s /= 2;
std::vector<int> v(3); std::size_t m = v.size() - 1; s += v[m/2] + v[1/2];
double pi = 3.14159265358979323846; do { s -= 1; } while (s > 1e6);
return a + b + mask + n + k + K(0, 0) + s + pi;)code"))) == "");
}

TEST_CASE("a sum is accused only where no other statement can have given it a value") {
  const auto said = [](const std::string& text) { return all_of(text_mistakes(body(text))); };
  CHECK(said("Matrix3d I;\nif (x > 0) I += Matrix3d::Identity(); else I = Matrix3d::Zero();\nreturn I.trace();") == "");
  CHECK(said("Matrix3d I;\nfill(I); I += Matrix3d::Identity(); return I.trace();") == "");
  CHECK(said("Vector3d v;\nv(0) = 1; v += Vector3d::Zero(); return v(0);") == "");
  CHECK(said("static Matrix3d I;\nI += Matrix3d::Identity(); return I(0, 0);") == "");
}

TEST_CASE("a method of a student's own type may change what it likes") {
  CHECK(all_of(text_mistakes("struct Frame { void transpose() {} };\n" + body("Frame f;\nf.transpose(); return x;"))) ==
        "");
}

TEST_CASE("every solution of the course stands a closer look at its text") {
  std::size_t solutions = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(WORKBOOK_TEST_SOLUTIONS)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".cpp" || name == "judging.cpp" || name == "main.cpp") continue;
    CAPTURE(name);
    std::ifstream stream(entry.path());
    std::ostringstream text;
    text << stream.rdbuf();
    if (text.str().find("namespace rigid {") == std::string::npos) continue;
    CHECK(all_of(text_mistakes(text.str())) == "");
    ++solutions;
  }
  CHECK(solutions >= 48);
}

TEST_CASE("at most four mistakes are told, in the order of the lines") {
  const std::vector<Finding> found =
      look(body("double a;\ndouble b = 1/2;\ndouble c = 1/3;\ndouble d = 1/4;\ndouble e = 1/5;"
                "\ndouble f = 1/6;\nreturn x;"));
  REQUIRE(found.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(found[i].line == static_cast<int>(i) + 4);
}

TEST_CASE("where the closer look itself fails, it finds nothing and says nothing") {
  const fs::path directory = fresh_directory("closer-look-trouble");
  const fs::path file = write(directory / "twice.cpp", body("double y = 2 * x; return 2;"));
  const CompileTask task{file, "twice", "double twice(double x)"};
  Toolchain broken = toolchain();
  broken.compiler = "/nowhere/c++";
  CHECK(source_findings(task, broken, shared_cache(), Depth::compiler).empty());
  CHECK(source_findings(task, toolchain(), write(directory / "in-the-way", "") / "cache", Depth::compiler).empty());
  CHECK(source_findings({directory / "none.cpp", "twice", ""}, toolchain(), shared_cache(), Depth::compiler).empty());
  CompileLimits short_time;
  short_time.time = std::chrono::milliseconds(1);
  CHECK(source_findings(task, toolchain(), shared_cache(), Depth::compiler, short_time).empty());
  CHECK(nothing_left_running());
}

TEST_CASE("text that is no program at all is looked at without harm") {
  for (const std::string text :
       {"",     "\n",   "/*",   "\"", "'",  "R\"(",     "R\"x",    "((((", "auto",        "auto x =", "1/",
        "sin(", "for(", "}}}}", "#",  "\\", "\xff\xfe", "auto f(", "3.14", "Matrix3d I;", "180"})
    CHECK(text_mistakes(text).size() <= 1);
  CHECK(text_mistakes(std::string(200000, '(')).empty());
}

}  // namespace workbook::testing
