// A wrong value explained by trying: one token changed, or a finding about the code fixed.
#include "tests/running/student.hpp"

#include "checker/base/text.hpp"
#include "checker/compile/compile.hpp"
#include "checker/explain/explain.hpp"
#include "checker/explain/repair.hpp"
#include "checker/explain/slips.hpp"
#include "checker/explain/variants.hpp"
#include "checker/judging/judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

namespace workbook::testing {

namespace {

/// signed_by(n, x) = n x, at some inputs.
ExerciseReference n_times_x() {
  ExerciseReference reference;
  reference.name = "signed_by";
  reference.signature = signature("signed_by");
  reference.arguments = {{"n", Kind::integer, {}}, {"x", Kind::number, {}}};
  reference.result_kind = Kind::number;
  for (const double x : {1.0, 2.0, -0.5, 7.25}) {
    Case one;
    one.name = "made up";
    one.inputs = {Value{1, 1, {3}}, Value{1, 1, {x}}};
    one.expected = Value{1, 1, {3 * x}};
    one.scale = {1.0};
    reference.cases.push_back(one);
  }
  return reference;
}

/// A file, judged.
struct Attempt {
  Submission submission;
  ExerciseReference reference = n_times_x();
  Observation observation;
  Judgement judgement;

  explicit Attempt(const std::string& body) : submission(submit(text_of(body), "signed_by")) {
    ExerciseRunner runner(executable(submission.text, "signed_by"), short_limits());
    observation = runner.observe(plan_calls(reference.cases), {});
    judgement = judge(reference, observation);
    REQUIRE(judgement.verdict == Verdict::wrong_value);
  }

  static std::string text_of(const std::string& body) {
    return "#include <fixture/contract.hpp>\n#define HALF 0.5\n\nusing namespace Eigen;\n\ndouble rigid::signed_by(int "
           "n, "
           "double x) {\n" +
           body + "\n}\n";
  }

