#include "checker/judging/run_failures.hpp"

#include "checker/base/text.hpp"

#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>

namespace workbook {

namespace {

struct EigenRule {
  const char* fragments[5];  ///< of conditions as Eigen 3.4 writes them
  const char* kind;
  const char* sentence;
};

/// The first that fits counts: particular ones stand before general ones.
// clang-format off
constexpr EigenRule eigen_rules[] = {
    {{"Too few coefficients"}, "comma_initializer", "too few numbers follow <<; it must fill the whole matrix or vector"},
    {{"Too many coefficients", "Too many rows"}, "comma_initializer", "too many numbers follow << for this matrix or vector"},
    {{"m_xpr.rows() >= other.rows()"}, "comma_initializer", "what follows << is larger than the matrix or vector that it fills"},
    {{"Cannot comma-initialize"}, "comma_initializer", "<< puts numbers into a matrix or vector without entries; give it a size first"},
    {{"m_currentBlockRows"}, "comma_initializer", "the parts joined by << do not have the same number of rows"},
    {{"invalid matrix product"}, "size_mismatch", "in a matrix product the left factor must have as many columns as the right one has rows"},
    {{"aliasing detected during transposition"}, "aliasing", "a matrix is overwritten here while its own transpose is read: write A.transpose().eval(), and for A = A.transpose() A.transposeInPlace()"},
    {{"Aliasing problem detected in inverse"}, "aliasing", "A = A.inverse() overwrites A while reading it; use A.inverse().eval()"},
    {{"you are using an empty matrix"}, "empty_matrix", "an empty matrix or vector has no largest, smallest or mean entry"},
    {{"eigenvectors have not been computed"}, "not_computed", "the solver was told to compute eigenvalues only, and is asked for eigenvectors"},
    {{"is not initialized"}, "not_computed", "a decomposition is used before compute() was called"},
    {{"invalid number of rows of the right hand side"}, "size_mismatch", "solve() needs a right-hand side with as many rows as the matrix has"},
    {{"index >= 0 && index < size()"}, "index_out_of_range", "an index lies outside its vector: indices start at 0 and end at n - 1 for a size n, and a vector made without a size has size 0"},
    {{"row >= 0 && row < rows()"}, "index_out_of_range", "a row or column index lies outside its matrix: indices start at 0, and a matrix made without a size has no entries"},
    {{"(i>=0) && ("}, "index_out_of_range", "row(i) or col(i) is asked for an i that the matrix does not have; of n there are those from 0 to n - 1, and none before it is given a size (A.size() counts all entries)"},
    {{"startRow >= 0", "RowsAtCompileTime==blockRows"}, "index_out_of_range", "a block, segment, head or tail reaches beyond its matrix or vector"},
    {{"a_index <= m_matrix.cols()"}, "index_out_of_range", "diagonal(i) is asked for a diagonal that the matrix does not have"},
    {{"list_size ==", "list.size() =="}, "size_mismatch", "the rows in the braces do not have the size of their matrix"},
    {{"other.rows() == 1 || other.cols() == 1"}, "size_mismatch", "a matrix of several rows and columns is assigned to a vector"},
    {{"aLhs.rows() == aRhs.rows()"}, "size_mismatch", "two operands of a sum or difference have different sizes"},
    {{"AtCompileTime == rows", "rows==RowsAtCompileTime", "SizeAtCompileTime == ", "rows >= 0 && cols >= 0", "vecSize >= 0"}, "size_mismatch", "a matrix or vector is given a size that its type does not allow, such as two numbers for a Vector3d, or a negative one"},
    {{"dst.rows() ==", "dst.rows()==", "does not actually allow one to resize", "rows() == other.rows()", "rows()==other.rows()"}, "size_mismatch", "two operands of a sum, difference or assignment have different sizes"},
    {{"size() == other.size()"}, "size_mismatch", "dot() needs two vectors of the same size"},
    {{"this->rows() == 1 && this->cols() == 1"}, "size_mismatch", "only a matrix with one entry can be used as a number"},
    {{"non-square matrix", "rows() == cols()", "cols() == matrix.rows()", "m_lu.rows() == m_lu.cols()", "on a non-square"}, "not_square", "inverse, determinant, eigenvalues and transposeInPlace() need a square matrix"},
};
// clang-format on

const EigenRule* rule_of(const std::string& condition) {
  for (const EigenRule& rule : eigen_rules)
    for (const char* fragment : rule.fragments)
      if (fragment != nullptr && condition.find(fragment) != std::string::npos) return &rule;
  return nullptr;
}

const char* signal_name(int signal) {
  if (signal == SIGFPE) return "arithmetic exception, such as a whole number divided by zero";
  if (signal == SIGILL) return "illegal instruction, such as the end of a function on a way without a return";
  return ::sigdescr_np(signal) == nullptr ? "unknown" : ::sigdescr_np(signal);
}

Advice crashed(const std::string& when, const Reply& reply) {
  const auto sentence_on = [&](const std::string& what) {
    return fmt::format("The function crashed {}: {}.", when, what);
  };
  const std::string name = fmt::format("signal {} ({})", reply.signal, signal_name(reply.signal));
  switch (reply.cause) {
    case CrashCause::stack_overflow:
      return {sentence_on("the stack is used up, by calls that never end or by a very large local array"),
              "Give the recursion an end that every input reaches, or make the array a std::vector."};
    case CrashCause::uncaught_exception:
    case CrashCause::foreign_exception:
      return {sentence_on(name + (reply.text.empty() ? "; nobody caught an exception"
                                                     : "; nobody caught the exception “" + quoted(reply.text) + "”")),
              "Look for an exception that leaves a destructor or a function marked noexcept."};
    case CrashCause::unknown:
      break;
  }
  if (reply.signal == SIGABRT)
    return {
        sentence_on(name),
        "Read what was printed before: an assertion of yours or of the standard library failed, or abort was called."};
  if (reply.signal == SIGFPE)
    return {sentence_on(name), "Look for a whole number that is divided by a variable which can be 0."};
  return {sentence_on(name),
          "Look for an index beyond the end, a reference to something that is gone, or a recursion without an end."};
}

std::string thrown(const Reply& reply) {
  if (reply.eigen) return "Eigen stopped the calculation: " + sentence_on_eigen(*reply.eigen) + ".";
  if (reply.cause == CrashCause::foreign_exception) return "it is no std::exception and says nothing.";
  return reply.text.empty() ? "it says nothing." : quoted(reply.text);
}

std::string sentence(ProtocolViolation violation) {
  // In the order of ProtocolViolation.
  constexpr std::array sentences = {"what came back is not a reply",
                                    "a reply came that does not belong to the request",
                                    "a reply came before its request was read",
                                    "a reply has an impossible shape",
                                    "a reply has an unknown status",
                                    "more came back than one reply",
                                    "something came back after the last reply",
                                    "the connection to the checker was closed"};
  return sentences.at(static_cast<std::size_t>(violation));
}

struct ForbiddenCalls {
  const char* purpose;
  std::vector<long> numbers;
};

const std::vector<ForbiddenCalls>& forbidden_calls() {
#if defined(__x86_64__)
  constexpr long open = SYS_open, fork = SYS_fork, vfork = SYS_vfork, unlink = SYS_unlink, rename = SYS_rename;
#else
  constexpr long open = SYS_openat, fork = SYS_clone, vfork = fork, unlink = SYS_unlinkat, rename = SYS_renameat2;
#endif
  static const std::vector<ForbiddenCalls> calls = {
      {"open a file", {open, SYS_openat}},
      {"look for a file", {SYS_newfstatat}},
      {"change files or folders", {unlink, rename, SYS_unlinkat, SYS_renameat2, SYS_mkdirat}},
      {"start a thread or another process", {fork, vfork, SYS_clone, 435}},
      {"start another program", {SYS_execve, SYS_execveat}},
      {"open a connection", {SYS_socket, SYS_socketpair, SYS_connect}},
      {"send a signal to another process", {SYS_kill, SYS_tkill, SYS_tgkill}},
      {"look into another process", {SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev}}};
  return calls;
}

}  // namespace

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 300;
  std::string line = cut(text, longest) + (text.size() > longest ? " …" : "");
  std::ranges::replace(line, '\n', ' ');
  return line;
}

