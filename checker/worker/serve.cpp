#include "checker/worker/serve.hpp"

#include "checker/worker/crash_handler.hpp"
#include "checker/worker/prelude.hpp"
#include "checker/worker/protocol.hpp"
#include "checker/worker/requests.hpp"

#include <rigid/vocabulary.hpp>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace workbook {
namespace {

bool write_exactly(const void* from, std::size_t size) {
  const char* next = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t put = ::write(protocol::channel, next, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    next += put;
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

void set_text(protocol::ReplyHeader& reply, const char* text) {
  std::strncpy(reply.text, text ? text : "", sizeof reply.text - 1);
}

protocol::ReplyHeader answer(const Call& call, const Arguments& arguments, CallResult& result) {
  protocol::ReplyHeader reply{};
  reply.magic = protocol::reply_magic;
  try {
    call(arguments.views, result);
    reply.status = result.has_expected_shape() ? protocol::Status::returned : protocol::Status::wrong_shape;
    reply.result = {result.rows, result.cols};
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
  return reply;
}

}  // namespace

int serve_calls(std::size_t argument_count, const Call& call) {
  // What a student prints before a crash should be seen: do not keep whole pages of it back.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  keep_crash_handler_linked();
  Arguments arguments;
  protocol::RequestHeader request;
  while (read_exactly(&request, sizeof request)) {
    if (request.magic != protocol::request_magic || request.arguments != static_cast<std::int32_t>(argument_count))
      return 1;
    if (!arguments.read(argument_count)) return 1;
    CallResult result;
    result.expected_rows = request.result.rows;
    result.expected_cols = request.result.cols;
    protocol::ReplyHeader reply = answer(call, arguments, result);
    reply.nonce = request.nonce;
    std::fflush(stdout);
    if (!write_exactly(&reply, sizeof reply)) return 1;
    if (reply.status == protocol::Status::returned &&
        !write_exactly(result.numbers.data(), result.numbers.size() * sizeof(double)))
      return 1;
  }
  // Not `return 0`: destructors of a student's static objects are no part of the exercise.
  std::_Exit(0);
}

}  // namespace workbook
