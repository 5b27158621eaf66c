// Textures, samplers, images and texture transforms, and their errors.
#include <fstream>

#include "host/formats/gltf/textures.h"
#include "host/image/codecs.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

std::vector<std::byte> pngOf(std::uint32_t width, std::uint32_t height) {
  image::Pixels8 pixels{width, height, std::vector<std::uint8_t>(3 * std::size_t{width} * height)};
  for (std::size_t i = 0; i < pixels.rgb.size(); ++i) pixels.rgb[i] = static_cast<std::uint8_t>(i + 1);
  return image::toPng(pixels);
}

// A triangle whose material has a base colour texture, of an image in a buffer view.
GltfFile texturedFile(const std::vector<std::byte>& encoded = pngOf(2, 1)) {
  GltfFile file = triangleFile();
  file.root["images"] = {{{"bufferView", file.view(encoded)}, {"mimeType", "image/png"}}};
  file.root["textures"] = {{{"source", 0}}};
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.primitive()["material"] = 0;
  return file;
}

json& infoOf(GltfFile& file) { return file.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]; }

scene::TextureReference referenceOf(const GltfFile& file) {
  const scene::Scene scene = sceneOf(file);
  REQUIRE(textureOf(scene.materials[0], scene::TextureSlot::baseColour));
  return *textureOf(scene.materials[0], scene::TextureSlot::baseColour);
}

}  // namespace

TEST_CASE("an image in a buffer view is read once, whatever the number of its uses") {
  GltfFile file = texturedFile();
  file.root["materials"][0]["emissiveTexture"]["index"] = 0;
  file.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
  const scene::Scene scene = sceneOf(file);
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0].width == 2);
  CHECK(scene.images[0].height == 1);
  CHECK(scene.images[0].texels == std::vector<std::uint32_t>{0xff030201u, 0xff060504u});
  CHECK(textureOf(scene.materials[0], scene::TextureSlot::emission) == scene::TextureReference{});
}

TEST_CASE("without a sampler textures repeat and are filtered linearly") {
  CHECK(referenceOf(texturedFile()) == scene::TextureReference{});
}

TEST_CASE("samplers state wrap modes and the filter, and textureInfo the set of coordinates") {
  GltfFile file = texturedFile();
  file.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}};
  file.root["textures"][0]["sampler"] = 0;
  infoOf(file)["texCoord"] = 1;
  CHECK(referenceOf(file) == scene::TextureReference{.texCoordSet = 1,
                                                     .wrapS = scene::TextureWrap::clampToEdge,
                                                     .wrapT = scene::TextureWrap::mirroredRepeat,
                                                     .filter = scene::TextureFilter::nearest});
}

TEST_CASE("a texture transform scales, then rotates, then moves, and may name another set") {
  GltfFile file = texturedFile();
  infoOf(file)["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.25, 0.5}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}, {"texCoord", 1}};
  const scene::TextureReference reference = referenceOf(file);
  CHECK(reference.texCoordSet == 1);
  const glm::vec3 uv(0.1f, 0.2f, 1);  // scaled 0.2 0.6; rotated 0.6 -0.2
  CHECK(glm::dot(reference.rowS, uv) == Approx(0.85));
  CHECK(glm::dot(reference.rowT, uv) == Approx(0.3));
}

TEST_CASE("textures of specular-glossiness have transforms, and one image serves two slots") {
  GltfFile file = texturedFile();
  const auto infoWithScale = [](double scale) -> json {
    return {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {scale, 1}}}}}}};
  };
  file.root["materials"][0] = {
      {"extensions",
       {{"KHR_materials_pbrSpecularGlossiness",
         {{"diffuseTexture", infoWithScale(2)}, {"specularGlossinessTexture", infoWithScale(3)}}}}}};
  file.root["extensionsRequired"] = {"KHR_materials_pbrSpecularGlossiness", "KHR_texture_transform"};
  const scene::LoadedScene loaded = load(file);
  CHECK(loaded.warnings.empty());
  const scene::Scene& scene = loaded.scene;
  CHECK(scene.images.size() == 1);
  const auto scaleOf = [&](scene::TextureSlot slot) { return textureOf(scene.materials[0], slot)->rowS.x; };
  CHECK(scaleOf(scene::TextureSlot::baseColour) == 2);
  CHECK(scaleOf(scene::TextureSlot::specularColour) == 3);
  CHECK(scaleOf(scene::TextureSlot::glossiness) == 3);
}