std::string sentence_on_eigen(const std::string& condition) {
  const EigenRule* const rule = rule_of(condition);
  return rule == nullptr ? "this does not hold: " + quoted(condition) : rule->sentence;
}

std::string kind_of_eigen(const std::string& condition) {
  const EigenRule* const rule = rule_of(condition);
  return rule == nullptr ? "eigen_assertion" : rule->kind;
}

std::string forbidden_operation(long system_call) {
  for (const auto& [purpose, numbers] : forbidden_calls())
    if (std::ranges::find(numbers, system_call) != numbers.end()) return purpose;
  return fmt::format("make system call number {}", system_call);
}

Advice advice_on_ending(const std::string& when, const Reply& reply, const std::string& signature) {
  const char* const function_only =
      "Let the file hold the function and its helpers only, and let it return its result.";
  switch (reply.ending) {
    case Ending::returned:
      break;
    case Ending::not_started:
      return {fmt::format("The function still reports that it is not started {}, but not everywhere.", when),
              "Remove what is left of the TODO, so that every way through the function returns a result."};
    case Ending::exception:
      return {fmt::format("The function threw an exception {}: {}", when, thrown(reply)),
              reply.eigen ? "Check the indices and sizes in the line that it names, and print them if in doubt."
                          : "Look for what throws it, and print the inputs of this case if in doubt."};
    case Ending::wrong_shape:
      return {fmt::format("The result has the wrong shape {}.", when),
              "Read in the header which shape is asked for: " + signature + "."};
    case Ending::crashed:
      return crashed(when, reply);
    case Ending::stopped_early:
      return {fmt::format("The program stopped {} before the function returned, with exit status {}.", when,
                          reply.exit_status),
              "Remove calls such as exit or abort: a function hands its result back with return."};
    case Ending::time_limit:
      return {fmt::format("The function did not return in time {}.", when),
              "Look for a loop that never ends, or for a step that is far too small."};
    case Ending::memory_limit:
      return {fmt::format("The function asked for more memory than an exercise may use {}.", when),
              "Look for a size computed from the wrong number, or for a list that grows in every step."};
    case Ending::output_limit:
      return {fmt::format("The function printed more than the checker reads {}.", when),
              "Remove the printing, or keep it out of the loop."};
    case Ending::forbidden_operation:
      return {fmt::format("The function tried something that no exercise needs {}{}.", when,
                          reply.signal == SIGXFSZ ? ": write a file"
                          : reply.system_call < 0 ? ""
                                                  : ": " + forbidden_operation(reply.system_call)),
              "Compute the result from the arguments alone: no files, no network, no other programs."};
    case Ending::protocol_violation:
      return {fmt::format("Something other than the function answered {}: {}.", when, sentence(reply.violation)),
              function_only};
    case Ending::not_run:
      return {
          fmt::format("The time for this exercise was used up before the function could be run {}.", when),
          "Make the function faster: look for steps that are far too small, or for work that is done again and again."};
  }
  return {};
}

}  // namespace workbook
