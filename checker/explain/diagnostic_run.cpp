#include "checker/explain/diagnostic_run.hpp"

#include "checker/base/text.hpp"
#include "checker/compile/compile.hpp"
#include "checker/explain/explainers.hpp"
#include "checker/judging/run_failures.hpp"
#include "checker/sandbox/worker_process.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <set>

namespace workbook {
namespace {

struct KnownEvent {
  const char* pattern = "";   ///< of its text
  const char* name = "";      ///< of the finding
  const char* sentence = "";  ///< with $1, $2 for what the pattern finds
  bool undefined = false;     ///< the language leaves undefined what follows: wrong by itself, however the call ends
  Weight weight = Weight::cause;
  const char* code = "";  ///< of the line in which it happened, with %1 for what it finds; empty: any
};

/// The first that fits counts.
// clang-format off
constexpr KnownEvent known_events[] = {
    {"(heap|stack|global|dynamic-stack)-buffer-(over|under)flow.*", "memory_out_of_bounds", "memory outside of an array or object is used here: an index before its beginning or beyond its end.", true},
    {"(heap|stack)-use-after-.*", "use_after_end", "something is used here that is gone already: a reference, a pointer or an expression kept with auto has outlived it.", true},
    {"(attempting|alloc-dealloc-mismatch).*", "freed_wrongly", "memory is freed here that was freed before, or that did not come from such a new.", true},
    {"invalid-shift-.*", "invalid_shift", "the bits of a number cannot be shifted so far (a power is written with std::pow).", true},
    {"integer-divide-by-zero.*", "integer_division_by_zero", "a whole number is divided by zero.", true},
    {"float-cast-overflow.*", "conversion_out_of_range", "a number that no whole number of this type can hold (too large, infinite or NaN) is converted to one.", true},
    {"missing-return.*", "missing_return", "this function comes to its end without a return.", true, Weight::symptom},
    {"signed-integer-overflow\\|.*: (.*) cannot be represented in type '(.*)'.*", "integer_overflow", "$1 does not fit into the type $2; calculate in double.", true},
    {"out-of-bounds-index\\|.*index (-?\\d+) out of bounds for type '.*\\[(\\d+)\\]'.*", "index_out_of_range", "index $1 is outside the array of size $2; indices start at 0.", true},
    {"library\\|__\\w+ < (this->)?size\\(\\)", "index_out_of_range", "an index lies outside its container: the indices are 0 to n - 1 for a size n, and a container made without a size has size 0."},
    {"exception\\|(\\w+)::.*\\(which is (\\d+)\\) >= .*\\(which is (\\d+)\\).*", "index_out_of_range", "index $2 is outside the $1 of size $3; indices start at 0."},
    {"eigen\\|\\(i>=0\\).*", "index_out_of_range", "there is no `%1.%2(%3)`: `%1` has those from 0 to %1.%2s() - 1, and none before it is given a size (%1.size() counts all entries).", false, Weight::cause, "^(?!.*\\.(?:row|col)\\(.*\\.(?:row|col)\\().*\\b(\\w+)\\.(row|col)\\(([^()]*)\\)"},
    {"eigen\\|.*(?:invalid matrix product|actually allow|rows\\(\\) ?== ?\\w+\\.rows).*", "size_mismatch", "the sizes of two operands do not fit here: `%1(i, n)` takes n entries from the index i on; the second number is no index.", false, Weight::cause, "\\.(segment|middleCols|middleRows)\\([^(),]*,[^(),]*\\)"},
    {"eigen\\|startRow >= 0.*", "index_out_of_range", "`%1(i, n)` takes n entries from the index i on, and these reach beyond the end: the second number is no index.", false, Weight::cause, "\\.(segment|middleCols|middleRows)\\([^(),]*,[^(),]*\\)"},
    {"eigen\\|.*RowsAtCompileTime.*", "size_mismatch", "`%2.row(...)` has as many entries as `%2` has columns, which need not be those of a %1: a column is `%2.col(...)`.", false, Weight::cause, "(Vector\\w+)\\s+\\w+\\s*=\\s*(\\w+)\\.row\\("},
    {"exception\\|(.+)", "exception", "the exception “$1” is thrown here."},
    {"exception\\|", "exception", "the exception is thrown here."},
    {"uncaught\\|(.*)", "exception_not_caught", "the exception “$1” is thrown here and cannot be caught on its way out: it meets a destructor or noexcept."},
    {"library\\|.*empty\\(\\).*", "empty_container", "an empty container has no first or last element to give."},
    {"library\\|(.*)", "library_assertion", "the standard library asks for something that does not hold: “$1”."},
    {"assertion\\|(.*)", "assertion_failed", "your assertion “$1” does not hold here."},
    {"recursion", "endless_recursion", "the function calls itself here again and again, until the stack is used up."},
    {"stack-overflow.*", "stack_overflow", "the stack is used up here; a local array may be too large."},
    {"(memory|allocation-size-too-big|out-of-memory).*", "out_of_memory", "more memory is asked for here than an exercise may use."},
    {"SEGV\\|0x0*[0-9a-f]{1,3}", "null_pointer", "a pointer or reference to nothing is used here."},
    {"(SEGV|BUS).*", "memory_out_of_bounds", "memory is used here that does not belong to the function: an index beyond an end, or something that is gone."},
    {"ABRT.*", "aborted", "the program is aborted here."},
    {"exit", "exit", "the program is ended here; a function hands its result back with return."},
    {"forbidden\\|(.*)", "forbidden_operation", "here the function tries to $1."},
    {"FPE\\|division", "division_by_zero", "a division by zero gives no finite number here."},
    {"FPE\\|sqrt", "outside_domain", "the root of a negative number is not a number (NaN)."},
    {"FPE\\|a(cos|sin)", "outside_domain", "a$1 is only defined from −1 to 1: of a number beyond, even by rounding, it gives NaN."},
    {"FPE\\|log(2|10)?", "outside_domain", "the logarithm of 0 or of a negative number is infinite or not a number (NaN)."},
    {"FPE\\|pow", "outside_domain", "pow has no finite result here: look at a negative base with a fractional exponent, and at 0 to a negative one."},
    {"FPE\\|exp", "outside_domain", "exp of so large a number is infinite."},
    {"FPE\\|(sin|cos|tan|atan2?|tanh|hypot)", "non_finite", "an operation here, such as 0 divided by 0, has no finite result."},
    {"FPE\\|(.+)", "outside_domain", "$1 is given a number here for which it has no finite result."},
    {"FPE\\|", "non_finite", "an operation here gives or meets a value that is infinite or not a number (NaN)."},
    {"never_set here\\|(.+)", "never_set", "`$1`, or a part of it, has no value yet where it is used here: give it one where it is declared."},
    {"never_set here", "never_set", "something is used here that was never given a value: a variable, or an entry of a matrix or vector."},
    {"never_set\\|(.+)", "never_set", "`$1` gets no value here, and not all of it is set before it is used."},
    {"never_set", "never_set", "The result depends on something that was never given a value: a variable without = or {}, or a matrix or vector that is not filled."},
    {"growing\\|(\\d+)\\|\\1", "out_of_memory", "here the function was still at work when its memory was used up.", false, Weight::symptom},
    {"growing\\|(\\d+)\\|(\\d+)", "out_of_memory", "in lines $1 to $2 the function was still at work when its memory was used up.", false, Weight::symptom},
    {"printing\\|.*", "endless_printing", "the function was still printing here when it was stopped."},
    {"running\\|(\\d+)\\|\\1", "endless_loop", "the function was still at work here when it was stopped.", false, Weight::symptom},
    {"running\\|(\\d+)\\|(\\d+)", "endless_loop", "the function was still at work in lines $1 to $2 when it was stopped.", false, Weight::symptom},
};
// clang-format on

std::tuple<KnownEvent, Match, Match> known(const std::string& text, const std::string& line = "") {
  for (const KnownEvent& event : known_events)
    if (const Match found = search(text, fmt::format("^(?:{})$", event.pattern)))
      if (const Match code = search(line, event.code)) return {event, found, code};
  return {};
}

bool is_undefined_behavior(const DiagnosticEvent& event) { return std::get<KnownEvent>(known(event.text)).undefined; }

/// The line from which the student's function calls itself, if the chain of calls shows that it does so without end.
int recursion_line(const DiagnosticEvent& event) {
  constexpr int surely_without_end = 40;
  const auto found = std::ranges::find_if(
      event.lines, [&](int line) { return std::ranges::count(event.lines, line) >= surely_without_end; });
  return event.is("stack-overflow") && found != event.lines.end() ? *found : 0;
}

/// A variable that is declared without a value.
struct Unset {
  int line = 0;  ///< of its declaration
  std::string name;
  bool is_given_one = false;  ///< somewhere, or a part of it
};

std::vector<Unset> variables_without_value(const std::vector<std::string>& lines) {
  constexpr const char* declaration =
      R"((?:^|[;{}])\s*(?:Eigen::)?(double|float|Matrix\w+|Vector\w+|Array\w+|Quaternion\w+|std::array<[^;]*>)\s+)"
      R"(((?:[^;(){}]|\([^();]*(?:\(\)[^();]*)?\))*);)";
  // In parentheses behind the name stand sizes, or values.
  constexpr const char* name = R"((?:^|,)\s*(\w+)\s*(?:\[\w*\]|(\([^()]*(?:\(\)[^()]*)?\)))?\s*(?=,|$))";
  std::vector<Unset> found;
  std::string text;
  for (const std::string& line : lines) text += cut(line, 300) + "\n";
  const SourceText source(text);
  const auto is_member = [&](int line) {
    const auto at = std::ranges::lower_bound(source.tokens(), source.offset_of({line, 1}), {}, &Token::offset);
    const std::size_t open = source.opening_around(static_cast<std::size_t>(at - source.tokens().begin()));
    return open > 1 && (source.tokens()[open - 2].text == "struct" || source.tokens()[open - 2].text == "class");
  };
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (const Match& declared : search_all(cut(lines[k], 300), declaration))
      for (const Match& each : search_all(declared[2], name))
        if ((each[2].empty() || declared[1].find('X') != std::string::npos) && !is_member(static_cast<int>(k) + 1))
          found.push_back({static_cast<int>(k) + 1, each[1],
                           bool{search(text, fmt::format(R"(\b{}\s*(?:[\[(.][^;=]*)?(?:=(?!=)|<<))", each[1]))}});
  return found;
}

/// One call in a process of its own.
struct Run {
  Reply reply;
  std::vector<DiagnosticEvent> events;

