#include "checker/sandbox/worker_process.hpp"

#include "checker/base/text.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>

namespace workbook {
namespace {

static_assert(protocol::channel == channel_descriptor);

constexpr std::chrono::milliseconds between_looks_at_memory{20};

template <class T>
void append(std::vector<char>& bytes, const T* first, std::size_t count = 1) {
  const char* begin = reinterpret_cast<const char*>(first);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

/// Tells a request from all others. Never 0: what was not asked has that one.
std::uint64_t random_nonce() {
  static std::random_device device;  // opening one takes longer than most calls
  return (std::uint64_t{device()} << 32) | device() | 1;
}

std::vector<char> request(const PlannedCall& call, std::uint64_t nonce, std::int32_t mode) {
  const protocol::RequestHeader header{
      protocol::request_magic, nonce, static_cast<std::int32_t>(call.inputs.size()), {call.rows, call.cols}, mode};
  std::vector<char> bytes;
  append(bytes, &header);
  for (const Value& input : call.inputs) {
    const protocol::Shape shape{input.rows, input.cols};
    append(bytes, &shape);
  }
  for (const Value& input : call.inputs) append(bytes, input.numbers.data(), input.numbers.size());
  return bytes;
}

protocol::ReplyHeader header_in(const std::vector<char>& bytes) {
  protocol::ReplyHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.text[sizeof header.text - 1] = '\0';
  return header;
}

Launch launch(const Program& program, const SandboxProfile& profile) {
  Launch launch;
  launch.program = program.file.string();
  launch.opened = program.opened;
  launch.with_channel = true;
  confine(launch, profile);
  return launch;
}

SandboxProfile within(SandboxProfile profile, const Budget& budget) {
  profile.processor_seconds = static_cast<unsigned>(std::max(1.0, std::ceil(budget.processor_seconds)));
  return profile;
}

}  // namespace

Worker::Worker(const Program& program, SandboxProfile profile, Budget& budget)
    : budget_(budget), profile_(within(std::move(profile), budget)), process_(launch(program, profile_)) {}

Reply Worker::call(const PlannedCall& call, std::int32_t mode) {
  const std::uint64_t nonce = random_nonce();
  unsent_ = request(call, nonce, mode);
  sent_ = 0;
  received_.clear();
  Reply reply = answer(call, nonce);
  reply.printed = printable(printed_);
  printed_.clear();
  if (reply.ending == Ending::memory_limit) end_process();  // after bad_alloc its state is unknown
  return reply;
}

Reply Worker::answer(const PlannedCall& call, std::uint64_t nonce) {
  if (const Ending end = receive_header(); end != Ending::returned) return stopped(end);
  const protocol::ReplyHeader header = header_in(received_);
  if (header.magic != protocol::reply_magic) return violated(ProtocolViolation::not_a_reply);
  if (header.nonce != nonce) return violated(ProtocolViolation::another_request);
  if (sent_ < unsent_.size()) return violated(ProtocolViolation::too_early);

  Reply reply{.ending = Ending::exception};
  switch (header.status) {
    case protocol::Status::returned:
      reply = returned(header, call);
      if (reply.ending != Ending::returned) return reply;
      break;
    case protocol::Status::wrong_shape:
      if (header.result.rows < 0 || header.result.cols < 0 ||
          (header.result.rows == call.rows && header.result.cols == call.cols))
        return violated(ProtocolViolation::impossible_shape);
      reply = {.ending = Ending::wrong_shape, .value = {header.result.rows, header.result.cols, {}}};
      break;
    case protocol::Status::not_started:
      reply.ending = Ending::not_started;
      break;
    case protocol::Status::out_of_memory:
      reply.ending = Ending::memory_limit;
      break;
    case protocol::Status::exception:
    case protocol::Status::foreign_exception:
      reply.text = printable(header.text);
      if (header.status == protocol::Status::foreign_exception) reply.cause = CrashCause::foreign_exception;
      break;
    case protocol::Status::eigen_assertion:
      reply.eigen = printable(header.text);
      break;
    default:
      return violated(ProtocolViolation::unknown_status);
  }
  char byte;
  if (::recv(process_.channel(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) > 0)
    return violated(ProtocolViolation::second_reply);
  if (const Ending end = collect_prints(); end != Ending::returned) return stopped(end);
  return reply;
}

Reply Worker::returned(const protocol::ReplyHeader& header, const PlannedCall& call) {
  if (header.result.rows != call.rows || header.result.cols != call.cols)
    return violated(ProtocolViolation::impossible_shape);
  const std::size_t count = static_cast<std::size_t>(call.rows) * static_cast<std::size_t>(call.cols);
  if (const Ending end = exchange(sizeof header + sizeof(double) * count); end != Ending::returned) return stopped(end);
  Reply reply{.ending = Ending::returned, .value = {call.rows, call.cols, std::vector<double>(count)}};
  std::copy(received_.begin() + sizeof header, received_.end(), reinterpret_cast<char*>(reply.value.numbers.data()));
  return reply;
}

Reply Worker::finish() {
  Reply reply{.ending = Ending::returned};
  if (!running_) return reply;
  process_.close_write();
  unsent_.clear();
  sent_ = 0;
  received_.clear();
  const Clock::time_point deadline = budget_.deadline;
  budget_.deadline = std::min(deadline, Clock::now() + limits::end);
  const Ending end = exchange(1);
  budget_.deadline = deadline;
  if (end == Ending::returned) return violated(ProtocolViolation::after_last_reply);
  end_process();
  if (end == Ending::output_limit || collect_prints() == Ending::output_limit) reply.ending = Ending::output_limit;
  return reply;
}

Ending Worker::receive_header() {
  while (true) {
    if (const Ending end = exchange(sizeof(protocol::ReplyHeader)); end != Ending::returned) return end;
    const protocol::ReplyHeader header = header_in(received_);
    const bool crashes = header.magic == protocol::reply_magic && header.status == protocol::Status::crash_report;
    if (!crashes || crash_report_) return Ending::returned;
    crash_report_ = header;  // now the signal should follow, and end the stream
    received_.clear();
  }
}

Ending Worker::exchange(std::size_t wanted) {
  const bool watches_memory = profile_.memory_bytes == 0;
  while (received_.size() < wanted) {
    const bool sending = sent_ < unsent_.size();
    std::array<pollfd, 2> watched{{{process_.channel(), static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0},
                                   {process_.output(), POLLIN, 0}}};
    const auto wake =
        watches_memory ? std::min(budget_.deadline, Clock::now() + between_looks_at_memory) : budget_.deadline;
    // A worker that closed its standard output would wake us for ever.
    const int ready = ::poll(watched.data(), output_closed_ ? 1 : 2, milliseconds_until(wake));
    if (ready < 0 && errno == EINTR) continue;
    // Where something came, it was in time: only we may have waited for a processor.
    if (ready <= 0 && Clock::now() >= budget_.deadline && !extend_deadline()) return Ending::time_limit;
    if (watches_memory && uses_too_much_memory()) return Ending::memory_limit;
    if (ready <= 0) continue;
    if (!output_closed_ && watched[1].revents != 0)
      if (const Ending end = collect_prints(); end != Ending::returned) return end;
    if ((watched[0].revents & POLLOUT) != 0) send_some();
    if ((watched[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0)
      if (const Ending end = receive_some(wanted); end != Ending::returned) return end;
  }
  return Ending::returned;
}

void Worker::send_some() {
  const ssize_t put =
      ::send(process_.channel(), unsent_.data() + sent_, unsent_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (put > 0) sent_ += static_cast<std::size_t>(put);
  // If the worker has closed its end, the end of the stream will say so.
  if (put < 0 && errno != EAGAIN && errno != EINTR) sent_ = unsent_.size();
}

Ending Worker::receive_some(std::size_t wanted) {
  const std::size_t before = received_.size();
  received_.resize(wanted);
  const ssize_t got = ::recv(process_.channel(), received_.data() + before, wanted - before, MSG_DONTWAIT);
  received_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  if (got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR))) return Ending::returned;
  return Ending::stopped_early;
}

Ending Worker::collect_prints() {
  std::array<char, 16384> buffer;
  while (!output_closed_) {
    const ssize_t got = ::read(process_.output(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) break;
    output_closed_ = got <= 0;
    const std::size_t kept = std::min(static_cast<std::size_t>(std::max<ssize_t>(got, 0)), budget_.output_bytes);
    printed_.append(buffer.data(), kept);
    budget_.output_bytes -= kept;
    if (got > static_cast<ssize_t>(kept)) return Ending::output_limit;
  }
  return Ending::returned;
}

bool Worker::extend_deadline() {
  // Nanoseconds on a processor, and waiting for one.
  std::ifstream statistics("/proc/" + std::to_string(process_.number()) + "/schedstat");
  std::int64_t running = 0, waiting = 0;
  statistics >> running >> waiting;
  const Clock::duration more = std::chrono::nanoseconds(waiting) - extended_;
  if (more < std::chrono::milliseconds(5)) return false;
  budget_.deadline += more;
  extended_ += more;
  return true;
}

bool Worker::uses_too_much_memory() const {
  std::ifstream statistics("/proc/" + std::to_string(process_.number()) + "/statm");
  std::size_t pages = 0, resident_pages = 0;
  statistics >> pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) > limits::diagnostic_memory;
}

Reply Worker::violated(ProtocolViolation violation) {
  end_process();
  return {.ending = Ending::protocol_violation, .violation = violation};
}

Reply Worker::stopped(Ending reason) {
  if (reason != Ending::stopped_early) {
    end_process();
    return {.ending = reason};
  }
  const auto ends_within = [&](Clock::duration time) { return process_.wait_until(Clock::now() + time).has_value(); };
  if (!ends_within(limits::end) && (process_.is_running() || !ends_within(limits::clearing_up)))
    return violated(ProtocolViolation::closed_channel);
  const ProcessEnd end = end_process();
  if (collect_prints() == Ending::output_limit) return {.ending = Ending::output_limit};
  // A program that ignores SIGXCPU is killed at the hard limit.
  const bool is_out_of_time =
      end.signal == SIGXCPU || (end.signal == SIGKILL && end.processor_seconds >= profile_.processor_seconds);
  const Ending ending = end.signal == 0                                 ? Ending::stopped_early
                        : end.signal == SIGSYS || end.signal == SIGXFSZ ? Ending::forbidden_operation
                        : is_out_of_time                                ? Ending::time_limit
                                                                        : Ending::crashed;
  Reply reply{.ending = ending, .signal = end.signal, .exit_status = end.exit_status};
  if (!crash_report_ || crash_report_->signal != end.signal) return reply;
  // What the worker said before the signal.
  const auto detail = crash_report_->detail;
  if (end.signal == SIGSYS) {
    reply.system_call = static_cast<long>(detail);
  } else if (detail == protocol::stack_overflow) {
    reply.cause = CrashCause::stack_overflow;
  } else if (detail != protocol::nothing_known) {
    const bool has_text = detail == protocol::exception_with_text;
    reply.cause = has_text ? CrashCause::uncaught_exception : CrashCause::foreign_exception;
    reply.text = printable(crash_report_->text);
  }
  return reply;
}

ProcessEnd Worker::end_process() {
  const ProcessEnd end = process_.kill();
  if (running_) budget_.processor_seconds -= end.processor_seconds;
  running_ = false;
  return end;
}

namespace {

/// A sequence of calls in as few processes as possible: one, and a new one after each that failed.
class Session {
 public:
  Session(const Program& executable, const RunLimits& limits)
      : executable_(executable),
        profile_(limits.sandbox),
        budget_{Clock::now() + std::chrono::duration_cast<Clock::duration>(limits.time), limits.processor_time.count(),
                limits.output_bytes} {}

  Reply call(const PlannedCall& call) {
    Reply reply;
    if (used_up_) return reply;
    reply.ending = Ending::time_limit;
    if (budget_.processor_seconds > 0.0 && Clock::now() < budget_.deadline) {
      if (!worker_) worker_.emplace(executable_, profile_, budget_);
      reply = worker_->call(call);
    }
    after(reply);
    return reply;
  }

  /// Ends the process; the next call gets a fresh one. `last`, the reply to the last call, is replaced if something
  /// came after it.
  void finish_process(Reply& last) {
    if (!worker_) return;
    Reply end = worker_->finish();
    after(end);
    worker_.reset();
    if (end.ending == Ending::returned) return;
    end.printed = last.printed;
    last = std::move(end);
  }

 private:
  void after(const Reply& reply) {
    if (worker_ && !worker_->running()) worker_.reset();
    if (reply.ending == Ending::time_limit || reply.ending == Ending::output_limit) used_up_ = true;
  }

  const Program& executable_;
  const SandboxProfile& profile_;
  Budget budget_;
  std::optional<Worker> worker_;
  bool used_up_ = false;
};

}  // namespace

Observation ExerciseRunner::observe(const std::vector<PlannedCall>& calls, const std::vector<std::size_t>& repeats) {
  const Clock::time_point start = Clock::now();
  Observation observation;
  try {
    Session session(executable_, limits_);
    for (const PlannedCall& call : calls) observation.replies.push_back(session.call(call));
    if (!calls.empty()) session.finish_process(observation.replies.back());
    for (const std::size_t index : repeats) observation.repeats.push_back({index, session.call(calls.at(index))});
    if (!repeats.empty()) session.finish_process(observation.repeats.back().reply);
  } catch (const LaunchError& error) {
    observation = {};
    observation.refusal = Refusal::checker_error;
    observation.refusal_message =
        fmt::format("The checker could not run the compiled function ({}); this is not your mistake.", error.what());
  }
  observation.run_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return observation;
}

std::vector<Reply> ExerciseRunner::evaluate(const std::vector<PlannedCall>& calls) {
  Session session(executable_, limits_);
  std::vector<Reply> replies;
  replies.reserve(calls.size());
  for (const PlannedCall& call : calls) replies.push_back(session.call(call));
  if (!replies.empty()) session.finish_process(replies.back());
  return replies;
}

}  // namespace workbook
