// Finds options for tests.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "host/app/cli/commands.h"
#include "host/app/cli/option_table.h"

namespace candela::cli {

/// Returns the first row of the name, or the one for a command.
inline const Option& find(const std::string& name, std::optional<Command> command = std::nullopt) {
  const auto& table = optionTable();
  const auto found = std::ranges::find_if(
      table, [&](const Option& o) { return o.name() == name && (!command || o.isFor(*command)); });
  REQUIRE(found != table.end());
  return *found;
}

/// Returns the default arguments of a command that has an option.
inline Arguments argumentsWith(const Option& option) {
  const auto found = std::ranges::find_if(commandTable(),
                                          [&](const CommandInfo& i) { return option.isFor(i.command); });
  REQUIRE(found != commandTable().end());
  return defaultArguments(found->command);
}

}  // namespace candela::cli