  bool returned() const { return reply.ending == Ending::returned; }
  bool is_harmless() const { return std::ranges::none_of(events, is_undefined_behavior); }
  /// Where the floating-point unit stopped the call; 0: it did not.
  int trap_line() const { return events.empty() || !events.back().is("FPE") ? 0 : events.back().line(); }

  /// Did the call end in the same way, bit by bit?
  bool operator==(const Run& other) const {
    const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
    return reply.ending == other.reply.ending && reply.value.has_shape_of(other.reply.value) &&
           std::ranges::equal(reply.value.numbers, other.reply.value.numbers, {}, bits, bits);
  }
};

class DiagnosticRun {
 public:
  DiagnosticRun(const DiagnosticTask& task, std::size_t case_index, const std::filesystem::path& program,
                const std::filesystem::path& compiler)
      : verdict_(task.judgement.verdict),
        program_(program),
        profile_(diagnose_profile(compiler.string(), program.string())),
        file_name_(task.submission.path.filename().string()),
        source_(lines_of(task.submission.text)),
        case_(task.reference.cases.at(case_index)),
        judged_(task.observation.replies.at(case_index)) {}

  /// Of one line the first finding is the cause, and the others follow from it.
  std::vector<Reason> findings() {
    if (verdict_ == Verdict::time_limit || verdict_ == Verdict::output_limit)
      explain_long_run();
    else if (judged_.ending == Ending::returned)
      explain_value();
    else
      explain_ending();
    if (verdict_ == Verdict::memory_limit && findings_.empty()) explain_long_run();
    return std::move(findings_);
  }

