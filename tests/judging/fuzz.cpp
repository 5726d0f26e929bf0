// Ten thousand damaged files and replies: whatever their bytes are, the checker does not crash, does not hang, and
// gives no mark that they do not earn. The damage follows from a number, so a failure can be repeated.
#include "checker/base/text.hpp"
#include "checker/course/assignment.hpp"
#include "checker/course/course.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/grading/grading.hpp"
#include "checker/judging/judge.hpp"
#include "checker/sandbox/worker_process.hpp"
#include "tests/judging/made_up.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// In this part of them; the test judging_thorough tries all.
const unsigned part = environment("WORKBOOK_TEST_DAMAGES", "some") == "all" ? 1 : 5;
const unsigned damaged_cards = 2500 / part, damaged_references = 2500 / part, damaged_journals = 4000 / part,
               damaged_replies = 1000 / part;

fs::path fuzz_folder(const std::string& name) {
  fs::path folder = fs::path(WORKBOOK_TEST_SCRATCH) / "fuzz" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// In place of an older one, which is removed first: some file systems write a file that is cut and rewritten to disk
/// at once, and wait.
void replace(const fs::path& file, const std::string& text) {
  fs::remove(file);
  write(file, text);
}

/// Bytes that are changed, lost, repeated or cut off.
std::string damaged_text(std::string text, std::mt19937& random) {
  for (std::size_t changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
    const std::size_t at = random() % text.size(), length = random() % 40;
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << random() % 8));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      case 3:
        text[at] = "0123456789-+.eE\"[]{},:\n\0n"[random() % 25];
        break;
      default:
        if (random() % 4 == 0) text.resize(at);
    }
  }
  return text;
}

/// A value of the document is another one, is lost, or is there twice.
json damaged_json(json document, std::mt19937& random) {
  json* at = &document;
  while (at->is_structured() && !at->empty() && random() % 8 != 0)
    at = &std::next(at->begin(), static_cast<long>(random() % at->size())).value();
  json values =
      json::parse(R"([null, true, 0, -1, 3, 1e308, -5e-324, 2147483648, 18446744073709551615, "", "passed", "…",
                                [], {}, [1, 2, 3]])");
  values.push_back(std::string(1, '\xff'));
  if (at->is_structured() && !at->empty() && random() % 2 == 0) {
    const auto one = std::next(at->begin(), static_cast<long>(random() % at->size()));
    if (at->is_array() && random() % 2 == 0)
      at->push_back(json(*one));
    else
      at->erase(one);
  } else {
    *at = values[random() % values.size()];
  }
  return document;
}

