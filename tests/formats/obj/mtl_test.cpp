// MTL: every statement, the materials that follow, and the images of maps.
#include <cmath>
#include <numbers>

#include "host/formats/obj/mtl_mapping.h"
#include "host/image/codecs.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/obj/obj_file.h"

namespace candela::obj {
namespace {

using scene::TextureSlot;

MtlFile parse(const std::string& text) {
  scene::DiagnosticLog log("test.mtl");
  MtlFile file = parseMtl(text, false, log);
  log.throwIfErrors();
  return file;
}

/// The scene's material for the statements of a material, without textures.
scene::Material materialOf(const std::string& statements) {
  return fromMtl(parse("newmtl a\n" + statements).materials.at(0), {}, false);
}

std::string errorOf(const std::string& statements) {
  try {
    parse("newmtl a\n" + statements);
    return {};
  } catch (const scene::SceneError& error) {
    return error.what();
  }
}

/// A square with texture coordinates and one material, beside its material file and some images.
class TexturedSquare {
 public:
  explicit TexturedSquare(const std::string& statements) {
    folder_.write("a.mtl", "newmtl a\n" + statements);
    write("colour.png", {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}});
    write("grey.png", {{10, 10, 10}, {20, 20, 20}, {30, 30, 30}, {40, 40, 40}});
    write("packed.png", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}});
  }
  scene::LoadedScene load(const scene::LoadOptions& options = {}) const {
    return obj::load(kText, options, folder_.path());
  }
  std::string errors() const { return errorsOf(kText, {}, folder_.path()); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  /// An image of 2 x 2 pixels.
  void write(const std::string& name, const std::vector<std::array<std::uint8_t, 3>>& pixels) const {
    image::Pixels8 image{2, 2, {}};
    for (const auto& pixel : pixels) image.rgb.insert(image.rgb.end(), pixel.begin(), pixel.end());
    const image::Bytes bytes = image::encodePng(image);
    folder_.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  const std::string kText = "mtllib a.mtl\nusemtl a\n" + kSquare +
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("Kd of MTL is a diffuse surface") {
  const scene::Material material = materialOf("Ka 1 1 1\nKd .25 .5 .75\nillum 1\nKs 1 1 1\nNs 100\n");
  CHECK(kindOf(material) == scene::MaterialKind::diffuse);
  CHECK(material.diffuse == scene::DiffuseLobe{.colour = {0.25f, 0.5f, 0.75f}});
  CHECK(material.opaque);
  CHECK_FALSE(material.whitted);
  CHECK(materialOf("Kd .5\n").diffuse->colour == glm::vec3(0.5f));
  CHECK(materialOf("Kd 2 .5 0\n").diffuse->colour == glm::vec3(1, 0.5f, 0));
  CHECK(materialOf("").diffuse->colour == glm::vec3(0.8f));
}

TEST_CASE("Ks of MTL is the reflectance at normal incidence, and Ns gives the roughness") {
  const scene::Material material = materialOf("Kd .1 .2 .3\nKs .4 .5 .6\nNs 30\nillum 2\n");
  REQUIRE(material.surface);
  CHECK(material.surface->baseColour == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(material.surface->specularColour == glm::vec3(0.4f, 0.5f, 0.6f));
  CHECK(material.surface->specularWeight == 1);
  CHECK(material.surface->ior == 0);
  CHECK(material.surface->metalness == 0);
  CHECK(material.surface->roughness == 0.5f);  // (2/32)^(1/4)
  CHECK(materialOf("Ks 1 1 1\n").surface->roughness == 1);
  for (const char* const model : {"3", "5", "8"}) {
    CHECK(materialOf("Ks 1 1 1\nNs 30\nillum " + std::string(model) + "\n").surface->roughness == 0);
  }
}

TEST_CASE("Materials of MTL that refract are smooth glass") {
  const scene::Material material = materialOf("Kd 1 0 0\nKs 1 1 1\nTf .9 1 .8\nNi 1.33\nillum 7\nd .1\n");
  CHECK(kindOf(material) == scene::MaterialKind::dielectric);
  CHECK(material.dielectric == scene::DielectricLobe{.colour = {0.9f, 1, 0.8f}, .ior = 1.33f});
  CHECK_FALSE(material.opaque);
  CHECK_FALSE(material.opacity);
  CHECK(materialOf("illum 6\n").dielectric == scene::DielectricLobe{.ior = 1.5f});
}

TEST_CASE("d and Tr of MTL are opacity") {
  CHECK(materialOf("d .25\n").opacity == scene::Opacity{.factor = 0.25f});
  CHECK(materialOf("Tr .25\n").opacity == scene::Opacity{.factor = 0.75f});
  CHECK(materialOf("d .25\nTr .25\n").opacity->factor == 0.25f);
  CHECK(materialOf("Tr .25\nd .25\n").opacity->factor == 0.25f);
  CHECK_FALSE(materialOf("d 1\n").opacity);
  CHECK(parse("newmtl a\nd -halo .5\n").omissions == std::set<std::string>{"d -halo"});
}

TEST_CASE("Ke of MTL makes triangles lights") {
  const scene::Material material = materialOf("Kd 0 0 0\nKe 17 12 4\n");
  CHECK(material.emission == glm::vec3(17, 12, 4));
  TexturedSquare square("Kd 0 0 0\nKe 17 12 4\n");
  const scene::LoadedScene loaded = square.load();
  CHECK(loaded.scene.punctualLights.empty());
  CHECK(loaded.facts.at(1) == std::pair<std::string, std::string>("light", "as in the file"));
}

TEST_CASE("The extension of MTL for physically based materials has the parameters of surfaces") {
  const scene::SurfaceParameters
      surface = *materialOf("Kd .5 .6 .7\nPr .25\nPm .75\nPs .5\nPc .4\nPcr .3\naniso .2\nanisor .125\nNi 1.4\n")
                     .surface;
  CHECK(surface.baseColour == glm::vec3(0.5f, 0.6f, 0.7f));
  CHECK(surface.roughness == 0.25f);
  CHECK(surface.metalness == 0.75f);
  CHECK(surface.sheenColour == glm::vec3(0.5f));
  CHECK(surface.sheenRoughness == 0.5f);
  CHECK(surface.coatWeight == 0.4f);
  CHECK(surface.coatRoughness == 0.3f);
  CHECK(surface.anisotropy == 0.2f);
  CHECK(surface.anisotropyRotation == static_cast<float>(std::numbers::pi / 4));
  CHECK(surface.ior == 1.4f);
  CHECK(materialOf("Pm 1\nNs 30\n").surface->roughness == 0.5f);
}

TEST_CASE("Maps of MTL are textures of their slots, with v from the bottom") {
  const TexturedSquare square(
      "Kd .5 .5 .5\nKs .5 .5 .5\nmap_Kd colour.png\nmap_Ks -s 2 3 -o .25 .5 0 -clamp on colour.png\n"
      "map_Ke colour.png\nnorm packed.png\n");
  const scene::LoadedScene loaded = square.load();
  const scene::Material& material = loaded.scene.materials.at(0);
  REQUIRE(loaded.scene.images.size() == 2);
  CHECK(loaded.scene.images[0].texels == std::vector<std::uint32_t>{0xff0000ff, 0xff00ff00, 0xffff0000, 0xffffffff});
  const auto& diffuse = textureOf(material, TextureSlot::baseColour);
  REQUIRE(diffuse);
  CHECK(diffuse->rowS == glm::vec3(1, 0, 0));
  CHECK(diffuse->rowT == glm::vec3(0, -1, 1));
  CHECK(diffuse->wrapS == scene::TextureWrap::repeat);
  const auto& specular = textureOf(material, TextureSlot::specularColour);
  REQUIRE(specular);
  CHECK(specular->rowS == glm::vec3(2, 0, 0.25f));
  CHECK(specular->rowT == glm::vec3(0, -3, 0.5f));
  CHECK(specular->wrapT == scene::TextureWrap::clampToEdge);
  CHECK(material.emission == glm::vec3(1));
  CHECK(textureOf(material, TextureSlot::emission));
  CHECK(textureOf(material, TextureSlot::normal)->image == 1);
  CHECK(loaded.scene.meshes[0].tangents == std::vector<glm::vec4>(6, glm::vec4(1, 0, 0, 1)));
  CHECK(loaded.files.size() == 3);
}

TEST_CASE("map_d of MTL becomes alpha: luminance, or the channel that -imfchan names") {
  const auto alphas = [](const std::string& map) {
    const scene::Scene scene = TexturedSquare(map).load().scene;
    std::vector<std::uint32_t> found;
    const auto& texture = scene.materials.at(0).opacity->texture;
    for (const std::uint32_t texel : scene.images.at(texture->image).texels) found.push_back(texel >> 24);
    return found;
  };
  CHECK(alphas("map_d grey.png\n") == std::vector<std::uint32_t>{10, 20, 30, 40});
  CHECK(alphas("map_d -imfchan g packed.png\n") == std::vector<std::uint32_t>{2, 5, 8, 11});
  CHECK(alphas("map_d -imfchan m packed.png\n") == std::vector<std::uint32_t>{255, 255, 255, 255});
}

TEST_CASE("map_Pr and map_Pm of MTL become green and blue of one image") {
  const auto texelsOf = [](const std::string& maps) {
    const scene::Scene scene = TexturedSquare(maps).load().scene;
    return scene.images.at(textureOf(scene.materials.at(0), TextureSlot::metallicRoughness)->image).texels;
  };
  CHECK(texelsOf("map_Pr grey.png\n")[1] == 0xffff14ff);
  CHECK(texelsOf("map_Pm grey.png\n")[1] == 0xff14ffff);
  CHECK(texelsOf("map_Pr packed.png\nmap_Pm packed.png\n")[1] == 0xff0605ff);
  CHECK(texelsOf("map_Pr grey.png\nmap_Pm -imfchan r packed.png\n")[1] == 0xff0414ff);
  const scene::Scene scene = TexturedSquare("map_Pr grey.png\nmap_Pm grey.png\n").load().scene;
  CHECK(scene.materials[0].surface->roughness == 1);
  CHECK(scene.materials[0].surface->metalness == 1);
}

TEST_CASE("Bump maps of MTL are normal maps if they have colours") {
  const scene::LoadedScene normals = TexturedSquare("map_Bump -bm 0.5 packed.png\n").load();
  CHECK(textureOf(normals.scene.materials[0], TextureSlot::normal));
  CHECK(normals.scene.materials[0].normalScale == 0.5f);
  CHECK(normals.scene.materials[0].surface->specularWeight == 0);
  CHECK(normals.warnings.empty());
  const scene::LoadedScene heights = TexturedSquare("bump grey.png\n").load();
  CHECK_FALSE(textureOf(heights.scene.materials[0], TextureSlot::normal));
  CHECK(warningsOf(heights) == std::vector<std::string>{"test.obj: not rendered: bump maps of heights"});
}

TEST_CASE("What MTL has besides is named: in one warning, or as not used") {
  const scene::LoadedScene loaded = TexturedSquare(
                                        "Ka 1 1 1\nsharpness 60\nmap_Ns grey.png\ndisp grey.png\nunheard 1\n"
                                        "map_Kd -blendu on -mm 0 1 -t 1 colour.png\nKs spectral a.rfl 1\n")
                                        .load();
  CHECK(warningsOf(loaded) ==
        std::vector<std::string>{"test.obj: not rendered: -mm, -t, disp, ks spectral, map_Ns, unheard"});
  CHECK(loaded.facts.back() == std::pair<std::string, std::string>("not used", "-blendu, Ka, sharpness"));
  CHECK(textureOf(loaded.scene.materials[0], TextureSlot::baseColour));
}

TEST_CASE("Several material files, names with blanks and backslashes") {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl red paint\nKd 1 0 0\nnewmtl twice\nKd 0 0 1\n");
  folder.write("b.mtl", "newmtl twice\nKd 0 1 0\n");
  folder.write("c d.mtl", "newmtl last\nKd .5 .5 .5\n");
  const scene::Scene
      scene = load("mtllib a.mtl b.mtl\nmtllib .\\c d.mtl\n" + kSquare +
                       "usemtl red paint\nf 1 2 3\nusemtl twice\nf 1 3 4\nusemtl last\nf 2 3 4\nusemtl unused\n",
                   {}, folder.path())
                  .scene;
  CHECK(scene.materialNames == std::vector<std::string>{"red paint", "twice", "last"});
  CHECK(scene.materials[0].diffuse->colour == glm::vec3(1, 0, 0));
  CHECK(scene.materials[1].diffuse->colour == glm::vec3(0, 1, 0));
  CHECK(scene.materials[2].diffuse->colour == glm::vec3(0.5f));
}

TEST_CASE("Malformed MTL is refused with the place of each error") {
  CHECK(errorOf("Kd 1 x 0\n") == "test.mtl:2:6: expected a number, found \"x\"");
  CHECK(errorOf("Kd -1 0 0\n") == "test.mtl:2:4: -1 is negative");
  CHECK(errorOf("Kd 1 1 1 1\n") == "test.mtl:2:10: unexpected \"1\"");
  CHECK(errorOf("d 1.5\n") == "test.mtl:2:3: 1.5 is outside 0 to 1");
  CHECK(errorOf("illum 11\n") == "test.mtl:2:7: expected an illumination model from 0 to 10");
  CHECK(errorOf("map_Kd\n") == "test.mtl:2:7: expected the name of an image file");
  CHECK(errorOf("map_Kd -clamp maybe a.png\n") == "test.mtl:2:15: expected on or off, found \"maybe\"");
  CHECK(errorOf("map_d -imfchan q a.png\n") == "test.mtl:2:16: expected r, g, b, m, l or z, found \"q\"");
  CHECK(errorOf("newmtl\n") == "test.mtl:2:7: expected the name of the material");
  scene::DiagnosticLog log("test.mtl");
  parseMtl("Kd 1 1 1\n", false, log);
  CHECK_THROWS_WITH(log.throwIfErrors(), "test.mtl:1:1: \"Kd\" before any newmtl");
}

TEST_CASE("Images of MTL that cannot be read are errors, or with lenient left out") {
  const TexturedSquare square("map_Kd none.png\n");
  const std::string mtl = square.folder().path("a.mtl"), png = square.folder().path("none.png");
  CHECK(square.errors() ==
        mtl + ":2:8: image \"none.png\": " + png +
            ": cannot open: No such file or directory; lenient leaves out textures whose image cannot be read");
  const scene::LoadedScene lenient = square.load({.lenient = true});
  CHECK(lenient.warnings.size() == 1);
  CHECK_FALSE(textureOf(lenient.scene.materials[0], TextureSlot::baseColour));
  const TexturedSquare outside("map_Kd ../secret.png\n");
  CHECK(outside.errors().find("is outside the scene's folder; allow-path = DIR permits it") != std::string::npos);
}

}  // namespace candela::obj