  std::optional<Reason> slip(Sought sought = Sought::all) const {
    return slip_or_branch({submission, reference, observation, judgement}, toolchain(), shared_cache(), sought);
  }
};

}  // namespace

TEST_CASE("the one token with which all cases are right is found, with its place") {
  struct Slip {
    const char* body;
    const char* name;
    int line, column;
  };
  const Slip slips[] = {
      {"return -n * x;", "slip_sign", 7, 8},
      {"return n - x;", "", 0, 0},
      {"double a = n, b = x;\nreturn a * a;", "slip_name", 8, 8},
      {"return 3.0 * n * x;", "slip_number", 7, 8},
      {"return n * std::abs(x);", "slip_function", 7, 17},
      {"const Vector3d v(x, 1, 2);\nreturn n * v[1];", "slip_index", 8, 14},
      {"const Vector3d v(3, 4, 9);\nreturn n * x * v.head<2>().norm() / 25;", "slip_method", 8, 28},
      {"return n + x * x;", "", 0, 0},
      {"double sum = 0;\nfor (int i = 1; i < 3; ++i) sum += n * x / 3;\nreturn sum;", "slip_loop", 8, 19},
      // A condition that only switches a wrong branch off is no slip.
      {"if (x < 0) return 1.0;\nreturn n * x;", "branch", 7, 1},
      {"return x == 2.0 ? 0 : n * x;", "branch", 7, 8},
      {"return x < 0 ? -n * x : n * x;", "slip_sign", 7, 16},
      {"const bool small = x < 1;\nif (small) return 0;\nreturn n * x;", "branch", 8, 1},
      {"if (x > -9) return 7;\nreturn n * x;", "", 0, 0},  // taken always
      // Another sign or number in the first line would keep all cases from the last one.
      {"const double y = 3 - x;\nif (y > 0) return n * x;\nreturn 7;", "branch", 8, 1},
      {"return n / x;", "slip_factor", 7, 12},
      {"const double h = 0.001;\nreturn n * ((x + h) * (x + h) - x * x) / (2 * h);", "slip_coarse", 7, 18},
  };
  for (const Slip& slip : slips) {
    CAPTURE(std::string(slip.body));
    const auto found = Attempt(slip.body).slip();
    REQUIRE(found.has_value() == (*slip.name != '\0'));
    if (!found) continue;
    CHECK(found->name == slip.name);
    CHECK(found->line == slip.line);
    CHECK(found->column == slip.column);
  }
  CHECK(nothing_left_running());
}

TEST_CASE("a variant that never ends, or throws, hides no other") {
  const auto slip = Attempt(
                        "for (int i = 0; i < 4; i += 1) x = x + 0;\nconst std::vector<double> v(2, "
                        "x);\nif (n > 2) return -n * v.at(0);\nreturn n * x;")
                        .slip();
  REQUIRE(slip.has_value());
  CHECK(slip->line == 8);  // another sign there is as good as one in the next line
}

TEST_CASE("findings are the reason if their fix makes all cases right, and a part of it if it changes the value") {
  const auto reasons = [](const std::string& body) -> std::string {
    const Attempt judged(body);
    const CompileTask task{judged.submission, "signed_by", signature("signed_by")};
    const Compilation compilation = compile(task, toolchain(), shared_cache());
    const std::vector<Reason> findings = source_findings(task, compilation, toolchain(), shared_cache());
    const CodeReasons found =
        code_reasons({judged.submission, judged.reference, judged.observation, judged.judgement}, findings,
                     fixed_variants(SourceText(judged.submission.text), findings), toolchain(), shared_cache());
    std::string names = found.are_all ? "all:" : "";
    for (const Reason& each : found.reasons) names += " " + each.name;
    return names;
  };
  CHECK(reasons("return 2 * n * x * (1 / 2);") == "all: integer_division");
  CHECK(reasons("const double a = 1 / 2 * x;\nconst double b = 1 / 2 * x;\nreturn n * (a + b);") ==
        "all: integer_division integer_division");
  CHECK(reasons("int half = x / 2;\nreturn 2 * n * half;") == "all: narrowing");
  CHECK(reasons("int sum = 0;\nfor (int i = 0; i < 2; ++i) sum += n * x / 2;\nreturn sum;") == "all: narrowing");
  CHECK(reasons("return n * x * (1 / 3);") == " integer_division");                 // another mistake besides
  CHECK(reasons("return -n * x + 0 * (1 / 3);") == "");                             // it changes nothing
  CHECK(reasons("return -n * x;") == "");                                           // nothing found
  CHECK(reasons("int steps = 1000 * x;\nreturn n * n * x + 1e-4 * steps;") == "");  // it changes next to nothing
}

TEST_CASE("a quotient of whole numbers with names is a reason where one of doubles is right") {
  struct Quotient {
    const char* body;
    std::size_t found;
    bool is_reason;
  };
  const Quotient quotients[] = {
      {"const int one = 1, two = 2;\nreturn 2 * n * x * (one / two);", 1, true},
      {"auto ratio = [](int a, int b) { return a / b; };\nreturn 2 * n * x * ratio(1, 2);", 1, true},
      {"const int steps = 4;\ndouble sum = 0;\nfor (int i = 0; i < steps; ++i) sum += (1 / steps) * n * x;\nreturn "
       "sum;",
       1, true},
      {"const int k = 5;\nreturn -n * x * (k / 3);", 1, false},
      {"return x / 2 * n / 1.0;", 1, false},
      {"return 4 * n * x / 2 * 2;", 1, true},  // the divisor
  };
  for (const Quotient& each : quotients) {
    CAPTURE(std::string(each.body));
    const Attempt judged(each.body);
    const SourceText source(judged.submission.text);
    const auto [found, changed] = slips_of_language(source, judged.reference);
    CHECK(found.size() == each.found);
    CHECK(code_reasons({judged.submission, judged.reference, judged.observation, judged.judgement}, found, changed,
                       toolchain(), shared_cache())
              .are_all == each.is_reason);
  }
}

TEST_CASE("a unit of variants knows its lines, and reads headers once") {
  const std::string text = Attempt::text_of("static int calls = 0;\nreturn n + x * std::sin(x);");
  const ExerciseReference reference = n_times_x();
  const SourceText source(text);
  std::vector<Variant> variants = one_token_variants(source, reference);
  const std::size_t slips = variants.size();
  for (Variant& other : fixed_variants(source, {{.line = 7, .fix = Fix::not_static}}))
    variants.push_back(std::move(other));
  REQUIRE(slips > 20);
  REQUIRE(variants.size() == slips + 1);
  const VariantUnit unit(source, variants, reference);
  CHECK(unit.text().find("#include") == unit.text().rfind("#include"));
  CHECK(unit.variants_at(1).empty());
  std::set<std::size_t> seen;
  const auto lines = lines_of(unit.text());
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const std::set<std::size_t> here = unit.variants_at(static_cast<int>(line) + 1);
    seen.insert(here.begin(), here.end());
    // What names one variant alone is that one's.
    if (const Match only = search(lines[line], "^workbook_is\\((\\d+)\\) \\?"))
      CHECK(here == std::set{std::stoul(only[1])});
  }
  CHECK(seen.size() == variants.size());
}

