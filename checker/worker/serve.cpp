#include "checker/worker/serve.hpp"

#include "checker/worker/prelude.hpp"
#include "checker/worker/protocol.hpp"

#include <rigid/vocabulary.hpp>

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

extern "C" int workbook_variant;  // which variant of the function is to be called, where there are several
int workbook_variant = 0;

namespace workbook {
namespace {

/// All bytes, through read() or write(). False at the end of input.
template <class Byte, class Transfer>
bool transfer(Transfer step, Byte* next, std::size_t size) {
  while (size > 0) {
    const ssize_t done = step(protocol::channel, next, size);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    next += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool receive(void* to, std::size_t size) { return transfer(::read, static_cast<char*>(to), size); }

bool send(const void* from, std::size_t size) { return transfer(::write, static_cast<const char*>(from), size); }

/// The arguments of one request, and the views of them that a call needs.
struct Arguments {
  std::vector<double> numbers;
  std::vector<NumbersView> views;

  /// So many shapes, and then their numbers.
  bool receive(std::size_t count) {
    std::vector<protocol::Shape> shapes(count);
    if (!workbook::receive(shapes.data(), count * sizeof(protocol::Shape))) return false;
    std::size_t total = 0;
    for (const protocol::Shape& shape : shapes) total += size(shape);
    numbers.resize(total);
    if (!workbook::receive(numbers.data(), total * sizeof(double))) return false;
    const double* first = numbers.data();
    views.clear();
    for (const protocol::Shape& shape : shapes) {
      views.push_back({shape.rows, shape.cols, first});
      first += size(shape);
    }
    return true;
  }

  static std::size_t size(const protocol::Shape& shape) {
    return static_cast<std::size_t>(shape.rows) * static_cast<std::size_t>(shape.cols);
  }
};

void set_text(protocol::ReplyHeader& reply, const char* text) {
  std::strncpy(reply.text, text ? text : "", sizeof reply.text - 1);
}

/// The exception that is being handled.
void set_exception(protocol::ReplyHeader& reply) {
  try {
    throw;
  } catch (const rigid::NotStarted&) {
    reply.status = protocol::Status::not_started;
  } catch (const std::bad_alloc&) {
    reply.status = protocol::Status::out_of_memory;
  } catch (const EigenError& error) {
    reply.status = protocol::Status::eigen_assertion;
    set_text(reply, error.what());
  } catch (const std::exception& error) {
    reply.status = protocol::Status::exception;
    set_text(reply, error.what());
  } catch (...) {
    reply.status = protocol::Status::foreign_exception;
  }
}

protocol::ReplyHeader answer(Call call, void (*function)(), const Arguments& arguments, CallResult& result) {
  protocol::ReplyHeader reply{};
  reply.magic = protocol::reply_magic;
  try {
    call(function, arguments.views.data(), result);
    reply.status = result.has_expected_shape() ? protocol::Status::returned : protocol::Status::wrong_shape;
    reply.result = {result.rows, result.cols};
  } catch (...) {
    after_call();
    set_exception(reply);
  }
  return reply;
}

}  // namespace

void throw_eigen_error(const char* condition) {
  // While `v << 1, f(), 3` is left because f threw, its destructor finds numbers missing; the first exception counts.
  if (std::uncaught_exceptions() == 0 ||
      std::string_view(condition).find("Too few coefficients") == std::string_view::npos)
    throw EigenError(condition);
}

[[gnu::weak]] void before_call(std::int32_t) {}
/// As -ftrivial-auto-var-init fills what is on the stack; a result is made in the place that its caller has for it.
[[gnu::weak]] void fill_memory(void* result, std::size_t size) { std::memset(result, 0xfe, size); }
[[gnu::weak]] void after_call() {}
[[gnu::weak]] void flush_streams() {}

double* CallResult::place_for(int rows_of_result, int cols_of_result) {
  rows = rows_of_result;
  cols = cols_of_result;
  if (!has_expected_shape()) return nullptr;
  numbers.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
  return numbers.data();
}

int serve_calls(std::size_t argument_count, Call call, void (*function)()) {
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // what is printed before a crash must be seen
  Arguments arguments;
  protocol::RequestHeader request;
  while (receive(&request, sizeof request)) {
    if (request.magic != protocol::request_magic || request.arguments != static_cast<std::int32_t>(argument_count))
      return 1;
    if (!arguments.receive(argument_count)) return 1;
    CallResult result;
    result.expected_rows = request.result.rows;
    result.expected_cols = request.result.cols;
    workbook_variant = request.mode >> protocol::variant_shift;
    before_call(request.mode);
    protocol::ReplyHeader reply = answer(call, function, arguments, result);
    reply.nonce = request.nonce;
    flush_streams();  // what the student's function prints belongs to this call
    if (!send(&reply, sizeof reply)) return 1;
    if (reply.status == protocol::Status::returned &&
        !send(result.numbers.data(), result.numbers.size() * sizeof(double)))
      return 1;
  }
  // Not `return 0`: destructors of a student's static objects are no part of the exercise.
  std::_Exit(0);
}

}  // namespace workbook

/// In place of the C library's, which from version 2.41 on holds back all signals meanwhile: then nobody could say
/// which call was forbidden. Weak, so that a file may have a function of that name.
extern "C" [[gnu::weak]] pid_t fork() {
  return static_cast<pid_t>(::syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr));
}