 private:
  Run run(std::int32_t mode) const {
    Budget budget{Clock::now() + std::chrono::duration_cast<Clock::duration>(limits::diagnostic_run_time),
                  limits::diagnostic_run_processor_time.count(), limits::diagnostic_output};
    Worker worker(program_, profile_, budget);
    Run result;
    result.reply = worker.call({case_.inputs, case_.expected.rows, case_.expected.cols}, mode);
    result.events = read_report(result.reply.printed, file_name_);
    return result;
  }

  std::string source_line(int line) const {
    const auto index = static_cast<std::size_t>(line) - 1;  // of 0 beyond all lines
    return index < source_.size() ? cut(printable(source_[index]), 1000) : "";
  }

  /// Does the line name an index by a number, and the file none as 0 but one as 1?
  bool counts_from_one(int line) const {
    const std::string all = cut(fmt::format("{}", fmt::join(source_, "\n")), 20000);
    const std::string of_variable = R"(\b(?!\w*(?:Vector|Matrix|Quaternion))\w+)";
    return search(source_line(line), of_variable + R"([(\[](?:\w+,)? ?[1-9][,)\]])") &&
           search(all, of_variable + R"([(\[]1[,)\]])") && !search(all, R"(\w[(\[]0[,)\]]|, ?0[)\]])");
  }