// To compile and try all pairs takes a quarter of a minute.
TEST_CASE("a bound in a condition, brackets and a name with something left out are found" *
          doctest::test_suite("thorough")) {
  struct Slip {
    const char* body;
    const char* name;
    int line;
  };
  const Slip slips[] = {
      {"return (x < -1 ? -1 : 1) * n * std::sqrt(x * x);", "slip_guard", 7},
      {"double sum = 0;\nfor (int i = 0; i + 1 < n; ++i) sum += x;\nreturn sum;", "slip_loop", 8},
      {"return n + n / 2.0 * x;", "slip_brackets", 7},
      {"return x < 100 ? x : x * n;", "slip_brackets", 7},
      {"const Matrix3d A = Vector3d(n, n, 2).asDiagonal();\nconst Vector3d v = x * Vector3d::UnitX(), u = A * "
       "v.cross(Vector3d::UnitY());\nreturn u.sum();",
       "slip_brackets", 8},
      {"Matrix3d A = Matrix3d::Zero(), B = A;\nA(0, 1) = n;\nB(0, 1) = x;\nconst Matrix3d C = B.transpose() * "
       "A;\nreturn "
       "C(0, 0);",
       "slip_brackets", 10},
      {"VectorXd m(4);\nm << x, 2 * x, x / 2, 0;\nconst double all = m.sum();\ndouble s = 0;\nfor (int k = 0; k < 4; "
       "++k) "
       "s += all * 6 / 7;\nreturn s;",
       "slip_name", 11},
      {"const double a = std::abs(x), b = std::fabs(2 * x);\nreturn n * (a + b) / 3;", "slip_function", 7},
      {"double a, b, c;\na = b = c = -x;\nreturn n * a;", "slip_sign", 8},
      {"double a = std::sqrt(std::abs(x)), b = 2;\nreturn n * (b * b) * (x < 0 ? -1 : 1);", "slip_name", 8},
      {"double a = x, b = n;\na = b;\nb = a;\nreturn a * b;", "slip_overwritten", 9},
      {"return n * std::sin(std::asin(x / 100) / 2) * 100;", "slip_function", 7},
      {"const double half = 0.5;\nreturn (n + n) * x;", "slip_factor", 8},
      {"const Vector3d v(x, 2, 1);\nreturn n * v.y();", "slip_method", 8},
      {"const Matrix3d M{{2, 1, 0}, {1, 1, 0}, {0, 0, 1}};\nreturn n * x * M.cwiseInverse()(0, 0);", "slip_method", 8},
      {"Matrix3d K;\nK << x, 1, 2, 3, 4, 5, 6, 7, 8;\nreturn -n * K(0, 0);", "slip_sign", 8},
      {"const Matrix3d D = Vector3d(x, 1, 2).asDiagonal();\nreturn -n * D(0, 0);", "slip_sign", 7},
      {"const Vector3d v(x, 2 * x, 4 * x);\ndouble s = 0;\nfor (int k = 0; k < 3; ++k) s += v[0];\nreturn n * s / 7;",
       "slip_index", 9},
      {"return n * std::tan(std::atan2(1, x));", "slip_function", 7},
      {"double a = x, b = n;\nstd::swap(a, b);\nreturn -a * b;", "slip_sign", 7},
      {"double s = 0;\nfor (int k = 0; k < 9; k++) s += x;\nreturn s;", "slip_brackets", 8},
      {"return n * std::abs(x) * x > 0 ? 1 : -1;", "slip_brackets", 7},
      {"const Vector2d w{2.0, 5.0};\nreturn n * x * (w[0] * w[0] - 12 * w[1]);", "slip_number", 7},
      {"const double y = (1 - 2) * x;\nreturn n * y;", "slip_sign", 7},
      {"const double a = 4, b = 3;\nreturn n * x / a;", "slip_name", 8},
      // Ten times as many steps are too many to try.
      {"const double h = 3e-6;\ndouble s = 0;\nfor (double u = 0; u < 1; u += h) s += h * 3 * u * u;\nreturn n * x * "
       "s;",
       "slip_coarse", 7},
      {"double s = 0;\nfor (int i = 0; i < 400; ++i) s += 3.0 * i * i / 400 / 400 / 400;\nreturn n * x * s;",
       "slip_coarse", 8},
  };
  for (const Slip& slip : slips) {
    CAPTURE(std::string(slip.body));
    const auto found = Attempt(slip.body).slip();
    REQUIRE(found.has_value());
    CHECK(found->name == slip.name);
    CHECK(found->line == slip.line);
  }
}

