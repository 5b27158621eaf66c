// Catch2 3 under the header and the names of Catch2 2, which the tests use; in the include path with Catch2 3 only.
#pragma once
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/interfaces/catch_interfaces_reporter.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <string>

using Catch::Approx;

namespace Catch::Matchers {

/// Matches strings that contain `part`; Catch2 3 has given the name to a matcher of ranges.
inline StringContainsMatcher Contains(const std::string& part) { return ContainsSubstring(part); }

}  // namespace Catch::Matchers

namespace Catch {

using Matchers::Contains;
using Matchers::EndsWith;
using Matchers::StartsWith;

class TestEventListenerBase : public EventListenerBase {
 public:
  using EventListenerBase::EventListenerBase;
};

}  // namespace Catch
