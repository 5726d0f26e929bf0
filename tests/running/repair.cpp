// A wrong value explained by trying: one token changed, or a finding about the code fixed.
#include "tests/running/student.hpp"

#include "checker/compile/source_findings.hpp"
#include "checker/explain/repair.hpp"
#include "checker/explain/variants.hpp"
#include "checker/judging/judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>

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
struct Judged {
  Submission submission;
  ExerciseReference reference = n_times_x();
  Observation observation;
  Judgement judgement;

  explicit Judged(const std::string& body) : submission(submit(text_of(body), "signed_by")) {
    ExerciseRunner runner(executable(submission.text, "signed_by"), short_limits());
    observation = runner.observe(reference.cases, {});
    judgement = judge(reference, observation);
    REQUIRE(judgement.verdict == Verdict::wrong_value);
  }

  static std::string text_of(const std::string& body) {
    return "#include <fixture/contract.hpp>\n#define HALF 0.5\n\nusing namespace Eigen;\n\ndouble rigid::signed_by(int "
           "n, "
           "double x) {\n" +
           body + "\n}\n";
  }

  std::optional<Finding> slip() const {
    return slip_of_one_token({submission, reference, observation, judgement}, toolchain(), shared_cache());
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
      {"return n + x * x;", "", 0, 0},
  };
  for (const Slip& slip : slips) {
    CAPTURE(std::string(slip.body));
    const auto found = Judged(slip.body).slip();
    REQUIRE(found.has_value() == (*slip.name != '\0'));
    if (!found) continue;
    CHECK(found->name == slip.name);
    CHECK(found->line == slip.line);
    CHECK(found->column == slip.column);
  }
  CHECK(nothing_left_running());
}

TEST_CASE("a variant that never ends, or throws, hides no other") {
  const auto slip = Judged(
                        "for (int i = 0; i < 4; i += 1) x = x + 0;\nconst std::vector<double> v(2, "
                        "x);\nif (n > 2) return -n * v.at(0);\nreturn n * x;")
                        .slip();
  REQUIRE(slip.has_value());
  CHECK(slip->line == 8);  // another sign there is as good as one in the next line
}

TEST_CASE("a finding is decisive if its fix makes all cases right") {
  const auto decisive = [](const std::string& body) -> std::string {
    const Judged judged(body);
    const CompileTask task{judged.submission, "signed_by", signature("signed_by")};
    const Compilation compilation = compile(task, toolchain(), shared_cache());
    const auto finding =
        decisive_finding({judged.submission, judged.reference, judged.observation, judged.judgement},
                         source_findings(task, compilation, toolchain(), shared_cache()), toolchain(), shared_cache());
    return finding ? finding->name : "";
  };
  CHECK(decisive("return 2 * n * x * (1 / 2);") == "integer_division");
  CHECK(decisive("int half = x / 2;\nreturn 2 * n * half;") == "narrowing");
  CHECK(decisive("return 2 * n * x * (1 / 3);") == "");  // another mistake besides
  CHECK(decisive("return -n * x;") == "");               // nothing found
}

TEST_CASE("a unit of variants knows its lines, and reads headers once") {
  const std::string text = Judged::text_of("return n + x;");
  const ExerciseReference reference = n_times_x();
  const SourceText source(text);
  const std::vector<Variant> variants = one_token_variants(source, reference);
  REQUIRE(variants.size() > 2);
  const VariantUnit unit(text, variants, reference);
  CHECK(unit.text().find("#include") == unit.text().rfind("#include"));
  CHECK(unit.variant_at(1) == -1);
  CHECK(unit.variant_at(static_cast<int>(std::ranges::count(unit.text(), '\n'))) == -1);
  int last = -1;
  for (int line = 1; line < static_cast<int>(std::ranges::count(unit.text(), '\n')); ++line) {
    const int variant = unit.variant_at(line);
    if (variant >= 0) CHECK((variant == last || variant == last + 1));
    last = std::max(last, variant);
  }
  CHECK(last == static_cast<int>(variants.size()) - 1);
}

}  // namespace workbook::testing
