// The titles of groups of options, and the meaning of exit codes, for --help and for manual pages.
#pragma once
#include <span>

#include "host/app/cli/option_table.h"
#include "host/base/errors.h"

namespace candela::cli {

struct GroupTitle {
  OptionGroup group;
  const char* title;
};
/// Returns a title for every group, in the order of --help.
std::span<const GroupTitle> groupTitles();

struct ExitCodeText {
  ExitCode code;
  const char* text;
};
std::span<const ExitCodeText> exitCodeTexts();

}  // namespace candela::cli