TEST_CASE("of what is explained only a single slip is sought") {
  CHECK(Attempt("return -n * x;").slip(Sought::one_slip).has_value());
  CHECK_FALSE(Attempt("if (x > 1.5) return 0;\nreturn n * x;").slip(Sought::one_slip).has_value());
}

TEST_CASE("the branch that the failing cases take is named with its condition, and whether all is right without it") {
  struct Wrong {
    const char* body;
    int line, column;
    const char* condition;
    bool repairs = true;
  };
  const Wrong wrongs[] = {
      {"if (x > 1.5) return 0;\nreturn n * x;", 7, 1, "`x > 1.5` is true"},
      {"if (!(x > 1.5))\n  return n * x;\nelse return 0;", 7, 1, "`!(x > 1.5)` is false"},
      {"const double y = std::abs(x) < 0.6 ? 0 : x;\nreturn n * y;", 7, 18, "`std::abs(x) < 0.6` is true"},  // one case
      {"if (x > 0)\n  if (x > 1.5) return 0;\nreturn n * x;", 8, 3, "`x > 1.5` is true"},
      {"if (x < 1.5) x = 1;\nreturn n * x;", 7, 1, "`x < 1.5` is true"},  // 1 is right by chance
      {"if (x > 3) x = 0;\nreturn n * x * x;", 0, 0, ""},                 // fails elsewhere too
  };
  for (const Wrong& wrong : wrongs) {
    CAPTURE(std::string(wrong.body));
    const auto found = Attempt(wrong.body).slip();
    REQUIRE(found.has_value() == (wrong.line > 0));
    if (!found) continue;
    CHECK(found->name == "branch");
    CHECK(found->line == wrong.line);
    CHECK(found->column == wrong.column);
    CHECK_MESSAGE(found->sentence.find(wrong.condition) != std::string::npos, found->sentence);
    CHECK((found->sentence.find("always") != std::string::npos) == wrong.repairs);
  }
  CHECK(nothing_left_running());
}

