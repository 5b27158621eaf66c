// Makes and recognises the arguments of a command.
#include "host/app/cli/command_arguments.h"

namespace candela::cli {

Arguments defaultArguments(Command command) {
  Arguments arguments;
  const auto choose = [&]<class... Commands>(const std::variant<Commands...>*) {
    ((Commands::command == command ? static_cast<void>(arguments.emplace<Commands>()) : void()), ...);
  };
  choose(&arguments);
  return arguments;
}

Command commandOf(const Arguments& arguments) {
  return std::visit([](const auto& command) { return command.command; }, arguments);
}

}  // namespace candela::cli
