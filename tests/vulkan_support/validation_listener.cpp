// Fails every test case during which the validation layer had something to say.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include "host/vulkan/validation.h"

namespace {

class ValidationListener : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;

  // Sections end before their assertions are counted (and a case is itself one), so that a failure here is the case's.
  void sectionEnded(const Catch::SectionStats& stats) override {
    for (const std::string& message : candela::vulkan::validationMessages()) {
      FAIL_CHECK("validation layer: " << message);
    }
    candela::vulkan::clearValidationMessages();
    TestEventListenerBase::sectionEnded(stats);
  }
};

CATCH_REGISTER_LISTENER(ValidationListener)

}  // namespace