TEST_CASE("of the variants that are bugs, statements, comparisons and calls are left out or changed too") {
  const std::string text =
      Attempt::text_of("Vector3d v(x, 0, 0);\nv.normalize();\nif (x < 0) std::swap(n, n);\nreturn n * v.norm();");
  const ExerciseReference reference = n_times_x();
  const SourceText source(text);
  std::set<std::string> changed;
  for (const Variant& mutant : source_mutants(source, reference)) changed.insert(edited(text, mutant.edits));
  const auto has = [&](const std::string& from, const std::string& to) {
    std::string wanted = text;
    wanted.replace(wanted.find(from), from.size(), to);
    return changed.contains(wanted);
  };
  CHECK(has("v.normalize();", ";"));
  CHECK(has("if (x < 0) std::swap(n, n);", ";"));
  CHECK(has("x < 0", "x <= 0"));
  CHECK(has("x < 0", "x > 0"));
  CHECK(has("x < 0", "x < 1"));
  CHECK(has("n * v", "n / v"));
  CHECK(has("v.norm()", "v"));
  CHECK(!changed.contains(text));
}

TEST_CASE("a whole number that no type holds becomes no other one by accident") {
  const std::string text = Attempt::text_of("return n * x * 99999999999999999999;");
  for (const Variant& variant : one_token_variants(SourceText(text), n_times_x()))
    CHECK_MESSAGE(!has(edited(text, variant.edits), "9223372036854775808"), edited(text, variant.edits));
}

TEST_CASE("what names the line to change is told at the third try of a problem, and slips of C++ at once") {
  const ExerciseReference reference = n_times_x();
  Answers answers;
  for (const Case& one : reference.cases) answers.emplace_back(one.expected);
  answers.front() = Value{1, 1, {-3}};
  for (const int stage : {1, 2, 3}) {
    std::vector<Reason> reasons = {{.name = "integer_division"}, {ReasonKind::repair, "slip_name"}};
    hold_back(reasons, stage, reference, answers);
    CHECK(reasons.size() == (stage == 3 ? 2 : 1));
    CHECK(reasons.front().name == "integer_division");
    for (const char* name : {"slip_sign", "branch"}) {
      reasons = {{ReasonKind::repair, name}};
      hold_back(reasons, stage, reference, answers);
      REQUIRE(reasons.size() == 1);
      CHECK(reasons.front().name == (stage == 3 ? name : "where"));
    }
  }
}

TEST_CASE("where no region is wrong, the second try of a problem is told with which inputs the factor changes") {
  ExerciseReference reference = n_times_x();
  reference.cases.resize(1);
  const auto vary = [&](int argument, double n, double x) {
    Case one = reference.cases.front();
    one.inputs = {Value{1, 1, {n}}, Value{1, 1, {x}}};
    one.expected = Value{1, 1, {n * x}};
    one.base = 0;
    one.argument = argument;
    reference.cases.push_back(one);
  };
  vary(0, 5, 1);
  vary(1, 3, 2);
  Answers answers;
  for (const Case& one : reference.cases)
    answers.emplace_back(Value{1, 1, {2 * one.expected.numbers[0] * one.inputs[1].numbers[0]}});
  for (const int stage : {1, 2}) {
    std::vector<Reason> reasons = {{ReasonKind::misconception, "squared"}};
    hold_back(reasons, stage, reference, answers);
    REQUIRE(reasons.size() == 1);
    const bool is_told =
        has(reasons.front().sentence, "between your result and the right one changes with x, not with n.");
    CHECK_MESSAGE(is_told == (stage == 2), reasons.front().sentence);
  }
}

}  // namespace workbook::testing
