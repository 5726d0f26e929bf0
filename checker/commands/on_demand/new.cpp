/// @file
/// Skeletons for authors: what is written here builds at once, and `self-check` names what remains to be done.
#include "checker/commands/on_demand/options.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <sstream>

namespace workbook {

namespace {

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

ContractType contract_type(const std::string& name) {
  const auto found = std::ranges::find(contract_types, name, &ContractType::name);
  if (found != contract_types.end()) return *found;
  std::string known;
  for (const ContractType& type : contract_types) known += (known.empty() ? "" : ", ") + std::string(type.name);
  throw UsageError(fmt::format("A contract cannot use the type '{}'; it may use {}.", name, known));
}

/// What follows from a signature; lists without their brackets.
struct Signature {
  std::string text;
  std::string placeholder;  ///< a result
  std::string unnamed;      ///< the parameters with their names as comments
  std::string described;    ///< a line of documentation for each
  std::string quantities;   ///< their names for the judge
  std::string drawn;        ///< random values for them
};

Signature parsed_signature(const std::string& text, const std::string& function) {
  const Match found = search(text, R"(^\s*(\S+)\s+(\w+)\s*\((.*)\)\s*;?\s*$)");
  if (!found || found[2] != function)
    throw UsageError(
        fmt::format("The signature should read like 'Vector3d {}(const Matrix3d& I, double t)'.", function));
  Signature signature;
  std::istringstream parameters(found[3]);
  std::string list;
  for (std::string parameter; std::getline(parameters, parameter, ',');) {
    const Match part = search(parameter, R"(^\s*(?:const\s+)?([\w:<>]+)\s*&?\s+(\w+)\s*$)");
    if (!part) throw UsageError(fmt::format("'{}' is no parameter with a type and a name.", parameter));
    const ContractType type = contract_type(part[1]);
    const std::string name = part[2];
    const bool by_value = type.name == std::string("double") || type.name == std::string("int");
    const std::string passed = by_value ? type.name : fmt::format("const {}&", type.name);
    const char* const comma = list.empty() ? "" : ", ";
    list += fmt::format("{}{} {}", comma, passed, name);
    signature.unnamed += fmt::format("{}{} /*{}*/", comma, passed, name);
    signature.described += fmt::format("/// @param {}  TODO: meaning, frame, unit\n", name);
    signature.quantities += fmt::format("{}{{\"{}\", none}}", comma, name);
    signature.drawn += comma + std::string(type.drawn);
  }
  if (list.empty()) throw UsageError("An exercise needs at least one parameter.");
  const ContractType result = contract_type(found[1]);
  signature.placeholder = result.placeholder;
  signature.text = fmt::format("{} {}({})", result.name, function, list);
  signature.unnamed = fmt::format("{} {}({})", result.name, function, signature.unnamed);
  return signature;
}

void write(const fs::path& file, const std::string& text, bool is_new = true) {
  const std::string problem = is_new && fs::exists(file) ? "it exists already" : write_file(file, text);
  if (!problem.empty()) throw UsageError(fmt::format("{} cannot be written: {}.", shown_path(file), problem));
  fmt::print("  {}{}\n", shown_path(file), is_new ? "" : " (one entry more)");
}

/// The card as it is laid out, with one exercise more at its end.
std::string card_with(const fs::path& file, std::string entry, const std::string& name) {
  std::string card = read_file(file).value_or("");
  const std::size_t end = card.rfind(']');
  const std::size_t last = end == std::string::npos ? end : card.find_last_not_of(" \n", end - 1);
  if (last == std::string::npos) throw UsageError(shown_path(file) + " has no list of exercises at its end.");
  card.replace(last + 1, end - last - 1, card[last] == '[' ? entry.substr(1) : entry);
  const auto exercises = nlohmann::json::parse(card).at("exercises");
  if (exercises.empty() || exercises.back().at("name") != name)
    throw UsageError(shown_path(file) + ": the list of exercises should stand last.");
  return card;
}

/// "free_tops" as a title: "Free tops".
std::string as_title(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return capitalized(name);
}

void require_solutions(const Course& course) {
  if (!course.has_solutions())
    throw UsageError("A copy that was handed out has no solutions; write lectures and exercises in the workbook.");
}

}  // namespace

int new_lecture(const Course& course, const NewOptions& options) {
  const std::string& folder = options.name;
  require_solutions(course);
  if (!search(folder, R"(^\d\d_[a-z][a-z0-9_]*$)"))
    throw UsageError(fmt::format("'{}' should read NN_topic, two digits and a name in small letters.", folder));
  const fs::path lecture = course.lectures() / folder;
  if (fs::exists(lecture)) throw UsageError(fmt::format("lectures/{} exists already.", folder));
  const std::string topic = folder.substr(3);
  const std::string number = folder.substr(0, 2);
  const auto from = [&](const std::string& part) {
    return from_skeleton("lecture/" + part,
                         {{"NUMBER", number}, {"TITLE", as_title(topic)}, {"TOPIC", topic}, {"FOLDER", folder}});
  };
  write(course.root() / "include/rigid" / (topic + ".hpp"), from("contract.hpp"));
  for (const char* part : {"card.json", "notes.md", "worked_examples.cpp", "figures.cpp"})
    write(lecture / part, from(part));
  fmt::print("Next: `{}`\n", command("new exercise NAME --lecture " + number + " --signature '...'"));
  return all_passed;
}

int new_exercise(const Course& course, const NewOptions& options) {
  require_solutions(course);
  const std::string& name = options.name;
  const Card& card = course.find_lecture(options.lecture);
  const Signature signature = parsed_signature(options.signature, name);
  const CardExercise entry{name, 1, card.contract + "_" + name, ""};
  const Exercise exercise{&card, &entry};
  for (const Exercise& other : course.exercises())
    if (other.name() == name) throw UsageError(fmt::format("{} is an exercise of {} already.", name, other.lecture()));
  const auto from = [&](const std::string& part) {
    return from_skeleton("exercise/" + part, {{"NAME", name},
                                              {"TITLE", as_title(name)},
                                              {"ANCHOR", entry.notes},
                                              {"CONTRACT", card.contract},
                                              {"SIGNATURE", signature.text},
                                              {"PARAMETERS", signature.described},
                                              {"UNNAMED", signature.unnamed},
                                              {"PLACEHOLDER", signature.placeholder},
                                              {"QUANTITIES", signature.quantities},
                                              {"DRAWN", signature.drawn}});
  };
  const fs::path card_file = course.lectures() / card.lecture / "card.json";
  const std::string new_card = card_with(card_file, from("card.json"), name);
  const fs::path contract_file = course.contract_file(card);
  std::string contract = read_file(contract_file).value_or("");
  const std::size_t end = contract.rfind("\n}");
  if (end == std::string::npos) throw UsageError(shown_path(contract_file) + " does not end its namespace.");
  contract.insert(end + 1, from("contract.hpp"));
  const fs::path notes_file = course.notes_file(card);
  std::string notes = read_file(notes_file).value_or("");
  // What ends a lecture stays there: its questions, and the list of slides after them.
  const std::size_t questions = notes.find("\n## Questions {#");
  notes.insert(questions == std::string::npos ? notes.size() : questions, from("notes.md"));
  write(course.student_file(exercise), stub_text(exercise, signature.text));
  write(course.hints_file(exercise), from("hints.md"));
  write(course.solution_file(exercise), from("solution.cpp"));
  write(course.judging_file(exercise), from("judging.cpp"));
  write(course.derivation_file(exercise), from("derivation.md"));
  write(contract_file, contract, false);
  write(notes_file, notes, false);
  write(card_file, new_card, false);
  fmt::print("Replace what is marked TODO; `{}` says what is missing.\n", command("self-check " + name));
  return all_passed;
}

}  // namespace workbook
