#include "checker/data/reference_results.hpp"

#include "checker/data/reference_json.hpp"
#include "checker/data/reference_names.hpp"
#include "checker/data/strict_json.hpp"
#include "checker/messages/reference_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace workbook {

namespace {

ReferenceError error_at(const std::filesystem::path& file, const std::string& place, const std::string& reason) {
  return ReferenceError(messages::at_place_in_file(file.string(), place, reason));
}

std::string whole_text(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(file, ignored))
    throw error_at(file, messages::whole_file(), messages::cannot_be_read());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// "line 12, column 3" of the byte at which the parser gave up.
std::string place_of_byte(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, byte == 0 ? 0 : std::min(byte - 1, text.size()));
  const auto line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
  const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
  return messages::line_and_column(line, before.size() - line_start + 1);
}

nlohmann::json document_in(const std::filesystem::path& file) {
  const std::string text = whole_text(file);
  try {
    return parse_strictly(text);
  } catch (const nlohmann::json::parse_error& error) {
    const bool ends_too_early = error.byte > text.size();
    throw error_at(file, place_of_byte(text, error.byte),
                   ends_too_early ? messages::ends_too_early() : messages::is_not_json());
  } catch (const RepeatedKey& error) {
    throw ReferenceError(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const nlohmann::json::exception&) {
    throw error_at(file, messages::whole_file(), messages::holds_too_large_a_number());
  }
}

}  // namespace

std::string to_string(PropertyKind kind) { return name_of(kind, property_names); }

const ExerciseReference& LectureReference::exercise(const std::string& name) const {
  const auto found = std::ranges::find(exercises, name, &ExerciseReference::name);
  if (found == exercises.end()) {
    throw ReferenceError(messages::no_results_of(lecture, name));
  }
  return *found;
}

LectureReference read_reference_results(const std::filesystem::path& file) {
  const nlohmann::json document = document_in(file);
  try {
    return lecture_from_json(JsonPlace(document));
  } catch (const MisplacedJson& error) {
    throw ReferenceError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void write_reference_results(const LectureReference& results, const std::filesystem::path& file) {
  const std::string text = readable_text(lecture_to_json(results));
  std::filesystem::path unfinished = file;
  unfinished += fmt::format(".{}.unfinished", ::getpid());

  std::ofstream stream(unfinished, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failure;
  if (stream) std::filesystem::rename(unfinished, file, failure);
  if (!stream || failure) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw error_at(file, messages::whole_file(), messages::cannot_be_written());
  }
}

}  // namespace workbook
