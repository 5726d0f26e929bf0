#include "checker/sandbox/worker_process.hpp"

#include "checker/base/printable.hpp"
#include "checker/messages/running.hpp"
#include "checker/sandbox/request_bytes.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace workbook {
namespace {

/// How long a worker may take to end after it closed the channel or was told that no more comes.
constexpr std::chrono::milliseconds shutdown_timeout{500};

std::vector<char> request(const std::vector<Value>& inputs, protocol::Shape result, std::uint64_t nonce) {
  const protocol::RequestHeader header{protocol::request_magic, nonce, static_cast<std::int32_t>(inputs.size()), result,
                                       0};
  std::vector<char> bytes;
  append_bytes(bytes, &header);
  append_arguments(bytes, inputs);
  return bytes;
}

protocol::ReplyHeader header_in(const std::vector<char>& bytes) {
  protocol::ReplyHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.text[sizeof header.text - 1] = '\0';
  return header;
}

/// What the last words before a signal say, the system call aside.
std::string text_of_crash(const protocol::ReplyHeader& crash_report) {
  if (crash_report.signal == SIGSEGV && crash_report.detail == protocol::stack_used_up)
    return messages::stack_is_used_up();
  if (crash_report.signal == SIGABRT && crash_report.detail == protocol::foreign_exception)
    return messages::foreign_exception();
  return printable(crash_report.text);
}

Launch launch(Sandbox& sandbox, unsigned processor_seconds) {
  Launch launch;
  launch.program = sandbox.program();
  launch.with_channel = true;
  launch.prepare = [&sandbox, processor_seconds] { return sandbox.enter(processor_seconds); };
  return launch;
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, 3'600'000));
}

}  // namespace

Worker::Worker(Sandbox& sandbox, Budget& budget)
    : budget_(budget),
      processor_seconds_(static_cast<unsigned>(std::max(1.0, std::ceil(budget.processor_seconds)))),
      process_(launch(sandbox, processor_seconds_)) {}

Worker::~Worker() { end_process(); }

