#include "lectures/site/slides.hpp"

#include "checker/data/strict_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

namespace workbook::site {

namespace {

struct Deck {
  const char* label;
  const char* title;
};

constexpr Deck decks[] = {{"S0", "Fall 2014, lecture 24"},
                          {"S1", "Fall 2014, lecture 25"},
                          {"S2", "Fall 2018, lecture 23"},
                          {"S3", "9 October 2017, lecture 17"},
                          {"S4", "23 October 2019, lecture 23"}};

std::string row(const std::string& slides, const Fact& fact, const std::map<int, Paragraph>& paragraphs) {
  const Paragraph& paragraph = paragraphs.at(fact.number);
  std::string exercises;
  for (const std::string& name : fact.exercises)
    exercises += fmt::format("{}\\ref exercise_{} \"{}\"", exercises.empty() ? "" : ", ", name, name);
  return fmt::format("| {} | {} | \\ref {} | {} | {} |\n", slides, fact.text, paragraph.anchor,
                     fmt::join(paragraph.worked_examples, "; "), exercises);
}

constexpr const char* table_head = "| slide | fact | paragraph | worked example | exercise |\n|---|---|---|---|---|\n";

}  // namespace

std::vector<Fact> read_facts(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: the list of facts is missing.", file.string()));
  try {
    std::vector<Fact> facts;
    for (const auto& entry : parse_strictly(std::string(std::istreambuf_iterator<char>(in), {}))) {
      facts.push_back({entry.at("number").get<int>(), entry.at("fact").get<std::string>(),
                       entry.at("where").get<std::map<std::string, std::string>>(),
                       entry.at("exercises").get<std::vector<std::string>>()});
    }
    return facts;
  } catch (const nlohmann::json::exception& problem) {
    throw std::runtime_error(fmt::format("{}: not a list of facts: {}", file.string(), problem.what()));
  } catch (const RepeatedKey& problem) {
    throw std::runtime_error(fmt::format("{}: {}.", file.string(), problem.what()));
  }
}

std::map<int, Paragraph> paragraphs_of(const std::string& lecture, const std::string& notes) {
  std::map<int, Paragraph> found;
  const std::regex mark(R"(<!-- fact (\d+) -->)");
  const std::regex heading(R"((?:^|\n)#+ [^\n]*\{#(\w+)\})");
  const std::regex snippet(R"(\\snippet \S+ ([^\n]+))");
  for (std::sregex_iterator match(notes.begin(), notes.end(), mark), end; match != end; ++match) {
    const std::string rest = match->suffix().str();
    std::smatch title;
    if (!std::regex_search(rest, title, heading)) continue;
    const std::string body = title.suffix().str();
    std::smatch next;
    const std::string text = std::regex_search(body, next, std::regex(R"(\n#+ )")) ? next.prefix().str() : body;
    Paragraph paragraph{lecture, title[1], {}};
    for (std::sregex_iterator quote(text.begin(), text.end(), snippet); quote != end; ++quote)
      paragraph.worked_examples.push_back((*quote)[1]);
    found[std::stoi((*match)[1])] = paragraph;
  }
  return found;
}

std::vector<std::string> faults_of_coverage(const std::vector<Fact>& facts, const std::map<int, Paragraph>& paragraphs,
                                            const std::vector<Card>& course) {
  std::set<std::string> known;
  for (const Card& card : course) {
    for (const CardExercise& exercise : card.exercises) known.insert(exercise.name);
  }
  std::vector<std::string> faults;
  const auto complain = [&](const Fact& fact, const std::string& what) {
    faults.push_back(fmt::format("fact {} ({}): {}", fact.number, fact.text, what));
  };
  for (const Fact& fact : facts) {
    const auto paragraph = paragraphs.find(fact.number);
    if (paragraph == paragraphs.end()) {
      complain(fact, fmt::format("no paragraph of the notes has `<!-- fact {} -->` before a heading with an anchor.",
                                 fact.number));
    } else if (paragraph->second.worked_examples.empty()) {
      complain(fact, fmt::format("its paragraph {} of {} quotes no worked example.", paragraph->second.anchor,
                                 paragraph->second.lecture));
    }
    if (fact.exercises.empty()) complain(fact, "no exercise practises it.");
    for (const std::string& exercise : fact.exercises) {
      if (!known.contains(exercise)) complain(fact, fmt::format("its exercise '{}' is on no card.", exercise));
    }
  }
  return faults;
}

std::string slides_page(const std::vector<Fact>& facts, const std::map<int, Paragraph>& paragraphs) {
  std::string page =
      "# From the slides to the workbook {#from_the_slides}\n\n"
      "Where each fact of the five decks is explained, computed and practised. The decks are listed under "
      "\\ref references; where they slip, \\ref errata says so.\n\n";
  for (const Deck& deck : decks) {
    page += fmt::format("## {}: {} {{#from_the_slides_{}}}\n\n{}", deck.label, deck.title, deck.label, table_head);
    for (const Fact& fact : facts) {
      const auto slides = fact.where.find(deck.label);
      if (slides != fact.where.end()) page += row(slides->second, fact, paragraphs);
    }
    page += "\n";
  }
  page += fmt::format("## Added {{#from_the_slides_added}}\n\n{}", table_head);
  for (const Fact& fact : facts) {
    if (fact.where.empty()) page += row("–", fact, paragraphs);
  }
  return page;
}

std::string errata_of(const std::string& notes) {
  std::smatch heading;
  if (!std::regex_search(notes, heading, std::regex(R"(\n## Where the slides need care[^\n]*\n)"))) return "";
  const std::string rest = heading.suffix();
  return rest.substr(0, rest.find("\n## "));
}

std::string errata_page(const std::vector<Card>& course, const std::vector<std::string>& notes) {
  std::string page =
      "# Errata of the slides {#errata}\n\n"
      "Slips, gaps and traps of the five decks, lecture by lecture. The one that changes a result is the sign of "
      "\\f$ \\tilde\\omega_2 \\f$ when both rates of the asymmetric top are negative (\\ref free_tops_sign).\n\n";
  for (std::size_t lecture = 0; lecture < course.size(); ++lecture) {
    const std::string errata = errata_of(notes.at(lecture));
    if (!errata.empty())
      page += fmt::format("## {} {{#errata_{}}}\n{}\n", course[lecture].title, course[lecture].lecture, errata);
  }
  return page;
}

}  // namespace workbook::site
