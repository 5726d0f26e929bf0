/// @file
/// Skeletons for authors: what is written here builds at once, and `self-check` names what remains to be done.
#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/stub.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

namespace workbook {

namespace fs = std::filesystem;

namespace {

/// Ends a command; the sentence says what to do.
struct CannotWrite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A type that contracts may use: how solutions/judging draws one, and a value that is surely not the answer.
struct ContractType {
  const char* name;
  const char* drawn;
  const char* placeholder;
};

constexpr std::array contract_types = {
    ContractType{"double", "random.uniform(1, 2)", "0"},
    ContractType{"int", "random.whole(1, 4)", "0"},
    ContractType{"Vector2d", "Vector2d(random.vector().head<2>())", "Vector2d::Zero()"},
    ContractType{"Vector3d", "random.vector()", "Vector3d::Zero()"},
    ContractType{"VectorXd", "random.masses(3)", "VectorXd::Zero(1)"},
    ContractType{"Matrix3d", "random.inertia_tensor()", "Matrix3d::Zero()"},
    ContractType{"Matrix3Xd", "random.points(3)", "Matrix3Xd::Zero(3, 1)"},
    ContractType{"std::vector<Matrix3d>", "std::vector{random.rotation(), random.rotation()}", "{}"}};

const ContractType& contract_type(const std::string& name) {
  const auto found = std::ranges::find(contract_types, name, &ContractType::name);
  if (found != contract_types.end()) return *found;
  std::string known;
  for (const ContractType& type : contract_types) known += (known.empty() ? "" : ", ") + std::string(type.name);
  throw CannotWrite(fmt::format("A contract cannot use the type '{}'; it may use {}.", name, known));
}

struct Parameter {
  const ContractType* type;
  std::string name;
};

/// A signature in its parts.
struct Signature {
  std::string text;
  const ContractType* result;
  std::vector<Parameter> parameters;
};

Signature parsed_signature(const std::string& text, const std::string& function) {
  static const std::regex whole(R"(\s*(\S+)\s+(\w+)\s*\((.*)\)\s*;?\s*)");
  static const std::regex one(R"(\s*(?:const\s+)?([\w:<>]+)\s*&?\s+(\w+)\s*)");
  std::smatch found;
  if (!std::regex_match(text, found, whole) || found[2] != function)
    throw CannotWrite(
        fmt::format("The signature should read like 'Vector3d {}(const Matrix3d& I, double t)'.", function));
  Signature signature{"", &contract_type(found[1]), {}};
  std::istringstream parameters(found[3]);
  std::string list;
  for (std::string parameter; std::getline(parameters, parameter, ',');) {
    std::smatch part;
    if (!std::regex_match(parameter, part, one))
      throw CannotWrite(fmt::format("'{}' is no parameter with a type and a name.", parameter));
    const ContractType& type = contract_type(part[1]);
    const bool by_value = type.name == std::string("double") || type.name == std::string("int");
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", by_value ? type.name : fmt::format("const {}&", type.name),
                        part[2].str());
    signature.parameters.push_back({&type, part[2]});
  }
  if (list.empty()) throw CannotWrite("An exercise needs at least one parameter.");
  signature.text = fmt::format("{} {}({})", signature.result->name, function, list);
  return signature;
}

std::string joined(const std::vector<Parameter>& parameters, const std::function<std::string(const Parameter&)>& part) {
  std::string text;
  for (const Parameter& parameter : parameters) text += (text.empty() ? "" : ", ") + part(parameter);
  return text;
}

std::string declaration_text(const Signature& signature) {
  std::string text = "/// TODO: what it computes, in one sentence.\n///\n";
  for (const Parameter& parameter : signature.parameters)
    text += fmt::format("/// @param {}  TODO: meaning, frame, unit\n", parameter.name);
  return text + fmt::format(
                    "/// @pre TODO: which inputs are legal; the degenerate ones by name\n"
                    "/// @return TODO: meaning, frame, unit\n{};\n\n",
                    signature.text);
}

std::string solution_text(const Signature& signature, const std::string& contract) {
  const std::string unnamed = std::regex_replace(signature.text, std::regex(R"( (\w+)(?=[,)]))"), " /*$1*/");
  return fmt::format(
      "#include \"rigid/{}.hpp\"\n\nnamespace rigid {{\n\n{} {{\n  return {};  // TODO: the solution\n}}\n\n"
      "}}  // namespace rigid\n",
      contract, unnamed, signature.result->placeholder);
}

std::string judging_text(const Signature& signature, const std::string& name, const std::string& contract) {
  const std::string quantities =
      joined(signature.parameters, [](const Parameter& each) { return fmt::format("{{\"{}\", none}}", each.name); });
  const std::string drawn =
      joined(signature.parameters, [](const Parameter& each) { return std::string(each.type->drawn); });
  return fmt::format(R"(#include "rigid/{0}.hpp"
#include "solutions/judging/judging.hpp"

void judge_{1}(workbook::judging::Lecture& lecture) {{
  using namespace workbook::judging;
  // TODO: the units in place of none.
  auto& e = lecture.exercise("{1}", &rigid::{1}, {{{2}}}, {{"result", none}});
  e.random("a random input", 10, [](Random& random) {{ return std::tuple{{{3}}}; }});
  e.scale(1.0);  // TODO: remove it; the size of the expected numbers will do in most cases
  // TODO: worked and special cases, three wrong answers, three routes, what every right result has, a sweep to plot.
}}
)",
                     contract, name, quantities, drawn);
}

