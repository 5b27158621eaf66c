// Comparisons of a variant with the plain form, without a device.
#include "host/drivers/conformance/variant_question.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

VariantQuestion questionOf(std::function<Observation(Workbench&)> observe) {
  return {"group", variants::allVariants().back(), std::move(observe)};
}

}  // namespace

TEST_CASE("a plain form is observed once for all variants of its group") {
  int count = 0;
  const VariantQuestion question = questionOf([&](Workbench&) {
    ++count;
    return Observation{"Pass"};
  });
  Workbench workbench({});
  CHECK(compareForms(question, workbench).outcome == Outcome::pass);
  CHECK(compareForms(question, workbench).outcome == Outcome::pass);
  CHECK(count == 3);
}

TEST_CASE("a plain form that cannot be observed is no observation") {
  const VariantQuestion question = questionOf([](Workbench&) -> Observation { throw InternalError("no pipeline"); });
  Workbench workbench({});
  for (int i = 0; i < 2; ++i) CHECK_THROWS_WITH(compareForms(question, workbench), "no pipeline");
  CHECK(workbench.observations().empty());
}

}  // namespace candela::conformance
