// Accessors: component types, normalised values, strides, sparse replacements, checked ranges.
#include "host/formats/gltf/accessor.h"

#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// Reads accessor 0 of a file.
template <class Vector>
std::vector<Vector> readFirst(const GltfFile& file) {
  const json parsed = json::parse(file.text());
  const Value root(parsed, "");
  const std::string bytes = file.text();
  const scene::SceneFile source{bytes, "test.gltf", "."};
  const scene::LoadOptions options;
  Buffers buffers(root, std::nullopt, source, options);
  const json reference = 0;
  return Accessors(root, buffers).read<Vector>(Value(reference, "/reference"));
}

template <class Element>
std::vector<float> scalars(const std::vector<Element>& elements, int type, bool normalised) {
  GltfFile file;
  file.accessor(elements, type, "SCALAR", elements.size());
  file.root["accessors"][0]["normalized"] = normalised;
  return readFirst<float>(file);
}

}  // namespace

TEST_CASE("normalised integers are converted to their values") {
  CHECK(scalars<std::int8_t>({-128, -127, 0, 64, 127}, kByte, true) == std::vector<float>{-1, -1, 0, 64.0f / 127, 1});
  CHECK(scalars<std::uint8_t>({0, 51, 255}, kUnsignedByte, true) == std::vector<float>{0, 0.2f, 1});
  CHECK(scalars<std::int16_t>({-32768, 0, 32767}, kShort, true) == std::vector<float>{-1, 0, 1});
  CHECK(scalars<std::uint16_t>({0, 13107, 65535}, kUnsignedShort, true) == std::vector<float>{0, 0.2f, 1});
  CHECK(scalars<std::int8_t>({-128, 127}, kByte, false) == std::vector<float>{-128, 127});
  CHECK(scalars<std::uint16_t>({7, 65535}, kUnsignedShort, false) == std::vector<float>{7, 65535});
  CHECK(scalars<std::uint32_t>({16777216}, kUnsignedInt, false) == std::vector<float>{16777216});
  CHECK(scalars<float>({-0.5f, 1e30f}, kFloat, false) == std::vector<float>{-0.5f, 1e30f});
}

TEST_CASE("elements of interleaved accessors are a stride apart, and begin at both offsets") {
  GltfFile file;
  const std::vector<float> interleaved{9, 1, 2, 3, 10, 20, 4, 5, 6, 30, 40};
  file.view(interleaved);
  file.root["bufferViews"][0]["byteStride"] = 20;
  file.root["accessors"] = {
      {{"bufferView", 0}, {"byteOffset", 4}, {"componentType", kFloat}, {"count", 2}, {"type", "VEC3"}}};
  CHECK(readFirst<glm::vec3>(file) == std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}});
  file.root["accessors"][0]["byteOffset"] = 16;
  file.root["accessors"][0]["type"] = "VEC2";
  CHECK(readFirst<glm::vec2>(file) == std::vector<glm::vec2>{{10, 20}, {30, 40}});
}

TEST_CASE("sparse accessors replace elements, of zeros where there is no view") {
  GltfFile file;
  const std::size_t indices = file.view<std::uint16_t>({1, 3});
  const std::size_t values = file.view<float>({5, 6, 7, 8});
  const json sparse{{"count", 2},
                    {"indices", {{"bufferView", indices}, {"componentType", kUnsignedShort}}},
                    {"values", {{"bufferView", values}}}};
  file.root["accessors"] = {{{"componentType", kFloat}, {"count", 4}, {"type", "VEC2"}, {"sparse", sparse}}};
  CHECK(readFirst<glm::vec2>(file) == std::vector<glm::vec2>{{0, 0}, {5, 6}, {0, 0}, {7, 8}});
  const std::size_t base = file.view<float>({1, 1, 2, 2, 3, 3, 4, 4});
  file.root["accessors"][0]["bufferView"] = base;
  CHECK(readFirst<glm::vec2>(file) == std::vector<glm::vec2>{{1, 1}, {5, 6}, {3, 3}, {7, 8}});
}

TEST_CASE("sparse accessors replace integers, too") {
  GltfFile file = triangleFile();
  const std::size_t indices = file.accessor<std::uint16_t>({0, 0, 0}, kUnsignedShort, "SCALAR", 3);
  const std::size_t replaced = file.view<std::uint8_t>({1, 2});
  const std::size_t values = file.view<std::uint16_t>({2, 1});
  file.root["accessors"][indices]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", replaced}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", values}}}};
  file.primitive()["indices"] = indices;
  CHECK(sceneOf(file).meshes.at(0).indices == std::vector<std::uint32_t>{0, 2, 1});
}

TEST_CASE("the last byte of a view can be read, and no further") {
  GltfFile file;
  file.view<float>({1, 2, 3});
  file.root["accessors"] = {{{"bufferView", 0}, {"componentType", kFloat}, {"count", 3}, {"type", "SCALAR"}}};
  CHECK(readFirst<float>(file) == std::vector<float>{1, 2, 3});
  for (const auto& [key, value] : {std::pair("count", 4), std::pair("byteOffset", 1), std::pair("byteOffset", 12)}) {
    GltfFile beyond = file;
    beyond.root["accessors"][0][key] = value;
    CHECK_THROWS_WITH(readFirst<float>(beyond), Catch::Contains("/accessors/0: ") && Catch::Contains("of 12 bytes"));
  }
}

TEST_CASE("matrices are read by columns") {
  GltfFile file;
  std::vector<float> numbers(16);
  for (std::size_t i = 0; i < 16; ++i) numbers[i] = static_cast<float>(i);
  file.accessor(numbers, kFloat, "MAT4", 1);
  CHECK(readFirst<glm::mat4>(file).at(0)[1] == glm::vec4(4, 5, 6, 7));
}

}  // namespace candela::gltf