constexpr const char* hints_text =
    "TODO: what to think of first.\n\n---\n\nTODO: the decisive step.\n\n---\n\nTODO: the formula, and how to write "
    "it.\n";

void write_new(const fs::path& file, const std::string& text) {
  const std::string problem = fs::exists(file) ? "it exists already" : write_file(file, text);
  if (!problem.empty()) throw CannotWrite(fmt::format("{} cannot be written: {}.", shown_path(file), problem));
  fmt::print("  {}\n", shown_path(file));
}

void replace_text(const fs::path& file, const std::string& text) {
  const std::string problem = write_file(file, text);
  if (!problem.empty()) throw CannotWrite(fmt::format("{} cannot be written: {}.", shown_path(file), problem));
  fmt::print("  {} (one entry more)\n", shown_path(file));
}

/// The card as it is laid out, with one exercise more at its end.
std::string card_with(const fs::path& file, const CardExercise& entry) {
  std::string card = read_file(file).value_or("");
  const std::size_t end = card.rfind(']');
  const std::size_t last = end == std::string::npos ? end : card.find_last_not_of(" \n", end - 1);
  if (last == std::string::npos) throw CannotWrite(shown_path(file) + " has no list of exercises at its end.");
  card.replace(
      last + 1, end - last - 1,
      fmt::format(
          "{}\n    {{ \"name\": \"{}\",\n      \"points\": {}, \"notes\": \"{}\",\n      \"task\": \"{}\" }}\n  ",
          card[last] == '[' ? "" : ",", entry.name, entry.points, entry.notes, entry.task));
  const auto exercises = nlohmann::json::parse(card).at("exercises");
  if (exercises.empty() || exercises.back().at("name") != entry.name)
    throw CannotWrite(shown_path(file) + ": the list of exercises should stand last.");
  return card;
}

/// The contract with one declaration more at its end.
std::string contract_with(const fs::path& file, const std::string& declaration) {
  std::string contract = read_file(file).value_or("");
  const std::size_t end = contract.rfind("\n}");
  if (end == std::string::npos) throw CannotWrite(shown_path(file) + " does not end its namespace.");
  contract.insert(end + 1, declaration);
  return contract;
}

/// "free_tops" as a title: "Free tops".
std::string as_title(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return capitalized(name);
}

template <class Write>
int report_written(const Write& write) {
  try {
    write();
    return all_passed;
  } catch (const CannotWrite& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return wrong_usage;
  } catch (const nlohmann::json::exception& problem) {
    fmt::print(stderr, "The card cannot be changed: {}\n", problem.what());
    return checker_failed;
  }
}

