// The generator of mutations.
#include "host/drivers/variants/mutation.h"

#include <catch2/catch.hpp>
#include <map>

#include "tests/drivers/variants/modules.h"

namespace candela::variants {
namespace {

Module soundModule(const NamedModule& named) { return parseModule(vulkan::reducedSpirv(named.spirv, {})); }

// The name of the kind in "kind at %123".
std::string kindOf(const std::string& done) { return done.substr(0, done.find(" at ")); }

}  // namespace

TEST_CASE("variants: a module is the same after it was parsed and written") {
  for (const NamedModule& named : testModules()) {
    CHECK(codeOf(parseModule(named.spirv)) == Code(named.spirv.begin(), named.spirv.end()));
  }
}

TEST_CASE("variants: every kind of mutation changes modules, and they stay valid") {
  for (const NamedModule& named : smallModules()) {
    CAPTURE(named.name);
    std::map<std::string, int> found;
    for (std::uint32_t index = 0; index < 40; ++index) {
      Module module = soundModule(named);
      const Code before = codeOf(module);
      const std::string done = Mutator(module).apply({7, index});
      CAPTURE(index, done);
      ++found[kindOf(done)];
      const Code after = codeOf(module);
      CHECK(after != before);
      CHECK(validationOf(after) == "");
    }
    CHECK(found.size() == mutationKinds().size());
  }
}

TEST_CASE("variants: modules stay valid after many mutations") {
  for (const NamedModule& named : testModules()) {
    CAPTURE(named.name);
    Module module = soundModule(named);
    Mutator mutator(module);
    for (std::uint32_t index = 0; index < 200; ++index) mutator.apply({11, index});
    CHECK(validationOf(codeOf(module)) == "");
  }
}

TEST_CASE("variants: a seed determines the mutations, and another one makes others") {
  const NamedModule named = smallModules().front();
  const auto mutated = [&](std::uint32_t seed) {
    Module module = soundModule(named);
    Mutator mutator(module);
    for (std::uint32_t index = 0; index < 64; ++index) mutator.apply({seed, index});
    return codeOf(module);
  };
  const Code first = mutated(1);
  CHECK(first == mutated(1));
  CHECK(first != mutated(2));
  CHECK(validationOf(first) == "");
}

TEST_CASE("variants: mutations keep their places if others are omitted") {
  const NamedModule named = smallModules().front();
  Module all = soundModule(named), some = soundModule(named);
  Mutator allMutator(all), someMutator(some);
  for (std::uint32_t index = 0; index < 64; ++index) {
    const std::string done = allMutator.apply({3, index});
    if (index % 3 == 0) CHECK(someMutator.apply({3, index}) == done);
  }
  CHECK(validationOf(codeOf(some)) == "");
}

}  // namespace candela::variants
