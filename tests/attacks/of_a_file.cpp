// What a student's whole file tries: before main, in place of the worker's functions, in the compiler, the assembler
// and the linker. Each is compiled.
#include "tests/attacks/attack.hpp"

#include <doctest/doctest.h>
#include <boost/algorithm/string/replace.hpp>

namespace workbook::testing {
namespace {

using enum Verdict;

#define RIGHT "double rigid::twice(double x) { return 2 * x; }\n"
#define FORGERY                                                                                                       \
  "#include <unistd.h>\nstruct Reply { unsigned long magic = REPLY_MAGIC, nonce = 0; int status = 1, rows = 1, cols " \
  "= "                                                                                                                \
  "1, signal = 0; long detail = 0; char text[472] = {}; double value = 42; };\n"                                      \
  "static void forge() { Reply r; (void)!write(3, &r, sizeof r); }\n"

/// What no expression finds an end of that looks for the three one after the other.
std::string without_end() {
  std::string text;
  for (const auto& [word, count] : {std::pair{"YOU_MIXED_MATRICES", 20}, {"scalar_x_op", 40}, {"; Lhs = ", 70}})
    for (int n = 0; n < count; ++n) text += word;
  return text;
}

bool answers(const Unhindered& control) { return control.value.has_value(); }
bool says_99999999999(const Unhindered& control) { return has(control.compiler.output, "99999999999"); }

const Attack attacks_of_a_file[] = {
    // --- before main, and in place of what is there
    {"interposition", "a global object", FORGERY "static int early = (forge(), _exit(0), 1);\n" RIGHT,
     protocol_violation},
    {"interposition", "a constructor", FORGERY "[[gnu::constructor]] void early() { forge(); }\n" RIGHT,
     protocol_violation},
    {"interposition", "the section of constructors",
     FORGERY "[[gnu::section(\".init_array\"), gnu::used]] void (*early)() = forge;\n" RIGHT, protocol_violation},
    {"interposition", "the section of what runs before them",
     FORGERY "[[gnu::section(\".preinit_array\"), gnu::used]] void (*early)() = forge;\n" RIGHT, protocol_violation},
    {"interposition", "a hook of the worker",
     FORGERY "namespace workbook { void before_call(int) { forge(); } }\n" RIGHT, protocol_violation},
    {"interposition", "a function that is chosen at the start",
     FORGERY "extern \"C\" { double a(double x) { return 2 * x; }\n using F = double (*)(double);\n F choose() { "
             "return a; }\n [[gnu::ifunc(\"choose\")]] double chosen(double); }\n"
             "double rigid::twice(double x) { forge(); return chosen(x); }\n",
     protocol_violation},
    {"interposition", "write",
     "#include <sys/syscall.h>\n#include <unistd.h>\n#include <cstring>\n"
     "extern \"C\" ssize_t write(int d, const void* p, size_t n) { double forged = 42; if (n == 8) p = &forged; return "
     "syscall(SYS_write, d, p, n); }\n" RIGHT,
     wrong_value},
    {"interposition", "memory",
     "#include <cstdlib>\nvoid* operator new(size_t n) { return std::calloc(1, n + 64); }\nvoid operator delete(void* "
     "p) noexcept { std::free(p); }\nvoid operator delete(void* p, size_t) noexcept { std::free(p); }\n" RIGHT,
     passed, answers},
    {"interposition", "the end", FORGERY "struct Last { ~Last() { forge(); } };\nstatic Last last;\n" RIGHT, passed,
     answers},
    {"interposition", "an end that never ends",
     "#include <unistd.h>\nextern \"C\" void _Exit(int) { for (;;) usleep(1000); }\n" RIGHT, passed, answers},
    {"interposition", "main", "int main() { return 0; }\n" RIGHT, compile_error, compiles},
    {"interposition", "the start of the program", "extern \"C\" void _start() { for (;;) {} }\n" RIGHT, compile_error,
     compiles},
    {"interposition", "the worker's loop",
     "#include <functional>\nnamespace workbook { int serve_calls(unsigned long, const void*) { return 0; } }\nint "
     "workbook_variant = 7;\nextern \"C\" int workbook_variant;\n" RIGHT,
     compile_error, [](const Unhindered&) { return true; }},
    {"interposition", "the worker's variable", "extern \"C\" int workbook_variant; int workbook_variant = 7;\n" RIGHT,
     compile_error, compiles},
    {"interposition", "the reference",
     "double reference_twice(double);\ndouble rigid::twice(double x) { return reference_twice(x); }\n", compile_error,
     compiles},

    // --- macros and pragmas
    {"macros and pragmas", "another type", "#define double float\n" RIGHT, compile_error,
     [](const Unhindered& control) { return !compiles(control); }},
    {"macros and pragmas", "no optimiser's NaN",
     "#pragma GCC optimize(\"Ofast\")\n#include <cmath>\ndouble rigid::twice(double x) { return std::sqrt(-x); }\n",
     non_finite_value, answers},
    {"macros and pragmas", "packed, poisoned, hidden",
     "#pragma pack(1)\n#pragma GCC poison magic nonce reply\n#pragma GCC visibility push(hidden)\n#define private "
     "public\n#define main twice\n#define write(...) 0\n#undef NDEBUG\n" RIGHT,
     passed, answers},
    {"macros and pragmas", "warnings that end nothing",
     "#pragma GCC diagnostic error \"-Wall\"\n#pragma message(\"error: PASS\")\n#line 1 \"/etc/passwd\"\n" RIGHT,
     passed, answers},
    {"macros and pragmas", "an alignment that the worker doesn't expect",
     "struct alignas(1 << 20) Wide { double x; };\nstatic Wide wide;\ndouble rigid::twice(double x) { wide.x = x; "
     "return 2 * wide.x; }\n",
     passed, answers},

    // --- answers that remember
    {"random answers", "by the number of calls",
     "static int calls = 0;\ndouble rigid::twice(double x) { return 2 * x + 1e-3 * calls++; }\n", inconsistent_value,
     answers},
    {"random answers", "in the order of the published cases",
     "static int calls = 0;\ndouble rigid::twice(double) { const double all[] = {2, 14, 4}; return all[calls++ % 3]; "
     "}\n",
     inconsistent_value, answers},

    // --- reading
    {"reading at compile time", "include", "#include \"CANARY\"\n" RIGHT, compile_error, shows_secret},
    {"reading at compile time", "include in the assembler", "asm(\".include \\\"CANARY\\\"\");\n" RIGHT, compile_error,
     shows_secret},
    {"reading at compile time", "bytes in the assembler", "asm(\".incbin \\\"CANARY\\\"\");\n" RIGHT, compile_error,
     shows_secret},
    {"reading at compile time", "bytes, by a macro of the assembler",
     "asm(\".macro of a, b\\n.\\\\a\\\\b \\\"CANARY\\\"\\n.endm\\nof inc bin\");\n" RIGHT, compile_error, shows_secret},
    {"reading at compile time", "bytes that the function returns",
     "asm(\".globl s\\ns: .incbin \\\"CANARY\\\"\");\nextern \"C\" const char s[];\ndouble rigid::twice(double) { "
     "return s[0]; }\n",
     compile_error, shows_secret},
    {"reading at compile time", "a line that looks like its own",
     "#include \"CANARY\"\n#line 1 \"student.cpp\"\nint x = y;\n", compile_error, shows_secret},
    {"reading at compile time", "whether a file is there",
     "#if __has_include(\"CANARY\")\n#error secret\n#else\n#error none\n#endif\n" RIGHT, compile_error, shows_secret},
    {"reading at compile time", "through the kernel", "#include \"/proc/self/root/CANARY\"\n" RIGHT, compile_error,
     shows_secret},
    {"reading at compile time", "its own command line", "#include \"/proc/self/cmdline\"\n" RIGHT, compile_error,
     compiles},
    {"reading at compile time", "its environment", "#include \"/proc/self/environ\"\n" RIGHT, compile_error, compiles},
    {"reading at compile time", "with #embed", "constexpr char s[] = {\n#embed \"CANARY\"\n};\n" RIGHT, compile_error,
     [](const Unhindered& control) { return !compiles(control) || shows_secret(control); }},
    {"reading at compile time", "a name that pretends", "#line 1 \"CANARY\"\nint rigid;\n", compile_error,
     [](const Unhindered& control) { return has(control.compiler.output, "canary"); }},

    // --- what reads the messages
    {"messages", "of a shape that is no number", "static_assert(false, \"Transpose<99999999999×3 vector>\");\n" RIGHT,
     compile_error, says_99999999999},
    {"messages", "of a line that is none", "#line 999999999 \"unit.cpp\"\nint x = y99999999999;\n" RIGHT, compile_error,
     says_99999999999},
    {"messages", "that no pattern is through with", "static_assert(false, \"99999999999 WITHOUT_END\");\n" RIGHT,
     compile_error, says_99999999999},

    // --- the linker
    {"the linker", "another program that runs this one",
     "[[gnu::section(\".interp\"), gnu::used]] const char interpreter[] = \"/nowhere/at/all\";\n" RIGHT, compile_error,
     compiles},
    {"the linker", "code for the linker's compiler",
     "asm(\".section .gnu.lto_.opts,\\\"e\\\"\\n.string \\\"secret\\\"\\n.text\");\n" RIGHT, compile_error, compiles},
    {"the linker", "a warning that looks like a message",
     "asm(\".section .gnu.warning.twice\\n.string \\\"PASS\\\"\\n.text\");\n" RIGHT, passed, compiles},
    {"the linker", "a stack that may be executed",
     "asm(\".section .note.GNU-stack,\\\"x\\\",@progbits\\n.text\");\n" RIGHT, passed, compiles},
    {"the linker", "a section where the headers are",
     "[[gnu::section(\".text.unlikely,\\\"ax\\\"#\"), gnu::used]] static int early = 1;\n" RIGHT, passed, compiles},

    // --- bombs
    {"bombs at compile time", "templates",
     "template <int n, int m> struct T { using A = typename T<n - 1, 2 * m>::A; using B = typename T<n - 1, 2 * m + "
     "1>::B; };\ntemplate <int m> struct T<0, m> { using A = int; using B = int; };\nT<24, 0> t; T<24, 0>::A "
     "a;\n" RIGHT,
     compile_error, takes_long},
    {"bombs at compile time", "templates without end",
     "template <int n> struct D { static constexpr int value = D<n + 1>::value; };\nint d = D<0>::value;\n" RIGHT,
     compile_error, takes_long},
    {"bombs at compile time", "constant expressions",
     "constexpr long f(long n) { long s = 0; for (long i = 0; i < 200000; ++i) s += i % n; return s; }\ntemplate <long "
     "n> struct F { static constexpr long value = f(n) + F<n - 1>::value; };\ntemplate <> struct F<0> { static "
     "constexpr long value = 0; };\nlong l = F<800>::value;\n" RIGHT,
     compile_error, takes_long},
    {"bombs at compile time", "a file that includes itself", "#include \"unit.cpp\"\n#include \"unit.cpp\"\n",
     compile_error, takes_long},
    {"bombs at compile time", "a file that never ends", "#include \"/dev/zero\"\n" RIGHT, compile_error, takes_long},
    {"bombs at compile time", "a huge array", "double huge[1 << 25] = {1.0};\n" RIGHT, compile_error, takes_long},
    {"bombs at compile time", "a huge section", "asm(\".data; .fill 300000000, 1, 7\");\n" RIGHT, compile_error,
     takes_long},
    {"bombs at compile time", "many instructions", "asm(\".rept 100000000\\nnop\\n.endr\");\n" RIGHT, compile_error,
     takes_long},
    {"bombs at compile time", "macros",
     "#define A(x) x x x x x x x x\n#define B(x) A(A(A(x)))\nlong m = B(B(B(+1)));\n" RIGHT, compile_error, takes_long},
    {"bombs at compile time", "messages",
     "#define W _Pragma(\"GCC warning \\\"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\\\"\")\n#define X W W W W "
     "W W W W W W\n#define Y X X X X X X X X X X\nY Y Y Y Y Y Y Y Y Y\n#error end\n" RIGHT,
     compile_error, says_much},
};

/// A reason may name a file that was asked for, and never tell what is in it, nor whether it is there.
void expect_silence(const Compilation& compilation) {
  if (!can_confine_files()) return;  // the tier minimal says so of itself
  std::string said = compilation.message + compilation.details + compilation.compiler_output;
  for (const Reason& finding : compilation.errors) said += finding.excerpt + finding.sentence;
  CHECK_MESSAGE(!has(said, "secret\n"), said);
}

}  // namespace

TEST_CASE("what a file tries before it runs, and in the compiler, gets it nothing") {
  CompileLimits limits;
  limits.memory_bytes = std::size_t{1} << 30;
  limits.file_bytes = std::size_t{16} << 20;
  limits.output_bytes = 16'000;
  restore_canary();
  for (const Attack& attack : attacks_of_a_file) {
    INFO(std::string(attack.kind) << ": " << std::string(attack.what));
    const std::string text = boost::replace_all_copy(filled_in(attack.code), "WITHOUT_END", without_end());
    const auto begun = std::chrono::steady_clock::now();
    limits.time = std::chrono::seconds(attack.works == takes_long ? 1 : 5);
    const Compilation compilation =
        compile({submit(text, "twice"), "twice", signature("twice")}, toolchain(), shared_cache(), limits);
    const bool is_run = compilation.executable.has_value();
    INFO(compilation.message << compilation.details);
    const bool is_for_compiler = attack.works == compiles || attack.works == shows_secret ||
                                 attack.works == takes_long || attack.works == says_much ||
                                 attack.works == says_99999999999;
    const std::chrono::seconds patience(attack.works == takes_long ? 1 : 60);
    const Unhindered control = is_run && !is_for_compiler ? run_unhindered(*compilation.executable, 7)
                                                          : compile_unhindered(text, "unit.cpp", patience);
    CHECK_MESSAGE(attack.works(control), "the control does not work: " << control.compiler.output.substr(0, 300)
                                                                       << control.value.value_or(-1));
    restore_canary();
    const ExerciseReference reference = reference_at(7);
    expect(attack, reference,
           is_run
               ? ExerciseRunner(*compilation.executable, short_limits()).observe(plan_calls(reference.cases), {2, 1, 0})
               : refused(compilation),
           begun);
    expect_silence(compilation);
  }
}

}  // namespace workbook::testing
