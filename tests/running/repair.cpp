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
#include <fmt/format.h>

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

  DiagnosticTask task() const { return {submission, reference, observation, judgement}; }

  std::optional<Reason> slip(Sought sought = Sought::all) const {
    return slip_or_branch(task(), toolchain(), shared_cache(), sought);
  }

  CodeReasons reasons(const std::vector<Reason>& findings, const std::vector<Variant>& variants) const {
    return code_reasons(task(), findings, variants, toolchain(), shared_cache());
  }
};

/// Those of repairs.txt with such a title.
std::vector<Snippet> snippets_of(const std::string& title) {
  std::vector<Snippet> all = snippets_in("repairs.txt");
  std::erase_if(all, [&](const Snippet& each) { return !each.title.starts_with(title); });
  REQUIRE(!all.empty());
  return all;
}

void check_slips(const std::string& title) {
  for (const Snippet& each : snippets_of(title)) {
    CAPTURE(each.text);
    const auto found = Attempt(each.text).slip();
    std::string told = found ? fmt::format("{} {}:{}", found->name, found->line, found->column) : "nothing";
    if (found && found->name == "branch") told += " " + found->sentence;
    INFO((found ? found->sentence : std::string()));
    CHECK(told == each.said);
  }
  CHECK(nothing_left_running());
}

}  // namespace

TEST_CASE("the one token with which all cases are right is found, or the wrong branch, with its place") {
  check_slips("one token");
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
  for (const Snippet& each : snippets_of("findings")) {
    CAPTURE(each.text);
    const Attempt judged(each.text);
    const CompileTask task{judged.submission, "signed_by", signature("signed_by")};
    const Compilation compilation = compile(task, toolchain(), shared_cache());
    const std::vector<Reason> findings = source_findings(task, compilation, toolchain(), shared_cache());
    const CodeReasons found = judged.reasons(findings, fixed_variants(SourceText(judged.submission.text), findings));
    std::string names = found.are_all ? "all:" : found.reasons.empty() ? "nothing" : "a part:";
    for (const Reason& reason : found.reasons) names += " " + reason.name;
    CHECK(names == each.said);
  }
}

TEST_CASE("a quotient of whole numbers with names is a reason where one of doubles is right") {
  for (const Snippet& each : snippets_of("quotient")) {
    CAPTURE(each.text);
    const Attempt judged(each.text);
    const auto [found, changed] = slips_of_language(SourceText(judged.submission.text), judged.reference);
    CHECK(found.size() == 1);
    CHECK(judged.reasons(found, changed).are_all == (each.said == "all"));
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
  check_slips("thorough");
}

TEST_CASE("of what is explained only a single slip is sought") {
  CHECK(Attempt("return -n * x;").slip(Sought::one_slip).has_value());
  CHECK_FALSE(Attempt("if (x > 1.5) return 0;\nreturn n * x;").slip(Sought::one_slip).has_value());
}

TEST_CASE("the branch that the failing cases take is named with its condition, and whether all is right without it") {
  check_slips("branch");
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
