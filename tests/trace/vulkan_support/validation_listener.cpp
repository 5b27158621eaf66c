// Fails every test case during which the validation layer reports something, and ends the use of Vulkan.
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include "host/trace/vulkan/validation.h"
#include "tests/trace/vulkan_support/test_device.h"

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

  void testRunEnded(const Catch::TestRunStats& stats) override {
    candela::endTestRun();
    TestEventListenerBase::testRunEnded(stats);
  }
};

CATCH_REGISTER_LISTENER(ValidationListener)

}  // namespace