TEST_CASE("images come from data URIs and permitted files, and the scene's hash covers them") {
  const TemporaryFolder folder;
  const auto write = [&](const std::vector<std::byte>& bytes) {
    std::ofstream(folder.path() / "one two.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  GltfFile file = texturedFile();
  file.root["images"][0] = {{"uri", "one%20two.png"}};
  write(pngOf(2, 1));
  const scene::Scene first = loadText(file.text(), {}, folder.path()).scene;
  CHECK(first.images[0].name == "one%20two.png");
  write(pngOf(3, 1));
  const scene::Scene second = loadText(file.text(), {}, folder.path()).scene;
  CHECK(second.images[0].width == 3);
  CHECK(first.hash != second.hash);
  file.root["images"][0]["uri"] = "../outside.png";
  CHECK_THROWS_WITH(loadText(file.text(), {}, folder.path()), Catch::Contains("/images/0/uri"));
}

TEST_CASE("textures without an image, or with a third set of coordinates, are left out with a warning") {
  GltfFile file = texturedFile();
  const auto warnsAndLeavesOut = [&](const char* warning) {
    const scene::LoadedScene loaded = load(file);
    return warns(loaded, warning) && !textureOf(loaded.scene.materials[0], scene::TextureSlot::baseColour);
  };
  SECTION("no source, as where an extension names an image of another format") {
    file.root["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
    CHECK(warnsAndLeavesOut("/textures/0: the texture is left out"));
  }
  SECTION("texCoord 2") {
    infoOf(file)["texCoord"] = 2;
    CHECK(warnsAndLeavesOut("/materials/0/pbrMetallicRoughness/baseColorTexture: the texture is left out"));
  }
  SECTION("texCoord 2 of a texture transform") {
    infoOf(file)["extensions"]["KHR_texture_transform"]["texCoord"] = 2;
    CHECK(warnsAndLeavesOut("coordinates of set 2"));
  }
}

TEST_CASE("lenient reading leaves out the textures of images that are damaged, missing or forbidden") {
  GltfFile file = texturedFile(std::vector<std::byte>(40));
  const auto shared = file.root["materials"][0];
  file.root["materials"].push_back(shared);
  SECTION("not an image") {}
  SECTION("a file that does not exist") { file.root["images"][0] = {{"uri", "missing.png"}}; }
  SECTION("a file outside the scene's folder") { file.root["images"][0] = {{"uri", "../outside.png"}}; }
  CHECK(errorsOf(file.text()).find("; lenient leaves out textures") != std::string::npos);
  const scene::LoadedScene loaded = load(file, {.lenient = true});
  CHECK(warns(loaded, "its textures are left out"));
  CHECK(loaded.scene.images.empty());
  for (const scene::Material& material : loaded.scene.materials) {
    CHECK(!textureOf(material, scene::TextureSlot::baseColour));
  }
}

TEST_CASE("damaged textures are errors with their place") {
  GltfFile file = texturedFile();
  SECTION("an index beyond the list") {
    infoOf(file)["index"] = 1;
    CHECK_THROWS_WITH(load(file), Catch::Contains("/materials/0/pbrMetallicRoughness/baseColorTexture/index"));
  }
  SECTION("no list") {
    file.root.erase("textures");
    CHECK_THROWS_WITH(load(file), Catch::Contains("/baseColorTexture/index: index 0 into \"textures\", which has 0"));
  }
  SECTION("a wrap mode that does not exist") {
    file.root["samplers"] = {{{"wrapT", 5}}};
    file.root["textures"][0]["sampler"] = 0;
    CHECK_THROWS_WITH(load(file), Catch::Contains("/samplers/0/wrapT: 5 is not a wrapping mode"));
  }
  SECTION("bytes that are no image") {
    const GltfFile bad = texturedFile(std::vector<std::byte>(40));
    CHECK_THROWS_WITH(load(bad), Catch::Contains("/images/0: not a PNG, JPEG or WebP file"));
  }
  SECTION("an image that ends early") {
    std::vector<std::byte> png = pngOf(30, 30);
    png.resize(png.size() / 2);
    CHECK_THROWS_WITH(load(texturedFile(png)), Catch::Contains("/images/0: not a valid PNG file"));
  }
  SECTION("an image that claims 60,000 times 60,000 pixels") {
    std::vector<std::byte> png = pngOf(2, 1);
    for (const std::size_t at : {18u, 22u}) png[at] = std::byte{0xea}, png[at + 1] = std::byte{0x60};
    CHECK_THROWS_WITH(load(texturedFile(png)), Catch::Contains("/images/0: "));
  }
}

}  // namespace candela::gltf
