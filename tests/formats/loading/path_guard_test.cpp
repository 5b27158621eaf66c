// The files that a scene may read: links and dots are resolved before folders are compared.
#include "host/formats/loading/path_guard.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

/// A scene's folder beside another one, each with a file.
struct Folders {
  TemporaryFolder root;
  fs::path scene = root / "scene";
  fs::path other = root / "other";

  Folders() {
    for (const fs::path& folder : {scene, other}) {
      fs::create_directory(folder);
      writeText(folder / "image.png", "");
    }
  }
};

}  // namespace

TEST_CASE("a scene may read its own folder, however the path is written") {
  const Folders folders;
  const PathGuard guard(folders.scene, {});
  CHECK(guard.permits(folders.scene));
  CHECK(guard.permits(folders.scene / "image.png"));
  CHECK(guard.permits(folders.scene / "missing" / "image.png"));
  CHECK(guard.permits(folders.scene / ".." / "scene" / "image.png"));
  CHECK(guard.permits(folders.other / ".." / "scene" / "." / "image.png"));
  CHECK(PathGuard(folders.scene / "", {}).permits(folders.scene / "image.png"));
  CHECK(PathGuard(".", {}).permits("image.png"));
}

TEST_CASE("a path that leads out of the scene's folder is refused") {
  const Folders folders;
  const PathGuard guard(folders.scene, {});
  CHECK_FALSE(guard.permits(folders.root.path()));
  CHECK_FALSE(guard.permits(folders.other / "image.png"));
  CHECK_FALSE(guard.permits(folders.scene / ".." / "other" / "image.png"));
  CHECK_FALSE(guard.permits(folders.scene / "missing" / ".." / ".." / "other"));
  CHECK_FALSE(guard.permits(folders.root / "scene2"));  // begins with the folder's name
  CHECK_FALSE(guard.permits("/"));
  CHECK_FALSE(guard.permits(""));
}

TEST_CASE("a guard lists the paths that it has permitted, and no others") {
  const Folders folders;
  PathGuard guard(folders.scene, {});
  guard.require(folders.scene / "image.png");
  CHECK_THROWS_AS(guard.require(folders.other / "image.png"), FileError);
  guard.require(folders.scene / "missing.png");
  CHECK(guard.requiredPaths() == std::vector{folders.scene / "image.png", folders.scene / "missing.png"});
}

TEST_CASE("a link is judged by its target") {
  const Folders folders;
  fs::create_directory_symlink(folders.other, folders.scene / "out");
  fs::create_symlink(folders.other / "image.png", folders.scene / "out.png");
  fs::create_symlink(folders.scene / "image.png", folders.other / "in.png");
  fs::create_symlink(folders.scene / "loop", folders.scene / "loop");
  const PathGuard guard(folders.scene, {});
  CHECK_FALSE(guard.permits(folders.scene / "out"));
  CHECK_FALSE(guard.permits(folders.scene / "out" / "image.png"));
  CHECK_FALSE(guard.permits(folders.scene / "out.png"));
  CHECK_FALSE(guard.permits(folders.scene / "loop"));
  CHECK(guard.permits(folders.other / "in.png"));
}

TEST_CASE("further folders are permitted, also through a link") {
  const Folders folders;
  fs::create_directory_symlink(folders.other, folders.root / "link");
  for (const fs::path& allowed : {folders.other, folders.other / "", folders.root / "link"}) {
    CAPTURE(allowed);
    const PathGuard guard(folders.scene, {allowed});
    CHECK(guard.permits(folders.other / "image.png"));
    CHECK(guard.permits(folders.scene / "image.png"));
    CHECK_FALSE(guard.permits(folders.root.path()));
  }
}

TEST_CASE("the refusal names the path and the option that permits it") {
  const Folders folders;
  PathGuard guard(folders.scene, {});
  CHECK_NOTHROW(guard.require(folders.scene / "image.png"));
  CHECK_THROWS_AS(guard.require("/etc/passwd"), FileError);
  CHECK_THROWS_WITH(guard.require("/etc/passwd"),
                    Catch::Contains("\"/etc/passwd\" is outside") && Catch::Contains("allow-path = DIR permits it"));
}

}  // namespace candela::scene