  void add(int line, const std::string& name, const std::string& sentence, Weight weight = Weight::cause) {
    constexpr std::size_t most = 3, longest = 100;
    const auto same_line = [&](const Reason& other) { return other.line == line; };
    if (findings_.size() == most || std::ranges::any_of(findings_, same_line)) return;
    std::string excerpt = source_line(line);
    excerpt.erase(0, excerpt.find_first_not_of(" \t\r"));
    excerpt.erase(excerpt.find_last_not_of(" \t\r") + 1);
    if (excerpt.size() > longest) excerpt = cut(excerpt, longest) + " …";
    findings_.push_back({.name = name, .sentence = sentence, .weight = weight, .line = line, .excerpt = excerpt});
    if (name == "index_out_of_range" && counts_from_one(line))
      findings_.back().sentence += " Yours are counted from 1.";
  }

  /// What is known of "NAME|FACT|…".
  bool add_finding(int line, const std::string& text) {
    const auto& [event, in_text, in_code] = known(text, source_line(line));
    if (in_text) add(line, event.name, in_code.fill(in_text.fill(event.sentence), '%'), event.weight);
    return bool{in_text};
  }

  void add_undefined_behavior(const Run& run) {
    for (const DiagnosticEvent& event : run.events)
      if (is_undefined_behavior(event) && event.line() > 0) add_finding(event.line(), event.text);
  }

  void explain_ending() {
    const Run again = run(protocol::fill_with_nan);
    add_undefined_behavior(again);
    if (again.returned() || again.events.empty() || !again.is_harmless()) return;
    tell_last_event(again);
    if (const Run zeros = run(protocol::plain); zeros.returned()) explain_never_set(zeros);
  }

  void tell_last_event(const Run& run) {
    const DiagnosticEvent* last = &run.events.back();
    if (last->is("ABRT") && judged_.cause == CrashCause::uncaught_exception && run.events.size() >= 2) --last;
    const int line = last->line();
    if (line == 0) return;
    // An exception is placed only if it is the one that was seen when the function was judged.
    const bool is_same = run.reply.ending == judged_.ending && run.reply.text == judged_.text;
    if (last->is("thrown") && judged_.eigen && is_same) {
      if (add_finding(line, "eigen|" + *judged_.eigen)) return;
      add(line, kind_of_eigen(*judged_.eigen), sentence_on_eigen(*judged_.eigen) + ".");
    } else if (last->is("thrown") && judged_.ending == Ending::exception) {
      if (is_same) add_finding(line, "exception|" + quoted(judged_.text));
    } else if (last->is("thrown") && judged_.ending != Ending::not_started) {
      add_finding(line, "uncaught|" + quoted(judged_.text));
    } else if (last->is("forbidden")) {
      if (judged_.system_call >= 0) add_finding(line, "forbidden|" + forbidden_operation(judged_.system_call));
    } else if (const int caller = recursion_line(*last); caller > 0) {
      add_finding(caller, "recursion");
    } else {
      add_finding(line, last->text);
    }
  }

