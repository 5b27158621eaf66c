// Buffers in other files and in data URIs, and the folders that a file may read.
#include "host/formats/gltf/uri.h"

#include "tests/base/temporary_folder.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

std::string decoded(const std::string& uri) {
  const json value = uri;
  return decodeDataUri(Value(value, "/uri"));
}

}  // namespace

TEST_CASE("base64 is decoded with and without padding") {
  CHECK(decoded("data:;base64,Zm9vYmE=") == "fooba");
  CHECK(decoded("data:application/gltf-buffer;base64,Zm9vYg") == "foob");
  CHECK(decoded("data:x;base64,/+8A") == std::string("\xff\xef\0", 3));
  CHECK_THROWS_WITH(decoded("data:;base64,Zm9!"), Catch::Contains("not base64"));
  CHECK_THROWS_WITH(decoded("data:;base64,Zm9vY"), Catch::Contains("within a byte"));
  CHECK(decoded("DATA:;Base64,Zm9v") == "foo");
  CHECK(isDataUri("DATA:,"));
  CHECK_FALSE(isDataUri("data.bin"));
  CHECK_THROWS_WITH(decoded("data:text/plain;base64"), Catch::Contains("no comma"));
}

TEST_CASE("base64 may be escaped") {
  CHECK(decoded("data:x;base64,%2f%2B8A") == std::string("\xff\xef\0", 3));
  CHECK(decoded("data:;base64,Zm9vYmE%3D") == "fooba");
  CHECK(decoded("data:;base64,%5a%6D%39%76") == "foo");
  CHECK_THROWS_WITH(decoded("data:;base64,Zm9v%2"), Catch::Contains("without two hexadecimal digits"));
  CHECK_THROWS_WITH(decoded("data:;base64,Zm9v%zz"), Catch::Contains("without two hexadecimal digits"));
  CHECK_THROWS_WITH(decoded("data:;base64,Zm9%00"), Catch::Contains("not base64"));
}

TEST_CASE("a data URI that is not in base64 has its bytes as characters or escaped") {
  CHECK(decoded("data:application/octet-stream,%00a%fF;base64,") == std::string("\0a\xff;base64,", 11));
  CHECK(decoded("data:,").empty());
  CHECK_THROWS_WITH(decoded("data:,a%2"), Catch::Contains("without two hexadecimal digits"));
}

TEST_CASE("buffers are read from files in the scene's folder, whose names may be escaped") {
  const TemporaryFolder folder;
  GltfFile file = triangleFile();
  std::ofstream(folder / "my data.bin", std::ios::binary) << file.binary;
  file.root["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", "my%20data.bin"}}};
  CHECK(loadText(file.text(), {}, folder.path()).scene.primitives.size() == 1);
}

TEST_CASE("files outside the scene's folder need a permission") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "scene");
  GltfFile file = triangleFile();
  std::ofstream(folder / "data.bin", std::ios::binary) << file.binary;
  file.root["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", "../data.bin"}}};
  CHECK_THROWS_WITH(loadText(file.text(), {}, folder / "scene"),
                    Catch::Contains("/buffers/0/uri: ") && Catch::Contains("allow-path"));
  const scene::LoadOptions permitting{.allowedPaths = {folder.path()}};
  CHECK(loadText(file.text(), permitting, folder / "scene").scene.primitives.size() == 1);
}

}  // namespace candela::gltf
