#include "checker/sandbox/run_look.hpp"

#include "checker/base/child_process.hpp"
#include "checker/sandbox/request_bytes.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace workbook {
namespace {

using sightings::Question;
using sightings::Sighting;
using sightings::What;

constexpr std::size_t most_sightings = 64;
constexpr std::int32_t most_numbers = 100'000;

bool ends_the_call(What what) { return what != What::undefined_behavior && what != What::still_running; }

/// A conversation with one witness.
class Conversation {
 public:
  Conversation(Sandbox& sandbox, const LookLimits& limits)
      : limits_(limits), process_(launch(sandbox, limits)), deadline_(after(limits.time)) {}

  Look ask(const std::vector<Value>& inputs, Paint paint, sightings::Traps traps) {
    nonce_ = random_nonce();
    const Question question{sightings::question_magic, nonce_, static_cast<std::int32_t>(inputs.size()), traps,
                            static_cast<std::uint64_t>(paint)};
    append_bytes(unsent_, &question);
    append_arguments(unsent_, inputs);
    while (!over_) exchange();
    process_.kill();
    return believable_ ? std::move(look_) : Look{};
  }

 private:
  static Launch launch(Sandbox& sandbox, const LookLimits& limits) {
    Launch launch;
    launch.program = sandbox.program();
    launch.with_channel = true;
    const auto seconds = static_cast<unsigned>(std::ceil(limits.time.count())) + 1;
    launch.prepare = [&sandbox, seconds] { return sandbox.enter(seconds); };
    return launch;
  }

  static Clock::time_point after(std::chrono::duration<double> time) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  }

  void exchange() {
    const bool sending = sent_ < unsent_.size();
    std::array<pollfd, 2> watched{{{process_.channel(), static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0},
                                   {process_.output(), POLLIN, 0}}};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    ::poll(watched.data(), output_closed_ ? 1 : 2, static_cast<int>(std::clamp<long>(left, 0, 10'000)));
    if (!output_closed_ && watched[1].revents != 0) drop_output();
    if ((watched[0].revents & POLLOUT) != 0) send_some();
    if ((watched[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0) receive_some();
    if (Clock::now() >= deadline_) ask_where_it_is();
  }

  void ask_where_it_is() {
    look_.out_of_time = !look_.too_much_output;
    // One turn more than questions, to hear the last answer.
    if (questions_++ >= limits_.questions) {
      over_ = true;
      return;
    }
    process_.signal(SIGALRM);
    deadline_ = after(limits_.between_questions);
  }

  void send_some() {
    const ssize_t put =
        ::send(process_.channel(), unsent_.data() + sent_, unsent_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (put > 0) sent_ += static_cast<std::size_t>(put);
    if (put < 0 && errno != EAGAIN && errno != EINTR) sent_ = unsent_.size();
  }

  void receive_some() {
    std::array<char, 16384> buffer;
    const ssize_t got = ::recv(process_.channel(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (got <= 0) {
      over_ = true;
      return;
    }
    received_.insert(received_.end(), buffer.begin(), buffer.begin() + got);
    understand();
  }

  /// Takes complete sightings from what was received.
  void understand() {
    while (believable_ && received_.size() >= sizeof(Sighting)) {
      Sighting sighting;
      std::memcpy(&sighting, received_.data(), sizeof sighting);
      std::size_t size = sizeof sighting;
      if (sighting.what == What::returned) size += sizeof(double) * numbers_of(sighting);
      if (!is_plausible(sighting)) return disbelieve();
      if (received_.size() < size) return;
      if (sighting.what == What::returned) {
        Value value{sighting.rows, sighting.cols, std::vector<double>(numbers_of(sighting))};
        std::memcpy(value.numbers.data(), received_.data() + sizeof sighting, size - sizeof sighting);
        look_.result = std::move(value);
      }
      sighting.text[sizeof sighting.text - 1] = '\0';
      sighting.more_text[sizeof sighting.more_text - 1] = '\0';
      look_.sightings.push_back(sighting);
      received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(size));
    }
  }

  static std::size_t numbers_of(const Sighting& sighting) {
    if (sighting.rows < 0 || sighting.cols < 0 || sighting.rows > most_numbers || sighting.cols > most_numbers)
      return 0;
    return static_cast<std::size_t>(sighting.rows) * static_cast<std::size_t>(sighting.cols);
  }

  bool is_plausible(const Sighting& sighting) const {
    constexpr int most_calls = sizeof sighting.calls / sizeof *sighting.calls;
    return sighting.magic == sightings::sighting_magic && sighting.nonce == nonce_ && sighting.fact_count >= 0 &&
           sighting.fact_count <= Facts::most && sighting.call_count >= 0 && sighting.call_count <= most_calls &&
           sighting.rows >= 0 && sighting.cols >= 0 && numbers_of(sighting) <= std::size_t{most_numbers} &&
           look_.sightings.size() < most_sightings;
  }

  void disbelieve() {
    believable_ = false;
    over_ = true;
  }

  void drop_output() {
    std::array<char, 16384> buffer;
    const ssize_t got = ::read(process_.output(), buffer.data(), buffer.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (got <= 0) {
      output_closed_ = true;
      return;
    }
    printed_ += static_cast<std::size_t>(got);
    if (printed_ <= limits_.output_bytes || look_.too_much_output) return;
    look_.too_much_output = true;
    deadline_ = Clock::now();
  }

  const LookLimits& limits_;
  ChildProcess process_;
  Clock::time_point deadline_;
  std::uint64_t nonce_ = 0;
  std::vector<char> unsent_;
  std::size_t sent_ = 0;
  std::vector<char> received_;
  std::size_t printed_ = 0;
  int questions_ = 0;
  bool output_closed_ = false;
  bool believable_ = true;
  bool over_ = false;
  Look look_;
};

bool is_same_number(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

}  // namespace

bool is_painted(double number) {
  return std::bit_cast<std::uint64_t>(number) == static_cast<std::uint64_t>(Paint::signalling);
}

const Sighting* Look::end() const {
  const auto found = std::ranges::find_if(sightings, [](const Sighting& one) { return ends_the_call(one.what); });
  return found == sightings.end() ? nullptr : &*found;
}

bool Look::operator==(const Look& other) const {
  if (out_of_time != other.out_of_time || result.has_value() != other.result.has_value()) return false;
  if ((end() == nullptr) != (other.end() == nullptr)) return false;
  if (end() != nullptr && (end()->what != other.end()->what || end()->signal != other.end()->signal)) return false;
  return !result || (result->has_shape_of(*other.result) &&
                     std::ranges::equal(result->numbers, other.result->numbers, is_same_number));
}

Look run_look(const std::filesystem::path& witness, const std::vector<Value>& inputs, Paint paint,
              sightings::Traps traps, const LookLimits& limits) {
  Sandbox sandbox(witness, limits.sandbox);
  return Conversation(sandbox, limits).ask(inputs, paint, traps);
}

}  // namespace workbook