  void explain_value() {
    const Run first = run(protocol::plain);
    // What the optimiser had removed, such as a second delete, may also end the call now.
    add_undefined_behavior(first);
    // What lies outside an array was never set either.
    if (first.is_harmless() && first.returned()) explain_never_set(first);
    if (verdict_ != Verdict::non_finite_value || !findings_.empty()) return;
    const Run trapped = run(protocol::trap_invalid | protocol::trap_non_finite);
    if (const int line = trapped.trap_line(); line > 0) add_finding(line, "FPE|" + operation_at(trapped));
  }

  /// What gave no finite number: a division, as the sanitizer saw it, or the only function of <cmath> that the line
  /// calls; a root is no call but an instruction, like a division.
  std::string operation_at(const Run& trapped) const {
    if (trapped.events.size() >= 2 && trapped.events.rbegin()[1].is("float-divide-by-zero") &&
        trapped.events.rbegin()[1].line() == trapped.trap_line())
      return "division";
    const std::string line = source_line(trapped.trap_line());
    if (!trapped.events.back().in_c_library) return search(line, R"(^[^/%]*\bsqrt\s*\([^/%]*$)") ? "sqrt" : "";
    std::set<std::string> functions;
    for (const Match& call : search_all(line, "\\b(sqrt|a?cosh?|a?sinh?|a?tanh?|log(?:2|10)?|pow|exp|fmod)\\s*\\("))
      functions.insert(call[1]);
    return functions.size() == 1 ? *functions.begin() : "";
  }

  /// Does what the function does depend on memory that it never set? Certain where it is the same at every run with the
  /// same filling, and differs from filling to filling. @param zeros  a run where memory was filled with zeros
  void explain_never_set(const Run& zeros) {
    const Run nan = run(protocol::fill_with_nan);
    if (nan == zeros || !(zeros == run(protocol::plain)) || !(nan == run(protocol::fill_with_nan))) return;
    // NaN trap where they are first used; with zeros nothing must happen there.
    const int line = run(protocol::fill_with_nan | protocol::trap_invalid).trap_line();
    const bool is_certain = line > 0 && run(protocol::trap_invalid).trap_line() == 0;
    std::vector<Unset> unset = variables_without_value(source_);
    const auto is_elsewhere = [&](const Unset& each) {
      return is_certain && !search(source_line(line), fmt::format("\\b{}\\b", each.name));
    };
    std::erase_if(unset, is_elsewhere);
    // One that is never given a value is meant rather than one that is.
    if (!std::ranges::all_of(unset, &Unset::is_given_one)) std::erase_if(unset, &Unset::is_given_one);
    const std::string name = unset.size() == 1 ? "|" + unset.front().name : "";
    if (is_certain && add_finding(line, "never_set here" + name)) return;
    add_finding(name.empty() ? 0 : unset.front().line, "never_set" + name);
  }

  void explain_long_run() {
    const Run long_run = run(protocol::sample);
    add_undefined_behavior(long_run);
    std::vector<std::vector<int>> samples;  // of every sample the lines of the student's file, outermost first
    for (const DiagnosticEvent& event : long_run.events)
      if (event.is("running") && event.line() > 0) samples.emplace_back(event.lines.rbegin(), event.lines.rend());
    if (long_run.returned() || samples.size() < 8) return;
    // The outermost call that moves from sample to sample is the loop; below it lie the calls that it makes.
    const std::size_t least = std::ranges::min(samples, {}, &std::vector<int>::size).size();
    int first = 0, last = 0;
    for (std::size_t depth = 0; depth < least && first == last; ++depth) {
      const auto at_depth = [&](const std::vector<int>& lines) { return lines[depth]; };
      first = at_depth(std::ranges::min(samples, {}, at_depth));
      last = at_depth(std::ranges::max(samples, {}, at_depth));
    }
    add_finding(first, fmt::format("{}|{}|{}",
                                   verdict_ == Verdict::output_limit   ? "printing"
                                   : verdict_ == Verdict::memory_limit ? "growing"
                                                                       : "running",
                                   first, last));
  }

