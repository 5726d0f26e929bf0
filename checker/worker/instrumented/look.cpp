#include "checker/worker/instrumented/look.hpp"

#include "checker/worker/instrumented/eyes.hpp"
#include "checker/worker/instrumented/memory.hpp"
#include "checker/worker/instrumented/sighting.hpp"
#include "checker/worker/requests.hpp"

#include <rigid/vocabulary.hpp>

#include <cfenv>
#include <cstdlib>
#include <exception>
#include <new>

namespace workbook {
namespace {

using sightings::Question;
using sightings::Traps;
using sightings::What;

Question question;

void set_traps(Traps traps) {
  std::feclearexcept(FE_ALL_EXCEPT);
  if (traps != Traps::none) ::feenableexcept(FE_INVALID);
  if (traps == Traps::non_finite) ::feenableexcept(FE_DIVBYZERO | FE_OVERFLOW);
}

std::uint64_t ready(void* result, std::size_t size) {
  paint(result, size, question.paint);
  paint_new_memory(question.paint);
  watch();
  set_traps(question.traps);
  return question.paint;
}

void done() {
  ::fedisableexcept(FE_ALL_EXCEPT);
  stop_watching();
}

}  // namespace

int witness(std::size_t argument_count, const WitnessedCall& call) {
  Arguments arguments;
  if (!read_exactly(&question, sizeof question) || question.magic != sightings::question_magic ||
      question.arguments != static_cast<std::int32_t>(argument_count) || !arguments.read(argument_count))
    return 1;
  open_eyes(question.nonce);
  try {
    const WitnessedResult result = call(arguments.views, ready, done);
    say_returned(result.rows, result.cols, result.numbers.data());
  } catch (const rigid::NotStarted&) {
    done();
    say(What::not_started, "");
  } catch (const EigenError& error) {
    done();
    say_thrown(What::eigen_assertion, error.what(), &error);
  } catch (const std::bad_alloc& error) {
    done();
    say_thrown(What::out_of_memory, "", &error);
  } catch (const std::exception& error) {
    done();
    say_thrown(What::exception, error.what(), &error);
  } catch (...) {
    done();
    say_thrown(What::exception, "", nullptr);
  }
  std::_Exit(0);
}

}  // namespace workbook
