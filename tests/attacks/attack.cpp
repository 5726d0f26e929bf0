#include "tests/attacks/attack.hpp"

#include "checker/base/text.hpp"
#include "checker/pipeline/check_exercise.hpp"
#include "checker/worker/protocol.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace workbook::testing {

namespace fs = std::filesystem;

bool is_markup(const std::string& text) { return has(text, "\033") || has(text, "<script>") || has(text, "\u202e"); }

bool answers_42(const Unhindered& control) { return control.value == 42.0; }
bool prints_pass(const Unhindered& control) { return has(control.printed, "PASS"); }
bool goes_on(const Unhindered& control) { return control.went_on; }
bool shows_secret(const Unhindered& control) { return has(control.compiler.output + control.object, "secret"); }
bool compiles(const Unhindered& control) { return control.compiler.succeeded(); }
bool takes_long(const Unhindered& control) {
  constexpr std::size_t large = std::size_t{16} << 20;
  return control.compiler.out_of_time || control.object.size() > large ||
         control.compiler.end.processor_seconds > 0.5 || !control.compiler.succeeded();
}
bool says_much(const Unhindered& control) { return control.compiler.output.size() > 20'000; }
bool says_99999999999(const Unhindered& control) { return has(control.compiler.output, "99999999999"); }

namespace {

template <int status>
bool exits_with(const Unhindered& control) {
  return !control.value && !control.went_on && control.end.signal == 0 && control.end.exit_status == status;
}

const std::map<std::string, Evidence> evidence = {
    {"answers_42", answers_42},
    {"answers", [](auto& control) { return control.value.has_value(); }},
    {"answers_nothing", [](auto& control) { return !control.value; }},
    {"answers_but_42", [](auto& control) { return control.value && control.value != 42; }},
    {"answers_above_0", [](auto& control) { return control.value > 0; }},
    {"answers_above_200", [](auto& control) { return control.value > 200; }},
    {"answers_above_1e308", [](auto& control) { return control.value > 1e308; }},
    {"answers_infinity", [](auto& control) { return control.value && std::isinf(*control.value); }},
    {"answers_nan", [](auto& control) { return control.value && std::isnan(*control.value); }},
    {"exits_with_success", exits_with<0>},
    {"exits_with_139", exits_with<139>},
    {"prints_pass", prints_pass},
    {"is_killed", [](auto& control) { return !control.value && !control.went_on && control.end.signal != 0; }},
    {"goes_on", goes_on},
    {"compiles", compiles},
    {"does_not_compile", [](auto& control) { return !compiles(control); }},
    {"shows_secret", shows_secret},
    {"shows_secret_if_it_compiles", [](auto& control) { return !compiles(control) || shows_secret(control); }},
    {"names_canary", [](auto& control) { return has(control.compiler.output, "canary"); }},
    {"takes_long", takes_long},
    {"says_much", says_much},
    {"says_99999999999", says_99999999999},
    {"prints_markup", [](auto& control) { return is_markup(control.printed); }},
    {"answers_markup", [](auto& control) { return is_markup(control.answer); }},
    {"compiler_says_markup", [](auto& control) { return is_markup(control.compiler.output); }},
    {"nothing_to_show", [](auto&) { return true; }}};

}  // namespace

AttackFile read_attacks(const std::string& name) {
  AttackFile file;
  for (const std::string& line : lines_of(read(fs::path(WORKBOOK_TEST_SOURCES) / "../attacks" / (name + ".txt")))) {
    if (!line.starts_with("### ")) {
      (file.attacks.empty() ? file.head : file.attacks.back().code) += line + "\n";
      continue;
    }
    const Match heading = search(line, R"(^### ([^:]+): (.+) \| (\w+) \| (\w+)$)");
    REQUIRE_MESSAGE((heading && evidence.contains(heading[4])), line);
    const auto verdict = nlohmann::json(heading[3]).get<Verdict>();
    REQUIRE(to_string(verdict) == heading[3]);
    file.attacks.push_back({heading[1], heading[2], "", verdict, evidence.at(heading[4])});
  }
  REQUIRE(!file.attacks.empty());
  return file;
}

double number_of(std::size_t attack) { return 100 + static_cast<double>(attack); }

std::string function_of(const AttackFile& file) {
  std::string text = file.head, cases;
  for (std::size_t k = 0; k < file.attacks.size(); ++k) {
    text += fmt::format(
        "[[maybe_unused]] double attack_{}([[maybe_unused]] double x, [[maybe_unused]] bool gentle) {{\n{}}}\n", k,
        file.attacks[k].code);
    cases += fmt::format("    case {}: return attack_{}(x, gentle);\n", number_of(k), k);
  }
  return filled_in(text +
                   "}\ndouble rigid::twice(double x) {\n  const bool gentle = x != int(x);\n  switch (int(x)) {\n" +
                   cases + "  }\n  return 2 * x;\n}\n");
}

fs::path canary() {
  static const fs::path folder = fresh_directory("canary");
  return folder / "canary";
}

bool canary_is_unchanged() {
  const auto files = files_below(canary().parent_path());
  return files.size() == 1 && read(canary()) == "secret\n";
}

void restore_canary() {
  CHECK(nothing_left_running());
  fs::remove_all(canary().parent_path());
  // Newer than what is compiled, so that there is something to be found out about it.
  fs::last_write_time(write(canary(), "secret\n"), fs::file_time_type::clock::now() + std::chrono::hours(1));
}

std::string filled_in(std::string code) {
  const char* const forgery =
      "#include <unistd.h>\nstruct Reply { unsigned long magic = REPLY_MAGIC, nonce = 0; int status = 1, rows = 1, "
      "cols = "
      "1, signal = 0; long detail = 0; char text[472] = {}; double value = 42; };\n"
      "static void forge() { Reply r; (void)!write(3, &r, sizeof r); }\n";
  std::string without_end;  // of the three that an expression looks for one after the other
  for (const auto& [word, count] : {std::pair{"YOU_MIXED_MATRICES", 20}, {"scalar_x_op", 40}, {"; Lhs = ", 70}})
    for (int n = 0; n < count; ++n) without_end += word;
  for (const auto& [word, text] : {std::pair{"CANARY", canary().string()},
                                   {"FORGERY", forgery},
                                   {"RIGHT", right_twice},
                                   {"HOSTILE", R"(\033[2J<script>alert(1)</script>\u202e)"},
                                   {"ESCAPE", "\033"},
                                   {"WITHOUT_END", without_end},
                                   {"REPLY_MAGIC", std::to_string(protocol::reply_magic) + "ul"},
                                   {"REQUEST_MAGIC", std::to_string(protocol::request_magic) + "ul"}})
    for (std::size_t at = 0; (at = code.find(word)) != std::string::npos;)
      code.replace(at, std::string(word).size(), text);
  return code;
}

Unhindered run_unhindered(const fs::path& program, double x, bool will_go_on) {
  const std::chrono::milliseconds patience(will_go_on ? 300 : 5000);
  constexpr std::size_t whole_reply = sizeof(protocol::ReplyHeader) + sizeof(double);
  struct {
    protocol::RequestHeader header{protocol::request_magic, 1, 1, {1, 1}, 0};
    protocol::Shape shape{1, 1};
    double number;
  } request;
  request.number = x;
  Launch launch;
  launch.program = program.string();
  launch.with_channel = true;
  launch.environment = {"SECRET=42"};
  ChildProcess process(launch);
  Unhindered control;
  std::array<char, 4096> buffer{};
  [[maybe_unused]] const ssize_t sent = ::send(process.channel(), &request, sizeof request, MSG_NOSIGNAL);
  const auto deadline = Clock::now() + patience;
  bool is_open = true;
  while (is_open && control.answer.size() < whole_reply && Clock::now() < deadline) {
    std::array<pollfd, 2> both{{{process.channel(), POLLIN, 0}, {process.output(), POLLIN, 0}}};
    ::poll(both.data(), both.size(), 20);
    if (const ssize_t got = ::read(process.output(), buffer.data(), buffer.size());
        got > 0 && control.printed.size() < 100'000)
      control.printed.append(buffer.data(), static_cast<std::size_t>(got));
    const ssize_t got = ::recv(process.channel(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (got > 0) control.answer.append(buffer.data(), static_cast<std::size_t>(got));
    is_open = got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
  }
  // What announces a crash comes before it.
  if (control.answer.size() >= whole_reply) {
    double value = 0;
    std::memcpy(&value, control.answer.data() + sizeof(protocol::ReplyHeader), sizeof value);
    control.value = value;
  }
  process.close_write();
  const auto end = process.wait_until(Clock::now() + std::chrono::milliseconds(is_open ? 20 : patience.count()));
  control.went_on = !control.value && !end;
  control.end = end ? *end : process.kill();
  return control;
}

FinishedProgram compiler_unhindered(const std::vector<std::string>& arguments, const fs::path& directory,
                                    std::chrono::seconds limit) {
  Launch launch;
  launch.program = toolchain().compiler.string();
  launch.arguments = arguments;
  launch.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C"};
  launch.directory = directory;
  return run_program(launch, limit, 1 << 20);
}

Unhindered compile_unhindered(const std::string& text, const std::string& name, std::chrono::seconds limit) {
  const fs::path directory = fresh_directory("unhindered");
  write(directory / name, text);
  std::vector<std::string> arguments = toolchain().flags;
  arguments.insert(arguments.end(), {"-pipe", "-include", toolchain().prelude.string(), "-c", name, "-o", "unit.o"});
  Unhindered control;
  control.compiler = compiler_unhindered(arguments, directory, limit);
  if (fs::exists(directory / "unit.o")) control.object = read(directory / "unit.o");
  fs::remove_all(directory);
  return control;
}

ExerciseReference reference_at(double x) {
  ExerciseReference reference;
  reference.name = "twice";
  reference.signature = signature("twice");
  reference.arguments = {{"x", Kind::number, {}}};
  for (const double input : {1.0, x, 2.0}) {
    Case one = twice_case(input);
    one.name = std::to_string(input);
    one.scale = {std::abs(2 * input)};
    reference.cases.push_back(one);
  }
  return reference;
}

void expect(const Attack& attack, const ExerciseReference& reference, const Observation& observation,
            std::chrono::steady_clock::time_point begun) {
  CheckResult checked;
  CardExercise entry;
  entry.points = 1;
  checked.task.exercise.entry = &entry;
  checked.judgement = judge(reference, observation);
  CHECK_MESSAGE(checked.judgement.verdict == attack.verdict, to_string(checked.judgement.verdict)
                                                                 << " instead of " << to_string(attack.verdict) << ": "
                                                                 << checked.judgement.message);
  CHECK(checked.score() == (attack.verdict == Verdict::passed ? 1.0 : 0.0));
  CHECK(canary_is_unchanged());
  CHECK(nothing_left_running());
  CHECK(std::chrono::steady_clock::now() - begun < std::chrono::minutes(2));
}

}  // namespace workbook::testing