std::string either_damaged(const json& document, std::mt19937& random) {
  if (random() % 3 == 0) return damaged_text(document.dump(), random);
  return damaged_json(document, random).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

TEST_CASE("Damaged cards: a sentence, or points that can be given") {
  const fs::path root = fuzz_folder("cards");
  const fs::path card = root / "lectures/01_springs/card.json";
  const auto exercise = [](const char* name, double points) {
    return json{{"name", name},    {"points", points}, {"notes", "springs"}, {"task", "What it is."},
                {"problem", true}, {"difficulty", 2},  {"minutes", 20}};
  };
  const json whole = {{"title", "Springs"},
                      {"summary", "All about them."},
                      {"slides", {"1–3"}},
                      {"builds_on", json::array()},
                      {"contract", "springs"},
                      {"facts", {1, 2}},
                      {"exercises", {exercise("spring_energy", 2), exercise("spring_force", 0.5)}}};
  const fs::path course_file = write(
      root / "course.json",
      json{{"root", root.string()}, {"reference", ""}, {"toolchain", ""}, {"scratch", ""}, {"notes", ""}, {"build", ""}}
          .dump());
  unsigned refused = 0;
  for (unsigned seed = 0; seed < damaged_cards; ++seed) {
    std::mt19937 random(seed);
    replace(card, either_damaged(whole, random));
    CAPTURE(seed);
    try {
      const Course course(course_file);
      const Assignment assignment(course, std::nullopt);
      for (const auto& each : assignment.exercises())
        CHECK((each.entry->points > 0 && std::isfinite(each.entry->points)));
    } catch (const CourseError&) {
      ++refused;
    }
  }
  CHECK(refused > damaged_cards / 3);
}

TEST_CASE("Damaged reference results: a sentence, or such that nothing wrong passes") {
  LectureReference written{7, "99_made_up", {sound_momentum(), given_results(Kind::number, {number(1), number(2)})}};
  add_property(written.exercises[0], PropertyKind::unit_norm, "It is so.");
  const fs::path file = fuzz_folder("reference") / "reference.json";
  write_reference_results(written, file);
  const std::string whole = read(file);
  const std::vector<std::string> lines = lines_of(whole);
  unsigned refused = 0;
  for (unsigned seed = 0; seed < damaged_references; ++seed) {
    std::mt19937 random(seed);
    CAPTURE(seed);
    const bool has_right_checksum = seed % 2 == 0;  // as if its author had made it so
    if (has_right_checksum) {
      std::vector<std::string> changed = lines;
      std::string& one = changed[1 + random() % (changed.size() - 1)];
      one = either_damaged(json::parse(one), random);
      json header = json::parse(lines[0]), about = json::parse(changed[1], nullptr, false);
      if (about.is_object()) about["checksums"] = json::array({fingerprint(changed[2]), fingerprint(changed[3])});
      changed[1] = about.is_discarded() ? changed[1] : about.dump();
      header["checksum"] = fingerprint(changed[1]);
      changed[0] = header.dump();
      replace(file, joined(changed) + "\n");
    } else {
      replace(file, damaged_text(whole, random));
    }
    try {
      const LectureReference again = read_reference_results(file);
      if (!has_right_checksum) CHECK(as_written(again) == whole);
      for (const ExerciseReference& exercise : again.exercises) {
        CHECK(!judge(exercise, {}).passed());
        const std::vector<Value> nothing(exercise.cases.size(), number(not_a_number));
        CHECK(!judge(exercise, observed(nothing)).passed());
        std::vector<Value> expected;
        for (const Case& one : exercise.cases) expected.push_back(one.expected);
        const Observation right = observed(expected);
        judge(exercise, right);
        plan_repeats(exercise);
        diagnose(exercise, answers_of(exercise, observed(outputs(momentum(), momentum_with(1, 1))).replies));
      }
    } catch (const ReferenceError&) {
      ++refused;
    } catch (const std::exception&) {  // of the diagnosis: an internal error of that one check
      CHECK(has_right_checksum);
    }
  }
  CHECK(refused > damaged_references / 2);
}

TEST_CASE("Damaged journals: a result is the one that was judged, or it is judged again") {
  const fs::path folder = fuzz_folder("journal");
  const auto result = [](Verdict verdict, const std::vector<Value>& values) {
    static const CardExercise entry{"spring_energy", 2, "", "", 0, 0};
    CheckResult checked;
    checked.task.exercise.entry = &entry;
    checked.source = "double spring_energy();\n";
    checked.observation = observed(values);
    checked.judgement = {verdict, "A sentence.", "Another one.", {}, values.size()};
    return checked;
  };
  std::map<std::string, std::string> right;  // by content
  {
    Journal journal(folder / "whole.jsonl");
    for (const Verdict verdict : {Verdict::passed, Verdict::wrong_value, Verdict::not_started}) {
      const std::string content = "content of " + to_string(verdict);
      const CheckResult checked = result(verdict, {number(1), vector({1, not_a_number, infinity})});
      journal.append(fingerprint(content), content, checked);
      right[content] = written_result(checked);
    }
  }
  const std::string whole = read(folder / "whole.jsonl");
  const std::vector<std::string> lines = lines_of(whole);
  unsigned found = 0, lost = 0;
  for (unsigned seed = 0; seed < damaged_journals; ++seed) {
    std::mt19937 random(seed);
    CAPTURE(seed);
    const fs::path file = folder / "damaged.jsonl", merged = folder / "merged.jsonl";
    std::string text;
    for (std::size_t n = 0; n < 4; ++n) text += lines[random() % lines.size()] + "\n";
    const std::string damaged = damaged_text(text, random);
    replace(file, damaged);
    if (seed % 2 == 0) Journal(file, Journal::Access::write, "passed");
    const auto check = [&](Journal journal) {
      for (const auto& [content, bytes] : right) {
        const auto known = journal.find(fingerprint(content), content);
        known ? ++found : ++lost;
        if (known) CHECK(written_result(*known) == bytes);
        CHECK(!journal.find(fingerprint(content), content + "else"));
      }
    };
    check(Journal(file));
    if (seed % 5 != 0) continue;
    fs::remove(merged);
    Journal joined(merged);
    joined.merge(Journal(file, Journal::Access::read));
    check(std::move(joined));
  }
  CHECK(found > damaged_journals);
  CHECK(lost > damaged_journals);
}

TEST_CASE("Damaged replies: a value is what the worker sent in answer to this question") {
  std::vector<Value> expected;
  for (unsigned k = 0; k < damaged_replies; ++k) {
    const double number = k + 1;
    expected.push_back(vector({number, 1 / number, -number, number, 1 / number}));
  }
  Exercise exercise = given_results(Kind::vector, expected);
  for (std::size_t k = 0; k < exercise.cases.size(); ++k)
    exercise.cases[k].inputs = {number(static_cast<double>(k) + 1)};
  RunLimits limits;
  limits.time = std::chrono::minutes(5);  // starting a process takes long beside the sanitizers
  limits.processor_time = std::chrono::minutes(2);
  limits.output_bytes = std::size_t{1} << 20;
  const Observation seen =
      ExerciseRunner(std::filesystem::path(WORKBOOK_TEST_FUZZ_WORKER), limits).observe(plan_calls(exercise.cases), {});
  REQUIRE(!seen.refusal);
  REQUIRE(seen.replies.size() == exercise.cases.size());
  unsigned returned = 0, passed = 0;
  for (std::size_t k = 0; k < seen.replies.size(); ++k) {
    const Reply& reply = seen.replies[k];
    CAPTURE(k);
    CHECK(reply.ending != Ending::time_limit);
    if (reply.ending != Ending::returned) continue;
    ++returned;
    CHECK(!has(reply.printed, "header"));
    CHECK(reply.value.has_shape_of(expected[k]));
    if (!passes(exercise, k, reply.value)) continue;
    ++passed;
    CHECK(!has(reply.printed, "numbers"));
  }
  CHECK(returned > passed);
  CHECK(passed > 20);
  CHECK(returned < damaged_replies / 2);
  CHECK(!judge(exercise, seen).passed());
}

}  // namespace workbook::testing