void write_lecture(const Course& course, const std::string& folder) {
  if (!course.has_solutions())
    throw CannotWrite("A copy that was handed out has no solutions; write lectures in the workbook.");
  if (!std::regex_match(folder, std::regex(R"(\d\d_[a-z][a-z0-9_]*)")))
    throw CannotWrite(fmt::format("'{}' should read NN_topic, two digits and a name in small letters.", folder));
  if (fs::exists(course.lectures() / folder)) throw CannotWrite(fmt::format("lectures/{} exists already.", folder));
  const std::string topic = folder.substr(3);
  const std::string number = folder.substr(0, 2);
  const nlohmann::ordered_json card = {{"title", as_title(topic)},
                                       {"summary", "TODO: the lecture in one sentence."},
                                       {"slides", nlohmann::json::array()},
                                       {"builds_on", nlohmann::json::array()},
                                       {"contract", topic},
                                       {"facts", nlohmann::json::array()},
                                       {"exercises", nlohmann::json::array()}};
  write_new(
      course.root() / "include/rigid" / (topic + ".hpp"),
      fmt::format("/// @file\n/// Contract of lecture {}: TODO.\n#pragma once\n\n#include \"rigid/vocabulary.hpp\"\n\n"
                  "namespace rigid {{\n\n}}  // namespace rigid\n",
                  number));
  const fs::path lecture = course.lectures() / folder;
  write_new(lecture / "card.json", card.dump(2) + "\n");
  write_new(lecture / "notes.md", fmt::format("# {0} {1} {{#lecture_{2}}}\n\n\\lecture_card{{{2}}}\n\n[TOC]\n\nTODO\n",
                                              number, as_title(topic), folder));
  write_new(
      lecture / "worked_examples.cpp",
      fmt::format("// Worked examples of lecture {}: each case computes its own numbers, and the notes quote it.\n"
                  "#include <doctest/doctest.h>\n\n#include <rigid/{}.hpp>\n",
                  number, topic));
  write_new(lecture / "figures.cpp",
            fmt::format("// Figures of lecture {}.\n#include \"lectures/support/figure.hpp\"\n\n"
                        "int main(int argc, char** argv) {{ return workbook::draw_figures(argc, argv, {{}}); }}\n",
                        number));
  fmt::print("Next: `{}`\n", command("new exercise NAME --lecture " + number + " --signature '...'"));
}

void write_exercise(const Course& course, const std::string& name, const std::string& lecture_name,
                    const std::string& signature_text) {
  if (!course.has_solutions())
    throw CannotWrite("A copy that was handed out has no solutions; write exercises in the workbook.");
  const Card& card = course.find_lecture(lecture_name);
  const Signature signature = parsed_signature(signature_text, name);
  const CardExercise entry{name, 1, card.contract + "_" + name, "TODO: what to write, in a line or two."};
  const Exercise exercise{&card, &entry};
  for (const Exercise& other : course.exercises()) {
    if (other.name() == name) throw CannotWrite(fmt::format("{} is an exercise of {} already.", name, other.lecture()));
  }
  const fs::path card_file = course.lectures() / card.lecture / "card.json";
  const std::string new_card = card_with(card_file, entry);
  const std::string new_contract = contract_with(course.contract_file(card), declaration_text(signature));
  const std::string notes = read_file(course.notes_file(card)).value_or("");
  write_new(course.student_file(exercise), stub_text(entry, card.contract, signature.text));
  write_new(course.hints_file(exercise), hints_text);
  write_new(course.solution_file(exercise), solution_text(signature, card.contract));
  write_new(course.judging_file(exercise), judging_text(signature, name, card.contract));
  replace_text(course.contract_file(card), new_contract);
  replace_text(course.notes_file(card),
               fmt::format("{}\n### {} {{#{}}}\n\nTODO\n", notes, as_title(name), entry.notes));
  replace_text(card_file, new_card);
  fmt::print("Replace what is marked TODO; `{}` says what is missing.\n", command("self-check " + name));
}

}  // namespace

int new_lecture(const Course& course, const std::string& folder) {
  return report_written([&] { write_lecture(course, folder); });
}

int new_exercise(const Course& course, const std::string& name, const std::string& lecture,
                 const std::string& signature) {
  return report_written([&] { write_exercise(course, name, lecture, signature); });
}

}  // namespace workbook
