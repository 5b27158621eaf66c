// Files that change.
#include "host/app/view/file_watch.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/base/temporary_folder.h"

using candela::view::FileWatch;

namespace {

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("a file has changed once it stays the same again") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "watched";
  write(file, "a");
  FileWatch watch(file);
  CHECK(!watch.hasChanged());
  write(file, "ab");
  CHECK(!watch.hasChanged());
  write(file, "abc");
  CHECK(!watch.hasChanged());
  CHECK(watch.hasChanged());
  CHECK(!watch.hasChanged());
  std::filesystem::remove(file);
  CHECK(!watch.hasChanged());
  CHECK(!watch.hasChanged());
  write(file, "abcd");
  CHECK(!watch.hasChanged());
  CHECK(watch.hasChanged());
}