  const Verdict verdict_;
  const std::filesystem::path& program_;
  const SandboxProfile profile_;
  const std::string file_name_;  ///< as the compiler was told
  const std::vector<std::string> source_;
  const Case& case_;
  const Reply& judged_;  ///< what was seen of the call when it was judged
  std::vector<Reason> findings_;
};

}  // namespace

std::vector<DiagnosticEvent> read_report(const std::string& text, const std::string& file_name) {
  constexpr const char* memory = "^==\\d+==ERROR: AddressSanitizer: ([A-Za-z-]+)(?: on unknown address (0x[0-9a-f]+))?";
  constexpr const char* behavior = "^.*:\\d+:\\d+: runtime error: (.*)$";
  constexpr const char* summary = "^SUMMARY: UndefinedBehaviorSanitizer: ([a-z-]+) ";
  constexpr const char* assertion = "^.*: Assertion ([`'])(.*)' failed\\.$";
  constexpr const char* call = "^frame (\\d+)\\|(.*)\\|([^(]*)(.*)$";
  const std::string student_file = "shown/" + file_name;  // -fdebug-prefix-map
  std::vector<DiagnosticEvent> events;
  bool has_calls = true, in_calls = false;  // the last event, the last line
  for (const std::string& line : lines_of(text)) {
    const auto begin = [&](const std::string& event) {
      events.push_back({event, {}});
      has_calls = false;
    };
    const bool was_in_calls = std::exchange(in_calls, false);
    if (const Match called = events.empty() ? Match() : search(line, call)) {
      // A report may go on with other chains: who freed the memory, who asked for it.
      const bool is_students = called[2].ends_with(student_file);
      // The compiler calls __divdc3 and __muldc3 for complex numbers.
      if (!has_calls)
        events.back().in_c_library = !is_students && called[4].empty() && !search(called[3], "^__(?:div|mul)");
      if ((!has_calls || was_in_calls) && is_students) events.back().lines.push_back(std::atoi(called[1].c_str()));
      in_calls = !has_calls || was_in_calls;
      has_calls = true;
    } else if (line.starts_with("event ")) {
      // What has no calls yet announced what now throws or aborts: an assertion, memory, a forbidden call.
      if (line != "event thrown" || has_calls) begin(line.substr(6));
    } else if (const Match failed = search(line, assertion)) {
      begin((failed[1] == "'" ? "library|" : "assertion|") + failed[2]);  // assert() quotes with `
    } else if (const Match touched = search(line, memory)) {
      if (touched[1] != "ABRT" || has_calls) begin(touched[1] + "|" + touched[2]);
    } else if (const Match undefined = search(line, behavior)) {
      begin("|" + undefined[1]);
    } else if (!events.empty() && events.back().text.starts_with('|')) {
      if (const Match named = search(line, summary)) events.back().text.insert(0, named[1]);
    }
  }
  return events;
}

bool can_be_explained_by_a_run(const Judgement& judgement) {
  using enum Verdict;
  constexpr Verdict verdicts[] = {wrong_value,  non_finite_value,   inconsistent_value, uncaught_exception,
                                  crashed,      stopped_early,      time_limit,         memory_limit,
                                  output_limit, forbidden_operation};
  return std::ranges::count(verdicts, judgement.verdict) > 0;
}

std::string missing_for_diagnostic_runs(const Toolchain& toolchain) {
  if (toolchain.diagnostic.empty()) return "the compiler's sanitizers (on Debian they come with the package g++)";
  return can_confine_files() ? "" : "Landlock and seccomp in this kernel";
}

std::vector<Reason> diagnostic_run_of(const std::filesystem::path& program, const DiagnosticTask& task,
                                      const Toolchain& toolchain) {
  const std::vector<Repeat>& repeats = task.observation.repeats;
  const std::size_t case_index = !task.judgement.failing.empty() ? task.judgement.failing.front()
                                 : repeats.empty()               ? 0
                                                                 : repeats.front().case_index;
  if (!can_be_explained_by_a_run(task.judgement) || task.observation.replies.size() <= case_index) return {};
  return DiagnosticRun(task, case_index, program, toolchain.compiler).findings();
}

std::vector<Reason> diagnostic_run(const DiagnosticTask& task, const Toolchain& toolchain,
                                   const std::filesystem::path& scratch) {
  if (!can_be_explained_by_a_run(task.judgement) || !missing_for_diagnostic_runs(toolchain).empty()) return {};
  try {
    const Workspace workspace(scratch);
    const Compilation compilation =
        compile({.submission = task.submission, .exercise = task.reference.name, .signature = task.reference.signature},
                read_toolchain(toolchain.diagnostic), workspace.directory(), {.time = limits::diagnostic_compile_time});
    return compilation.executable ? diagnostic_run_of(*compilation.executable, task, toolchain) : std::vector<Reason>();
  } catch (const std::exception&) {
    return {};  // an explanation less; the verdict stands
  }
}

bool explain_failed_call(Search& search) {
  const Evidence& evidence = search.evidence;
  std::erase_if(search.in_code, &Reason::is_remark);
  std::vector<Reason> met = diagnostic_run(evidence.task, evidence.toolchain, evidence.cache);
  // Of a mistake that is known, the run may only tell what comes of it.
  std::erase_if(met, [&](const Reason& reason) {
    return reason.weight == Weight::symptom && std::ranges::any_of(search.in_code, [&](const Reason& known) {
             return known.name == reason.name || known.line == reason.line;
           });
  });
  // What may end a call stands before the end that it came to; what has another fix changes values.
  for (const Reason& known : search.in_code) {
    const bool is_there = std::ranges::find(met, known.line, &Reason::line) != met.end();
    const bool may_end_it =
        known.weight == Weight::possible && (known.fix == Fix::none || (known.fix == Fix::wider_type && is_there));
    const bool is_before_symptoms = known.is_cause() && std::ranges::all_of(met, [](const Reason& reason) {
                                      return reason.weight == Weight::symptom;
                                    });
    if (may_end_it || is_before_symptoms) search.reasons.push_back(known);
  }
  search.add_code(std::move(met));
  return true;
}

bool explain_suspected_undefined(Search& search) {
  constexpr double of_no_formula = 1e300;  // with -ftrivial-auto-var-init=pattern GCC's memory holds -5.3e303
  const Evidence& evidence = search.evidence;
  const DiagnosticTask& task = evidence.task;
  Judgement at_one = task.judgement;
  at_one.failing.clear();
  for (const std::size_t i : task.judgement.failing) {
    const Reply& reply = task.observation.replies[i];
    const bool is_unset = std::ranges::any_of(reply.value.numbers, [&](double x) { return x < -of_no_formula; });
    if (reply.ending == Ending::crashed || reply.ending == Ending::exception || is_unset) at_one.failing.push_back(i);
  }
  std::set<std::string> warned;
  for (const Match& found : search_all(evidence.compilation.compiler_output, "(\\w+)\\W{1,6} may be used uninit"))
    warned.insert(found[1]);
  if (at_one.failing.empty() && warned.empty()) return false;
  if (at_one.failing.empty()) at_one.failing = task.judgement.failing;
  std::vector<Reason> met =
      diagnostic_run({task.submission, task.reference, task.observation, at_one}, evidence.toolchain, evidence.cache);
  // The case that is shown is the first that fails.
  if (const std::size_t at = at_one.failing.front(); at != task.judgement.failing.front())
    for (Reason& reason : met) reason.sentence.insert(0, fmt::format("At case {}, ", at + 1));
  for (Reason& reason : met)
    if (warned.size() == 1 && reason.name == "never_set" && reason.sentence.find('`') == std::string::npos) {
      const auto& [event, found, code] = known("never_set here|" + *warned.begin());
      reason.sentence = found.fill(event.sentence);
    }
  search.add_code(std::move(met));
  return !search.reasons.empty();
}

bool explain_by_sanitizers(Search& search) {
  const Evidence& evidence = search.evidence;
  std::vector<Reason> met = diagnostic_run(evidence.task, evidence.toolchain, evidence.cache);
  // Where a mistake in the code is known, its consequences are none of physics. An overflow may be one of these.
  const bool is_in_code = !met.empty();
  const bool may_be_physics = std::ranges::all_of(
      met, [](const Reason& each) { return each.name == "non_finite" || each.name == "outside_domain"; });
  if (is_in_code || search.has_mistake_in_code())
    std::erase_if(search.reasons, [&](const Reason& reason) {
      return is_in_code ? !may_be_physics || reason.kind != ReasonKind::split : reason.kind != ReasonKind::place;
    });
  search.add_code(std::move(met));
  return is_in_code || search.has_mistake_in_code();
}

}  // namespace workbook
