#include "cli/refusal.hpp"

#include <exception>
#include <new>

#include "geometry/error.hpp"
#include "oracle/checked.hpp"
#include "oracle/environment.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

Refusal caught_refusal() {
  try {
    throw;
  } catch (const Refusal& known) {
    return known;
  } catch (const Error& mistake) {
    return {mistaken, mistake.what()};
  } catch (const NothingAudited& why) {
    return {nothing_audited, why.what()};
  } catch (const NoAnswer& why) {
    return {found, why.what()};
  } catch (const oracle::UnfitArithmetic& flaw) {
    return {unfit, flaw.what()};
  } catch (const oracle::Disagreement& flaw) {
    return {unfit, flaw.what()};
  } catch (const std::bad_alloc&) {
    return {mistaken, "there is not enough memory"};
  } catch (const std::exception& fault) {
    return {mistaken, std::string("the system refused: ") + fault.what()};
  }
}

}  // namespace rayaudit
