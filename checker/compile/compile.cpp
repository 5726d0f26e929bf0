#include "checker/compile/compile.hpp"

#include "checker/base/text.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <signal.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace workbook {
namespace fs = std::filesystem;
namespace {

/// How a file is compiled that is called UNIT.cpp meanwhile, beside the toolchain's flags.
std::vector<std::string> arguments_for(const Submission& submission, const std::string& unit) {
  const std::string name = submission.path.filename().string(), source = unit + ".cpp";
  return {"-Wreturn-type", "-Wuninitialized", "-Wmaybe-uninitialized", "-Wfloat-conversion", "-Wparentheses",
          "-Wunused-value", "-Wtype-limits", "-Wunused-variable", "-Wunused-parameter", "-Wunused-but-set-variable",
          "-Wreturn-local-addr", "-Wimplicit-fallthrough", "-Wmisleading-indentation", "-Wshadow=local",
          "-Wdiv-by-zero", "-Wsequence-point", "-Wlogical-not-parentheses", "-Wfloat-equal", "-Wcomment",
          "-Woverloaded-virtual",
          // The student's own name of the file in assertions, and in what debuggers read.
          fmt::format("-fmacro-prefix-map={}={}", source, name),
          fmt::format("-fdebug-prefix-map={}=shown/{}", source, name),
          // Both lists of dependencies: of the preprocessor, and of the assembler, which can include files too.
          "-MD", "-MF", unit + ".includes", "-Wa,--MD," + unit + ".assembled", "-c", source, "-o", unit + ".o"};
}

constexpr const char* own_prefix = "own_";

/// All that an executable depends on.
std::string cache_key(const CompileTask& task, const Toolchain& toolchain) {
  std::vector<fs::path> files = toolchain.support;
  files.insert(files.end(), {toolchain.compiler, toolchain.prelude, toolchain.precompiled(),
                             toolchain.worker_object(task.exercise)});
  std::string key = fmt::format("{}\n{}\n{}\n", fmt::join(toolchain.flags, "\n"), fmt::join(toolchain.link_flags, "\n"),
                                fmt::join(arguments_for(task.submission, "unit"), "\n"));
  for (const fs::path& file : files)
    key += fmt::format("{} {} {}\n", file.string(), fs::file_size(file),
                       fs::last_write_time(file).time_since_epoch().count());
  for (const Submission& own : task.submission.library)
    key += fmt::format("{} {}\n{}\n", own.path.string(), own.text.size(), own.text);
  return key + task.submission.text;
}

/// Does an object file hold the name of a section or of a symbol? All names stand in the file, so its bytes tell.
bool names(const std::string& object, std::initializer_list<std::string_view> any_of) {
  return std::ranges::any_of(any_of, [&](std::string_view name) { return object.find(name) != std::string::npos; });
}

/// The files of a list of dependencies as compilers write it for make: "unit.o: a.hpp \\ b\\ c.hpp".
std::vector<std::string> dependencies(const fs::path& list) {
  std::ifstream stream(list, std::ios::binary);
  std::vector<std::string> names(1);
  for (char letter = 0; stream.get(letter);) {
    char escaped = '\n';
    if (letter == '\\' || letter == '$') {
      if (stream.get(escaped) && escaped != '\n') names.back() += escaped;
    } else if (letter != ' ' && letter != '\n') {
      names.back() += letter;
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  if (!names.empty()) names.erase(names.begin());  // the target, "unit.o:"
  return names;
}

/// The file that the sandbox kept from compiler or assembler; "" if there is none. Whether such a file is there at all
/// makes no difference, and must not.
std::string denied_file(const std::string& output) {
  constexpr const char* denied =
      "^rror: (?:can't open |file not found: )?(/[^:]*?)(?: for reading)?"
      "(?:: (?:Permission denied|No such file or directory))?$";
  for (const std::string& line : lines_of(output)) {
    const bool tells =
        line.size() < 1000 && (line.ends_with(": Permission denied") || line.ends_with(": No such file or directory") ||
                               line.find("rror: file not found: ") != std::string::npos);
    const std::size_t begin = tells ? line.find("rror: ") : std::string::npos;
    if (begin == std::string::npos) continue;
    if (const Match found = search(line.substr(begin), denied)) return found[1];
  }
  return "";
}

/// A line of nm.
struct Symbol {
  char kind;
  std::string name;   ///< as the linker has it
  std::string shown;  ///< as C++ has it: "rigid::twice(double)"

  bool is_used() const { return kind == 'U'; }
  bool is_defined() const { return std::string_view("Uwv").find(kind) == std::string_view::npos; }
  bool is_the_only_one() const { return std::string_view("TDBR").find(kind) != std::string_view::npos; }
  /// "rigid::twice"; "" for what a file does not name in this way
  std::string base_name() const { return search(shown, "^([\\w:~]+)(?:\\(.*)?$")[1]; }
};

/// From the source to an executable; throws a Compilation that says why there is none.
class CompilationInProgress {
 public:
  CompilationInProgress(const CompileTask& task, const Toolchain& toolchain, const CompileLimits& limits,
                        const fs::path& workspace)
      : task_(task),
        toolchain_(toolchain),
        limits_(limits),
        compiler_(toolchain, limits, workspace),
        source_(task.submission.text) {}

  Compilation run() {
    const auto has_own_names = [](const Submission& file) { return !file.own_names.empty(); };
    try {
      return attempt();
    } catch (const Compilation& refused) {
      const bool is_hopeful =
          has_own_names(task_.submission) || std::ranges::any_of(task_.submission.library, has_own_names);
      if (!is_hopeful || refused.refusal == Refusal::checker_error) throw;
    }
    // A helper that is called like a function of the course may be what is in the way.
    renames_ = true;
    uses_streams_ = false;
    linked_.clear();
    return attempt();
  }

 private:
  Compilation attempt() {
    const std::string warnings = compile_file(task_.submission, "unit");
    if (!task_.submission.library.empty()) compile_library();
    return {.executable = link(),
            .processor_seconds = compiler_.processor_seconds(),
            .compiler_output = warnings,
            .linked = linked_};
  }

  /// UNIT.o of a file; returns the warnings.
  std::string compile_file(const Submission& file, const std::string& unit) {
    compiler_.write(file.text, renames_ ? renaming(file) : "", unit + ".cpp");
    FinishedProgram compiled = compiler_.run(compiler_.arguments(arguments_for(file, unit)));
    for (const std::string& name : file.own_names) boost::replace_all(compiled.output, own_prefix + name, name);
    if (!compiled.succeeded()) refuse_uncompiled(compiled, file, unit);
    const std::optional<std::string> object = read_file(compiler_.workspace() / (unit + ".o"));
    if (!object) refuse("Your file compiles, but into nothing that can be read.");
    // Such sections make the linker run another compiler, with options that the file chooses.
    if (names(*object, {".gnu.lto_"}))
      refuse("Your file asks for code to be generated when it is linked; no exercise needs that.");
    // And such a one makes the system run another program in place of the worker.
    if (is_static() && names(*object, {std::string_view(".interp\0", 8)}))
      refuse("Your file names a program that shall run it (.interp); no exercise needs that.");
    // std::cout, cerr, clog, cin, or the object that <iostream> brings.
    uses_streams_ = uses_streams_ || names(*object, {"_ZSt4c", "_ZNSt8ios_base4Init"});
    for (const char* list : {".includes", ".assembled"})
      for (const std::string& name : dependencies(compiler_.workspace() / (unit + list)))
        if (!compiler_.may_be_included(name)) refuse_foreign_file(name);
    return compiled.output;
  }

  /// The objects of the own functions that the file calls, and of those that they call.
  void compile_library() {
    std::vector<std::string> objects = {"unit.o"};
    for (std::size_t k = 0; k < objects.size(); ++k) {
      const std::string called = compiler_.run_nm({"-u", "-C", objects[k]}).output;
      for (const Submission& own : task_.submission.library) {
        const std::string name = own.path.stem().string();
        if (called.find(fmt::format(" rigid::{}(", name)) == std::string::npos || std::ranges::count(linked_, name) > 0)
          continue;
        linked_.push_back(name);
        compile_file(own, name);
        objects.push_back(name + ".o");
      }
    }
  }

  [[noreturn]] void refuse_uncompiled(const FinishedProgram& compiled, const Submission& file,
                                      const std::string& unit) const {
    CompilerOutput said;
    std::optional<Reason> error;
    try {
      said = compiler_.read(compiled.output, file.shown_name);
      error = first_error(said.diagnostics, source_, task_.signature);
    } catch (const std::exception&) {  // a student can write any message: what cannot be read costs its reason only
    }
    const bool has_place = error && error->line > 0;
    refuse_if_limit_reached(compiled, has_place);
    if (unit != "unit") refuse(fmt::format("Your file calls {}, and {} does not compile.", unit, file.shown_name));
    if (const std::string denied = denied_file(compiled.output); !denied.empty()) refuse_foreign_file(denied);
    if (has_place)
      refuse(fmt::format("Your file does not compile: the first error is in line {}.", error->line), said.shown,
             {*error});
    if (!said.foreign_file.empty()) refuse_foreign_file(said.foreign_file);
    refuse_if_tools_fail();
    refuse("Your file does not compile.", said.shown, error ? std::vector{*error} : std::vector<Reason>());
  }

  /// Where nothing is said of the student's file: an empty one tells whether compiler, assembler and linker work.
  void refuse_if_tools_fail() const {
    const Compiler compiler(toolchain_, limits_, compiler_.workspace());  // with time of its own
    compiler.write("int main() {}\n", {}, "empty.cpp");
    std::vector<std::string> arguments = compiler.arguments({"empty.cpp", "-o", "empty", "-x", "none"});
    arguments.insert(arguments.end(), toolchain_.link_flags.begin(), toolchain_.link_flags.end());
    const FinishedProgram tried = compiler.run(arguments);
    if (!tried.succeeded())
      refuse("The compiler makes no program of an empty file either, so this is not your mistake: install it again.",
             tried.output, {}, Refusal::checker_error);
  }

  [[noreturn]] void refuse(const std::string& message, const std::string& details = "",
                           const std::vector<Reason>& errors = {}, Refusal refusal = Refusal::compile_error) const {
    throw Compilation{.processor_seconds = compiler_.processor_seconds(),
                      .linked = linked_,
                      .refusal = refusal,
                      .message = message,
                      .details = details,
                      .errors = errors};
  }

  [[noreturn]] void refuse_foreign_file(const std::string& name) const {
    refuse(
        fmt::format("Your file includes {}, but it is compiled alone: include only headers "
                    "of the course, of Eigen and of the standard library.",
                    printable(name)));
  }

  fs::path link() const {
    std::vector<std::string> arguments;
    for (const fs::path& support : toolchain_.support)  // first, so that streams work when a student's objects begin
      if (uses_streams_ || support.stem() != "streams") arguments.push_back(support.string());
    arguments.insert(arguments.end(), {"unit.o", toolchain_.worker_object(task_.exercise).string()});
    for (const std::string& own : linked_) arguments.push_back(own + ".o");
    for (const Instantiation& each : compiler_.instantiated()) arguments.push_back(each.object.string());
    for (const std::string& flag : toolchain_.link_flags) arguments.push_back(flag);
    arguments.insert(arguments.end(), {"-o", "worker"});
    const FinishedProgram linked = compiler_.run(arguments);
    if (linked.succeeded()) return compiler_.workspace() / "worker";
    refuse_if_limit_reached(linked);
    try {
      explain_unlinked(linked.output);
    } catch (const std::exception&) {  // as above, of names
    }
    refuse_if_tools_fail();
    refuse("Your file compiles, but cannot be linked into a program; see what the linker says.", linked.output);
  }

  bool is_static() const { return std::ranges::count(toolchain_.link_flags, "-static") > 0; }

  /// Refuses as the symbols tell: every linker words it in its own way, and only which name it misses is taken from
  /// there.
  void explain_unlinked(const std::string& output) const {
    std::vector<std::string> objects = {"unit.o"};
    for (const std::string& own : linked_) objects.push_back(own + ".o");
    std::set<std::string> defined;
    std::vector<Symbol> used;
    for (const std::string& object : objects)
      for (const Symbol& symbol : symbols(object)) {
        if (symbol.name == "main" && symbol.is_defined())
          refuse_symbol(Refusal::compile_error, "defines_main", "main", output,
                        "Your file defines main(); leave it out, the checker calls your function itself.");
        if (symbol.is_used()) used.push_back(symbol);
        if (symbol.is_defined() && !defined.insert(symbol.name).second && symbol.is_the_only_one())
          refuse_symbol(Refusal::compile_error, "defined_twice", symbol.base_name(), output,
                        fmt::format("Two of your files, which are linked here, define `{}` ({}); put helpers into "
                                    "`namespace {{ }}`, and what both need into one of them.",
                                    symbol.base_name(), fmt::join(linked_, ", ")));
      }
    const auto is_missing = [&](const Symbol& symbol) { return symbol.is_used() && !defined.contains(symbol.name); };
    if (source_.tokens().empty())
      refuse("Your file is empty, or holds nothing but comments; `reset` writes it anew.", output, {},
             Refusal::missing_function);
    constexpr std::string_view space = "rigid::";
    const std::string own = defined_functions();
    for (const Symbol& symbol : symbols(toolchain_.worker_object(task_.exercise).string())) {
      if (!is_missing(symbol) || !symbol.shown.starts_with(space)) continue;
      if (own.find("`" + in_plain_words(symbol.shown.substr(space.size())) + "`") != std::string::npos)
        refuse_symbol(Refusal::missing_function, "missing_namespace", symbol.base_name(), output,
                      "Your function stands outside of the namespace: put it between `namespace rigid {` and its `}`.");
      if (own.find("`" + symbol.base_name() + "(") != std::string::npos)
        refuse_symbol(Refusal::missing_function, "parameter_types", symbol.base_name(), output,
                      fmt::format("The parameters are not those of the contract, which is `{}`.", task_.signature));
      refuse_symbol(Refusal::missing_function, "missing_function", symbol.base_name(), output,
                    fmt::format("Your file does not define `{}`: it defines {}. Its head is `{}`, in namespace "
                                "rigid and no class, without inline, static or template.",
                                in_plain_words(symbol.shown), own, task_.signature));
    }
    std::erase_if(used, [&](const Symbol& symbol) {
      return !is_missing(symbol) || symbol.base_name().empty() || output.find(symbol.shown) == std::string::npos;
    });
    const auto place_in_output = [&](const Symbol& symbol) { return output.find(symbol.shown); };
    if (const auto first = std::ranges::min_element(used, {}, place_in_output); first != used.end()) {
      const std::string name = first->base_name();
      for (const Symbol& symbol : symbols("unit.o"))
        if (symbol.is_defined() && search(symbol.shown, "\\b" + name.substr(name.rfind(':') + 1) + "\\("))
          refuse_symbol(Refusal::compile_error, "undefined_function", name, output,
                        fmt::format("What is called here is `{}`, which your file only declares: what it defines is "
                                    "`{}`, with other parameters or in another namespace.",
                                    in_plain_words(first->shown), in_plain_words(symbol.shown)));
      refuse_symbol(Refusal::compile_error, "undefined_function", name, output,
                    fmt::format("Your file uses `{}`, which it does not define, nor does an earlier exercise of yours; "
                                "write what you need into this file.",
                                name));
    }
  }

  /// With the place where the file mentions the function last, for declarations come first.
  [[noreturn]] void refuse_symbol(Refusal refusal, const char* name, std::string function, const std::string& output,
                                  const std::string& message) const {
    function.erase(0, function.rfind(':') + 1);
    std::vector<Reason> errors;
    for (const Token& token : source_.tokens())
      if (token.text == function) errors = {source_.reason(source_.place_of(token.offset), name, message)};
    refuse(errors.empty() ? message
           : refusal == Refusal::missing_function
               ? "Your file does not define the function of this exercise as the contract declares it."
               : fmt::format("Your file cannot be linked into a program; see line {}.", errors.front().line),
           output, errors, refusal);
  }

  /// Those that others could call.
  std::string defined_functions() const {
    std::string functions;
    for (const Symbol& symbol : symbols("unit.o"))
      if (symbol.kind == 'T' && symbol.shown.ends_with(')') && functions.size() < 100)
        functions += (functions.empty() ? "`" : ", `") + in_plain_words(symbol.shown) + "`";
    return functions.empty() ? "no function that others can call" : functions;
  }

  /// Of an object, what others can see.
  std::vector<Symbol> symbols(const std::string& object) const {
    const std::vector<std::string> names = lines_of(compiler_.run_nm({"-p", "-g", object}).output);
    // A name of 900 bytes can stand for a signature of any size: nm has the limits of the compiler.
    std::vector<std::string> shown = lines_of(compiler_.run_nm({"-p", "-g", "-C", object}).output);
    if (shown.size() != names.size()) shown = names;
    std::vector<Symbol> symbols;
    for (std::size_t k = 0; k < names.size(); ++k) {  // "0000000000000040 T rigid::twice(double)"
      constexpr const char* line = "^[0-9a-f]* +([A-Za-z]) (.+)$";
      if (names[k].size() > 1000 || shown[k].size() > 1000) continue;
      const Match name = search(names[k], line), as_shown = search(shown[k], line);
      if (name && as_shown) symbols.push_back({name[1][0], name[2], as_shown[2]});
    }
    return symbols;
  }

  /// @param has_reason  an error in the file: what looks like a limit in the messages is the file's own text
  void refuse_if_limit_reached(const FinishedProgram& program, bool has_reason = false) const {
    const auto says = [&](std::initializer_list<const char*> phrases) {
      return std::ranges::any_of(phrases,
                                 [&](const char* one) { return program.output.find(one) != std::string::npos; });
    };
    // Tried, not read from the compiler's messages: those a student can write.
    const std::string problem = write_file(compiler_.workspace() / "probe", std::string(std::size_t{4} << 20, ' '));
    if (!problem.empty())
      refuse(fmt::format("Nothing more can be written into {} ({}); this is not your mistake.",
                         compiler_.workspace().string(), problem),
             program.output, {}, Refusal::checker_error);
    if (program.out_of_time)
      refuse(linked_.empty()
                 ? "Your file takes too long to compile; look for a template or an #include that never ends."
                 : fmt::format("Your file and your own functions that it calls ({}) take too long to "
                               "compile; look for a template or an #include that never ends.",
                               fmt::join(linked_, ", ")),
             program.output);
    if (has_reason) return;
    if (says({"out of memory", "memory exhausted", "Killed signal terminated program", "Cannot allocate memory"}))
      // The compiler's own words differ from run to run: they tell in which allocation it met the limit.
      refuse("Compiling your file takes too much memory; look for a template or an #include that never ends.");
    if (says({"File too large", "File size limit exceeded"}) || program.end.signal == SIGXFSZ)
      refuse("Your file makes a program that is too large; look for a huge array.", program.output);
  }

  const CompileTask& task_;
  const Toolchain& toolchain_;
  const CompileLimits& limits_;
  const Compiler compiler_;
  const SourceText source_;
  std::vector<std::string> linked_;
  bool uses_streams_ = false;
  bool renames_ = false;
};

}  // namespace

Compilation compile(const CompileTask& task, const Toolchain& toolchain, const fs::path& cache_directory,
                    const CompileLimits& limits) {
  const Clock::time_point start = Clock::now();
  Compilation result;
  try {
    require_complete(toolchain, task.exercise);
    const std::string key = cache_key(task, toolchain);
    const BuildCache cache(fs::absolute(cache_directory));
    if (std::optional<Compilation> found = cache.find(key)) {
      result = std::move(*found);
      result.from_cache = true;
    } else {
      const Workspace workspace(cache.directory());
      result = cache.keep(CompilationInProgress(task, toolchain, limits, workspace.directory()).run(), key);
    }
  } catch (const Compilation& refused) {
    result = refused;
  } catch (const std::runtime_error& error) {  // of the toolchain, the cache, the file system
    result.message = error.what();
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

std::string renaming(const Submission& file) {
  std::string lines;
  for (const std::string& name : file.own_names) lines += fmt::format("#define {0} {1}{0}\n", name, own_prefix);
  return lines;
}

Observation refused(const Compilation& compilation) {
  Observation observation;
  observation.refusal = compilation.refusal;
  observation.refusal_message = compilation.message;
  observation.refusal_details = compilation.details;
  observation.errors = compilation.errors;
  observation.compile_seconds = compilation.seconds;
  return observation;
}

}  // namespace workbook