Reply Worker::call(const std::vector<Value>& inputs, int rows, int cols) {
  const std::uint64_t nonce = random_nonce();
  unsent_ = request(inputs, {rows, cols}, nonce);
  sent_ = 0;
  received_.clear();
  if (const Stop stop = receive_header(); stop != Stop::none) return stopped(stop);

  const protocol::ReplyHeader header = header_in(received_);
  if (header.magic != protocol::reply_magic) return violation(messages::not_a_reply());
  if (header.nonce != nonce) return violation(messages::reply_to_something_else());
  if (sent_ < unsent_.size()) return violation(messages::reply_too_early());

  Reply reply;
  switch (header.status) {
    case protocol::Status::returned:
      if (header.result.rows != rows || header.result.cols != cols)
        return violation(messages::reply_of_impossible_shape());
      if (const Stop stop = exchange(received_.size() +
                                     sizeof(double) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
          stop != Stop::none)
        return stopped(stop);
      reply = returned_value(header, rows, cols);
      break;
    case protocol::Status::wrong_shape:
      if (header.result.rows < 0 || header.result.cols < 0 ||
          (header.result.rows == rows && header.result.cols == cols))
        return violation(messages::reply_of_impossible_shape());
      reply.ending = Ending::wrong_shape;
      reply.value = {header.result.rows, header.result.cols, {}};
      break;
    case protocol::Status::not_started:
      reply.ending = Ending::not_started;
      break;
    case protocol::Status::exception:
      reply.ending = Ending::exception;
      reply.text = printable(header.text);
      break;
    case protocol::Status::foreign_exception:
      reply.ending = Ending::exception;
      reply.text = messages::foreign_exception();
      break;
    case protocol::Status::eigen_assertion:
      reply.ending = Ending::exception;
      reply.text = messages::eigen_stopped(printable(header.text));
      break;
    case protocol::Status::out_of_memory:
      reply.ending = Ending::memory_limit;
      break;
    default:
      return violation(messages::reply_of_unknown_status());
  }
  if (has_more_to_say()) return violation(messages::more_than_one_reply());
  if (const Stop stop = collect_prints(); stop != Stop::none) return stopped(stop);
  if (reply.ending == Ending::memory_limit) end_process();  // what else it could not allocate, nobody knows
  return reply;
}

Reply Worker::finish() {
  Reply reply;
  reply.ending = Ending::returned;
  if (!running_) return reply;
  process_.hang_up();
  unsent_.clear();
  sent_ = 0;
  received_.clear();
  const Clock::time_point deadline = budget_.deadline;
  budget_.deadline = std::min(deadline, Clock::now() + shutdown_timeout);
  const Stop stop = exchange(1);
  budget_.deadline = deadline;
  if (stop == Stop::none) return violation(messages::something_after_last_reply());
  end_process();
  return stop == Stop::output_limit || collect_prints() == Stop::output_limit ? stopped(Stop::output_limit) : reply;
}

Reply Worker::returned_value(const protocol::ReplyHeader& header, int rows, int cols) {
  Reply reply;
  reply.ending = Ending::returned;
  reply.value = {rows, cols, std::vector<double>((received_.size() - sizeof header) / sizeof(double))};
  std::copy(received_.begin() + sizeof header, received_.end(), reinterpret_cast<char*>(reply.value.numbers.data()));
  return reply;
}

Worker::Stop Worker::receive_header() {
  while (true) {
    if (const Stop stop = exchange(sizeof(protocol::ReplyHeader)); stop != Stop::none) return stop;
    const protocol::ReplyHeader header = header_in(received_);
    const bool is_last_words = header.magic == protocol::reply_magic && header.status == protocol::Status::crash_report;
    if (!is_last_words || crash_report_.magic != 0) return Stop::none;
    crash_report_ = header;  // now the signal should follow, and end the stream
    received_.clear();
  }
}

Worker::Stop Worker::exchange(std::size_t wanted) {
  while (received_.size() < wanted) {
    const bool sending = sent_ < unsent_.size();
    std::array<pollfd, 2> watched{{{process_.channel(), static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0},
                                   {process_.output(), POLLIN, 0}}};
    // A worker that closed its standard output would wake us for ever.
    const int ready = ::poll(watched.data(), output_closed_ ? 1 : 2, milliseconds_until(budget_.deadline));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return Stop::out_of_time;
    if (!output_closed_ && watched[1].revents != 0)
      if (const Stop stop = collect_prints(); stop != Stop::none) return stop;
    if ((watched[0].revents & POLLOUT) != 0) send_some();
    if ((watched[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0)
      if (const Stop stop = receive_some(wanted); stop != Stop::none) return stop;
    if (Clock::now() >= budget_.deadline) return Stop::out_of_time;
  }
  return Stop::none;
}

void Worker::send_some() {
  const ssize_t put =
      ::send(process_.channel(), unsent_.data() + sent_, unsent_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (put > 0) sent_ += static_cast<std::size_t>(put);
  // If nobody listens any more, the end of the stream will say so.
  if (put < 0 && errno != EAGAIN && errno != EINTR) sent_ = unsent_.size();
}

Worker::Stop Worker::receive_some(std::size_t wanted) {
  const std::size_t before = received_.size();
  received_.resize(wanted);
  const ssize_t got = ::recv(process_.channel(), received_.data() + before, wanted - before, MSG_DONTWAIT);
  received_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  if (got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR))) return Stop::none;
  return Stop::end_of_stream;
}

Worker::Stop Worker::collect_prints() {
  std::array<char, 16384> buffer;
  while (!output_closed_) {
    const ssize_t got = ::read(process_.output(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) break;
    if (got <= 0) {
      output_closed_ = true;
      break;
    }
    const std::size_t kept = std::min(static_cast<std::size_t>(got), budget_.output_bytes);
    budget_.printed.append(buffer.data(), kept);
    budget_.output_bytes -= kept;
    if (kept < static_cast<std::size_t>(got)) return Stop::output_limit;
  }
  return Stop::none;
}

bool Worker::has_more_to_say() const {
  char byte;
  return ::recv(process_.channel(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

Reply Worker::violation(const std::string& text) {
  end_process();
  Reply reply;
  reply.ending = Ending::protocol_violation;
  reply.text = text;
  return reply;
}

Reply Worker::stopped(Stop reason) {
  Reply reply;
  if (reason == Stop::out_of_time || reason == Stop::output_limit) {
    end_process();
    reply.ending = reason == Stop::out_of_time ? Ending::time_limit : Ending::output_limit;
    return reply;
  }
  const std::optional<ProcessEnd> ended =
      process_.wait_until(std::min(budget_.deadline, Clock::now() + shutdown_timeout));
  if (!ended) return violation(messages::line_closed());
  const ProcessEnd end = end_process();
  if (collect_prints() == Stop::output_limit) {
    reply.ending = Ending::output_limit;
    return reply;
  }
  reply.signal = end.signal;
  reply.exit_status = end.exit_status;
  const bool explained = crash_report_.magic != 0 && crash_report_.signal == end.signal;
  switch (end.signal) {
    case 0:
      reply.ending = Ending::stopped_early;
      break;
    case SIGSYS:
      reply.ending = Ending::forbidden_operation;
      if (explained) reply.text = forbidden_operation(crash_report_.detail);
      break;
    case SIGXFSZ:
      reply.ending = Ending::forbidden_operation;
      reply.text = messages::writing_a_file();
      break;
    case SIGXCPU:
      reply.ending = Ending::time_limit;
      break;
    default:
      // A program that ignores SIGXCPU is killed at the hard limit.
      reply.ending =
          end.signal == SIGKILL && end.processor_seconds >= processor_seconds_ ? Ending::time_limit : Ending::crashed;
      if (explained) reply.text = text_of_crash(crash_report_);
  }
  return reply;
}

ProcessEnd Worker::end_process() {
  const ProcessEnd end = process_.kill();
  if (running_) budget_.processor_seconds -= end.processor_seconds;
  running_ = false;
  return end;
}

}  // namespace workbook
