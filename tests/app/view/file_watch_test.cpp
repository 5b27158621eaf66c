// Files that change.
#include "host/app/view/file_watch.h"

#include <catch2/catch.hpp>
#include <fstream>

using candela::view::FileWatch;

namespace {

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("a file has changed once it stays the same again") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "candela_file_watch_test";
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
  std::filesystem::remove(file);
}
