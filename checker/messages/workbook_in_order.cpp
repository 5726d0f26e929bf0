#include "checker/messages/workbook_in_order.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

std::string file_on_card_is_missing(const std::string& file) {
  return fmt::format("{}: missing, though the card names it; write it, or take it off the card.", file);
}

std::string file_on_no_card(const std::string& file) {
  return fmt::format("{}: no card lists it; add its exercise to the card, or move the file away.", file);
}

std::string exercise_on_two_cards(const std::string& card, const std::string& exercise, const std::string& other) {
  return fmt::format("{}: the exercise '{}' stands on the card of {} too; rename one.", card, exercise, other);
}

std::string contract_is_missing(const std::string& contract, const std::string& lecture) {
  return fmt::format("{}: missing, though the card of {} names it as the contract.", contract, lecture);
}

std::string builds_on_unknown(const std::string& card, const std::string& earlier) {
  return fmt::format("{}: builds_on names '{}', which is no lecture of the course; correct the name.", card, earlier);
}

std::string another_number_of_hints(const std::string& file, std::size_t hints, std::size_t wanted) {
  return fmt::format("{}: {} instead of {}; separate them by lines of three dashes.", file,
                     counted(hints, "hint", "hints"), wanted);
}

std::string two_hints_are_the_same(const std::string& file) {
  return fmt::format("{}: two hints are the same; write another.", file);
}

std::string not_the_stub(const std::string& file, const std::string& exercise) {
  return fmt::format("{}: not the stub that the card makes (is it solved?); `{}` puts it back.", file,
                     command("reset " + exercise));
}

std::string contract_declares_otherwise(const std::string& contract, const std::string& signature) {
  return fmt::format("{}: does not declare `{}`; make contract and judging agree, names of the arguments included.",
                     contract, signature);
}

std::string no_such_anchor(const std::string& notes, const std::string& anchor, const std::string& who) {
  return fmt::format(
      "{}: no paragraph has the anchor '{}', to which {} points; add {{#{}}} to a heading, or mend the pointer.", notes,
      anchor, who, anchor);
}

std::string the_card_points() { return "the card"; }

std::string misconception_points(const std::string& exercise, const std::string& misconception) {
  return fmt::format("{}, {}", exercise, misconception);
}

std::string property_points(const std::string& exercise) { return fmt::format("{}, a property", exercise); }

std::string quoted_without_marks(const std::string& notes, const std::string& example, const std::string& file,
                                 std::size_t marks) {
  return fmt::format("{}: quotes '{}' of {}, which has {} of the two marks `//! [{}]`; put them around the example.",
                     notes, example, file, marks, example);
}

std::string fact_is_not_taught(const std::string& notes, int fact) {
  return fmt::format(
      "{}: no paragraph is marked with `<!-- fact {} -->`, though the card says that the lecture teaches it.", notes,
      fact);
}

std::string judging_is_inconsistent(const std::string& lecture, const std::string& exercise,
                                    const std::string& sentence) {
  return fmt::format("solutions/{}/judging.cpp: {}: {}", lecture, exercise, sentence);
}

std::string few_misconceptions(std::size_t found, std::size_t fewest) {
  if (found == 1) return fmt::format("There is 1 misconception, fewer than {}.", fewest);
  return fmt::format("There are {} misconceptions, fewer than {}.", found, fewest);
}

std::string few_routes(std::size_t found, std::size_t fewest) {
  if (found == 1) return fmt::format("There is 1 route, fewer than {}.", fewest);
  return fmt::format("There are {} routes, fewer than {}.", found, fewest);
}

std::string few_deciding_cases(std::size_t found, std::size_t fewest) {
  if (found == 1) return fmt::format("There is 1 deciding case, fewer than {}.", fewest);
  return fmt::format("There are {} deciding cases, fewer than {}.", found, fewest);
}

std::string no_worked_case() { return "No case is a worked one."; }

std::string no_sweep() { return "There is no sweep to plot."; }

std::string expected_values_fail(const std::string& verdict) {
  return fmt::format("The expected values do not pass: {}", verdict);
}

std::string expected_value_lacks(const std::string& case_name, const std::string& property, const std::string& detail) {
  return fmt::format("The expected value of the case “{}” is not {}: {}.", case_name, property, detail);
}

std::string misconception_is_right(const std::string& name) {
  return fmt::format("The misconception {} is right at all deciding cases.", name);
}

std::string misconceptions_cannot_be_told_apart(const std::string& one, const std::string& other) {
  return fmt::format(
      "The misconceptions {} and {} have different messages but cannot be told apart at the deciding cases.", one,
      other);
}

std::string misconception_is_not_named(const std::string& name, const std::string& instead) {
  return fmt::format("The misconception {} is not named when a student has it: {}", name, instead);
}

std::string terms_do_not_add_up(const std::string& case_name) {
  return fmt::format("The terms do not add up to the expected value at the case “{}”.", case_name);
}

std::string terms_are_not_independent() { return "The terms are not independent at the deciding cases."; }

std::string route_fails(const std::string& name, const std::string& verdict) {
  return fmt::format("The route “{}” does not pass: {}", name, verdict);
}

std::string stub_is_judged_otherwise(const std::string& file, const Judgement& judgement, const std::string& exercise) {
  return fmt::format("{}: the verdict is {}, not {}: {} `{}` puts the stub back.", file, to_string(judgement.verdict),
                     to_string(Verdict::not_started), judgement.message, command("reset " + exercise));
}

std::string solution_is_judged_otherwise(const std::string& file, const Judgement& judgement) {
  return fmt::format("{}: the verdict is {}, not {}: {} Mend the solution or its judging.", file,
                     to_string(judgement.verdict), to_string(Verdict::passed), judgement.message);
}

std::string passes_and_is_accused(const std::string& file, const std::string& diagnosis) {
  return fmt::format("{}: passes and is accused all the same: {}", file, diagnosis);
}

std::string lecture_and_seed(const std::string& lecture, std::uint64_t seed) {
  return fmt::format("{}, seed {}", lecture, seed);
}

std::string to_mend(std::size_t faults) { return fmt::format("{} to mend.", counted(faults, "thing", "things")); }

std::string in_order(const Extent& extent) {
  return fmt::format(
      "In order: {}, {}, {}, {}, {}.", counted(extent.lectures, "lecture", "lectures"),
      counted(extent.exercises, "exercise", "exercises"), counted(extent.routes, "right route", "right routes"),
      counted(extent.misconceptions, "wrong answer", "wrong answers"), counted(extent.seeds, "seed", "seeds"));
}

}  // namespace workbook::messages
