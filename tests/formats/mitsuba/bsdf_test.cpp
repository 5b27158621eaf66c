// BSDFs and textures of Mitsuba as materials.
#include <cmath>
#include <fstream>

#include "host/image/codecs.h"
#include "host/image/colour_transfer.h"
#include "host/image/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

using scene::TextureSlot;

const scene::LoadOptions kLenient{.lenient = true};

std::string bitmap(const std::string& name, const std::string& more = "") {
  return "<texture type=\"bitmap\" name=\"" + name + "\"><string name=\"filename\" value=\"a.png\"/>" + more +
         "</texture>";
}

/// A folder with an image of two texels: (0, 51, 102) at the left, and white.
class Picture {
 public:
  Picture() {
    image::Image image;
    image.width = 2;
    image.height = 1;
    image.rgb = {glm::vec3(0), glm::vec3(1)};
    image.rgb[0] = {0.0f, static_cast<float>(image::srgbDecode(0.2)), static_cast<float>(image::srgbDecode(0.4))};
    image::writeImage(folder_.path("a.png"), image, {});
  }
  scene::Scene sceneOf(const std::string& content) const {
    return loadXml(content, {}, "3.0.0", folder_.path("")).scene;
  }
  std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  TemporaryFolder folder_;
};

scene::TextureReference referenceIn(const scene::Scene& scene, TextureSlot slot) {
  const auto& reference = textureOf(scene.materials.at(0), slot);
  REQUIRE(reference);
  return *reference;
}

}  // namespace

/// The material of a rectangle with this BSDF, and the scene with those between which it is a choice.
struct WholeMaterial {
  scene::Scene scene;

  explicit WholeMaterial(const std::string& bsdf) : scene(xmlSceneOf(withBsdf(bsdf))) {}
  const scene::Material& own() const { return scene.materials.at(scene.primitives[0].material); }
  const scene::Material& first() const { return scene.materials.at(own().choice.value().first); }
  const scene::Material& second() const { return scene.materials.at(own().choice.value().second); }
};

TEST_CASE("A diffuse BSDF is black from behind, and twosided makes it two-sided") {
  const WholeMaterial one(R"(<bsdf type="diffuse"/>)");
  REQUIRE(one.own().choice);
  CHECK_FALSE(one.own().choice->weight);
  CHECK(one.first().diffuse == scene::DiffuseLobe{.colour = glm::vec3(0.5f)});
  CHECK(kindOf(one.second()) == scene::MaterialKind::black);
  CHECK(one.first().opaque);
  const WholeMaterial two(R"(<bsdf type="twosided"><bsdf type="diffuse"/></bsdf>)");
  CHECK(two.own().diffuse == one.first().diffuse);
  CHECK_FALSE(two.own().opaque);
  for (const char* const type : {"dielectric", "thindielectric", "null"}) {
    for (const scene::Material& material : xmlSceneOf(withBsdf(fmt::format(R"(<bsdf type="{}"/>)", type))).materials)
      CHECK_FALSE(material.choice);
  }
}

TEST_CASE("The sides of a surface may have different BSDFs") {
  const WholeMaterial sides(
      R"(<bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="1 0 0"/></bsdf>
<bsdf type="diffuse"><rgb name="reflectance" value="0 1 0"/></bsdf></bsdf>)");
  REQUIRE(sides.own().choice);
  CHECK_FALSE(sides.own().choice->weight);
  CHECK(sides.first().diffuse->colour == glm::vec3(1, 0, 0));
  CHECK(sides.second().diffuse->colour == glm::vec3(0, 1, 0));
  CHECK_FALSE(sides.second().opaque);
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="twosided"><bsdf type="diffuse"/><bsdf type="null"/></bsdf>)"))
            .find("2:69: a side of a surface that is \"null\"") != std::string::npos);
}

TEST_CASE("A blend is a choice by weight between its BSDFs") {
  const auto blend = [](const std::string& weight, const std::string& first, const std::string& second) {
    return fmt::format(R"(<bsdf type="blendbsdf"><float name="weight" value="{}"/>{}{}</bsdf>)", weight, first, second);
  };
  const std::string red = R"(<bsdf type="diffuse"><rgb name="reflectance" value="1 0 0"/></bsdf>)";
  const std::string mirror = R"(<bsdf type="conductor"/>)", none = R"(<bsdf type="null"/>)";
  const WholeMaterial both("<bsdf type=\"twosided\">" + blend("0.25", red, mirror) + "</bsdf>");
  REQUIRE(both.own().choice);
  CHECK(both.own().choice->weight == 0.25f);
  CHECK(both.first().diffuse->colour == glm::vec3(1, 0, 0));
  CHECK_FALSE(both.second().diffuse);

  const WholeMaterial oneSided(blend("0.25", red, mirror));
  REQUIRE(oneSided.first().choice);
  CHECK_FALSE(oneSided.first().choice->weight);
  CHECK(oneSided.scene.materials[oneSided.first().choice->first].diffuse->colour == glm::vec3(1, 0, 0));

  const scene::Material veil = materialOf(blend("0.25", none, red)), rest = materialOf(blend("0.25", red, none));
  CHECK(veil.opacity->factor == 0.25f);
  CHECK(veil.diffuse);
  CHECK(rest.opacity->factor == 0.75f);
  CHECK(xmlErrorsOf(withBsdf(blend("0.25", blend("0.5", red, mirror), red))).find("a blend in a blend") !=
        std::string::npos);
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="blendbsdf"><float name="weight" value="1"/></bsdf>)"))
            .find("has two nested BSDFs") != std::string::npos);
  CHECK(xmlErrorsOf(withBsdf("<bsdf type=\"blendbsdf\">" + red + mirror + "</bsdf>")).find("has no \"weight\"") !=
        std::string::npos);
}

TEST_CASE("Both BSDFs of a blend emit, and have its normal map") {
  const Picture picture;
  const scene::Scene scene = picture.sceneOf(
      "<shape type=\"rectangle\"><bsdf type=\"normalmap\">" +
      bitmap("normalmap", "<boolean name=\"raw\" value=\"true\"/>") + R"(<bsdf type="blendbsdf">)" + bitmap("weight") +
      R"(<bsdf type="diffuse"/><bsdf type="plastic"/></bsdf></bsdf><emitter type="area"/></shape>)");
  const auto last = static_cast<std::uint32_t>(scene.primitives.size() - 1);  // the back of the emitter precedes it
  const scene::Material& own = scene.materials.at(scene.primitives[last].material);
  REQUIRE(own.choice);
  CHECK(own.choice->weight == 1.0f);
  REQUIRE(textureOf(own, TextureSlot::baseColour));
  CHECK_FALSE(textureOf(own, TextureSlot::normal));
  CHECK(isEmissive(own));
  for (const std::uint32_t i : {own.choice->first, own.choice->second}) {
    CHECK(scene.materials[i].emission == own.emission);
    CHECK(textureOf(scene.materials[i], TextureSlot::normal));
  }
  CHECK(hasTangents(scene, scene.primitives[last]));
}

TEST_CASE("Dielectrics are single interfaces with the ratio of their indices of refraction and two colours") {
  const scene::Material glass = materialOf(R"(<bsdf type="dielectric"/>)");
  REQUIRE(glass.surface);
  CHECK(glass.surface->ior == Approx(1.5046 / 1.000277));
  CHECK(glass.surface->bareInterface == scene::Interface::smooth);
  CHECK(glass.surface->hasVolume());
  CHECK_FALSE(glass.opaque);
  const scene::Material bubble = materialOf(R"(<bsdf type="dielectric"><string name="int_ior" value="vacuum"/>
<float name="ext_ior" value="2"/><rgb name="specular_reflectance" value="0.5 0.6 0.7"/>
<rgb name="specular_transmittance" value="0.1 0.2 0.3"/></bsdf>)");
  CHECK(bubble.surface->ior == 0.5f);
  CHECK(bubble.surface->specularColour == glm::vec3(0.5f, 0.6f, 0.7f));
  CHECK(bubble.surface->baseColour == glm::vec3(0.1f, 0.2f, 0.3f));
  const scene::Material rough = materialOf(R"(<bsdf type="roughdielectric"><string name="distribution" value="ggx"/>
<float name="int_ior" value="1"/><float name="ext_ior" value="1.25"/><float name="alpha" value="0.25"/></bsdf>)");
  REQUIRE(rough.surface);
  CHECK(rough.surface->bareInterface == scene::Interface::ggx);
  CHECK(rough.surface->roughness == 0.5f);
  CHECK(rough.surface->ior == 0.8f);
  CHECK(rough.surface->transmissionWeight == 1);
  CHECK_FALSE(rough.surface->isThinWalled);
  const scene::Material pane = materialOf(R"(<bsdf type="thindielectric"><float name="int_ior" value="1.5"/>
<float name="ext_ior" value="1"/></bsdf>)");
  CHECK(pane.surface->bareInterface == scene::Interface::smooth);
  CHECK(pane.surface->ior == 1.5f);
  CHECK(pane.surface->isThinWalled);
}

TEST_CASE("Conductors are single interfaces with the distribution of normals that is stated") {
  const auto shape = [](const std::string& bsdf) { return materialOf(bsdf).surface->bareInterface; };
  CHECK(shape(R"(<bsdf type="conductor"><string name="material" value="Cu"/></bsdf>)") == scene::Interface::smooth);
  CHECK(shape(R"(<bsdf type="roughconductor"/>)") == scene::Interface::beckmann);
  CHECK(shape(R"(<bsdf type="roughconductor"><string name="distribution" value="GGX"/></bsdf>)") ==
        scene::Interface::ggx);
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="roughconductor"><string name="distribution" value="gx"/></bsdf>)"))
            .find("\"gx\" is no distribution of microfacets") != std::string::npos);
}

TEST_CASE("Plastics have the boundary, the index of refraction and the colours that are stated") {
  const scene::SurfaceParameters smooth = *materialOf(R"(<bsdf type="plastic"/>)").surface;
  CHECK(smooth.baseColour == glm::vec3(0.5f));
  CHECK(smooth.specularColour == glm::vec3(1));
  CHECK(smooth.ior == Approx(1.49 / 1.000277));
  CHECK(smooth.plastic == scene::makePlastic(scene::Interface::smooth, 0, smooth.ior));
  const auto rough = [](const std::string& properties) {
    return *materialOf(
                R"(<bsdf type="roughplastic"><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/>)" +
                properties + "</bsdf>")
                .surface;
  };
  const scene::SurfaceParameters absent = rough("");
  CHECK(absent.roughness == Approx(std::sqrt(0.1)));
  CHECK(absent.plastic == scene::makePlastic(scene::Interface::beckmann, absent.roughness, 1.5f));
  const scene::SurfaceParameters stated = rough(
      R"(<string name="distribution" value="ggx"/><float name="alpha" value="0.25"/>
<boolean name="nonlinear" value="true"/><rgb name="diffuse_reflectance" value="0.1 0.2 0.3"/>
<rgb name="specular_reflectance" value="0.5 0.6 0.7"/>)");
  CHECK(stated.plastic == scene::makePlastic(scene::Interface::ggx, 0.5f, 1.5f, true));
  CHECK(stated.baseColour == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(stated.specularColour == glm::vec3(0.5f, 0.6f, 0.7f));
}

TEST_CASE("Anisotropic conductors are rougher along u or v") {
  const auto with = [](const char* u, const char* v) {
    return *materialOf(std::string(R"(<bsdf type="roughconductor"><string name="distribution" value="ggx"/>)") +
                       "<float name=\"alpha_u\" value=\"" + u + "\"/><float name=\"alpha_v\" value=\"" + v +
                       "\"/></bsdf>")
                .surface;
  };
  const scene::SurfaceParameters alongU = with("0.3", "0.1"), alongV = with("0.1", "0.3");
  const auto alphas = [](const scene::SurfaceParameters& s) {
    const double across = double{s.roughness} * s.roughness;
    return std::pair(across + (1 - across) * double{s.anisotropy} * s.anisotropy, across);
  };
  CHECK(alphas(alongU).first == Approx(0.3));
  CHECK(alphas(alongU).second == Approx(0.1));
  CHECK(alongU.anisotropyRotation == 0);
  CHECK(alongV.anisotropyRotation == Approx(std::acos(0.0)));
  CHECK(alongV.anisotropy == alongU.anisotropy);
}

TEST_CASE("What Mitsuba's BSDFs have and Candela does not is an error, or a replacement with a warning") {
  const auto check = [](const std::string& bsdf, const std::string& message) {
    CAPTURE(bsdf);
    CHECK(xmlErrorsOf(withBsdf(bsdf)).find(message) != std::string::npos);
    const scene::LoadedScene loaded = loadXml(withBsdf(bsdf), kLenient);
    CHECK(loaded.scene.primitives.size() == 2);
    CHECK_FALSE(loaded.warnings.empty());
  };
  check(R"(<bsdf type="plastic"><float name="int_ior" value="0.9"/></bsdf>)",
        "2:25: plastic whose index of refraction is at most that of its outside is not rendered; lenient renders");
  check(R"(<bsdf type="roughconductor"><string name="distribution" value="phong"/></bsdf>)",
        "the distribution \"phong\" is not rendered; lenient renders \"ggx\"");
  check(R"(<bsdf type="roughdielectric"><float name="int_ior" value="1.001"/><float name="ext_ior" value="1"/></bsdf>)",
        "differ by a factor of less than 1.01 is not rendered; lenient renders that factor");
  check(R"(<bsdf type="coating"><bsdf type="diffuse"/></bsdf>)",
        "\"coating\" is not rendered; lenient renders its nested BSDF");
  check(R"(<bsdf type="hair"><float name="scale" value="3"/></bsdf>)",
        "bsdf \"hair\" is not rendered; lenient renders grey instead");
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="difuse"/>)"), kLenient) ==
        "test.xml:2:25: unknown BSDF \"difuse\"; did you mean \"diffuse\"?");
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="diffuse"><float name="reflectence" value="1"/></bsdf>)")) ==
        "test.xml:2:46: bsdf \"diffuse\" has no property \"reflectence\"; did you mean \"reflectance\"?; lenient "
        "leaves it out");
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="diffuse"><rgb name="reflectance" value="1 2 1"/></bsdf>)"))
            .find("a reflectance is at most 1") != std::string::npos);
}

TEST_CASE("Masks are opacities, and null surfaces are left out") {
  const scene::Material leaf = materialOf(R"(<bsdf type="mask"><float name="opacity" value="0.25"/>
<bsdf type="diffuse"/></bsdf>)");
  REQUIRE(leaf.opacity);
  CHECK(leaf.opacity->factor == 0.25f);
  CHECK(leaf.diffuse);
  CHECK(xmlSceneOf(withBsdf(R"(<bsdf type="null"/>)") + "<shape type=\"sphere\"/>").primitives.size() == 1);
}

TEST_CASE("Images are stored as their file has them, or in the encoding of their slot") {
  const Picture picture;
  const scene::Scene plain = picture.sceneOf(withBsdf("<bsdf type=\"diffuse\">" + bitmap("reflectance") + "</bsdf>"));
  REQUIRE(plain.images.size() == 1);
  CHECK(plain.images[0].texels == std::vector<std::uint32_t>{0xff663300u, 0xffffffffu});
  const scene::TextureReference reference = referenceIn(plain, TextureSlot::baseColour);
  CHECK(reference.rowS == glm::vec3(1, 0, 0));
  CHECK(reference.rowT == glm::vec3(0, 1, 0));
  CHECK(plain.materials[0].diffuse->colour == glm::vec3(1));

  const scene::Scene raw = picture.sceneOf(withBsdf(
      "<bsdf type=\"diffuse\">" + bitmap("reflectance", "<boolean name=\"raw\" value=\"true\"/>") + "</bsdf>"));
  REQUIRE(raw.images.at(0).isDeep());
  const double green = static_cast<double>(raw.images[0].deepTexels[0] >> 16 & 65535) / 65535;
  CHECK(image::srgbDecode(green) == Approx(0.2).epsilon(1e-4));

  const scene::Scene alpha = picture.sceneOf(withBsdf("<bsdf type=\"mask\">" +
                                                      bitmap("opacity", "<boolean name=\"raw\" value=\"true\"/>") +
                                                      "<bsdf type=\"diffuse\"/></bsdf>"));
  const double opacity = static_cast<double>(alpha.images.at(0).deepTexels[0] >> 48) / 65535;
  CHECK(opacity == Approx(0.7152 * 0.2 + 0.0722 * 0.4).epsilon(1e-3));

  const scene::Scene rough = picture.sceneOf(
      withBsdf(R"(<bsdf type="roughconductor"><string name="distribution" value="ggx"/>)" +
               bitmap("alpha", "<boolean name=\"raw\" value=\"true\"/>") + "</bsdf>"));
  const double roughness = static_cast<double>(rough.images.at(0).deepTexels[0] >> 16 & 65535) / 65535;
  CHECK(roughness * roughness == Approx(0.7152 * 0.2 + 0.0722 * 0.4).epsilon(1e-3));
  CHECK(rough.materials[0].surface->roughness == 1);
  CHECK((rough.images[0].deepTexels[0] >> 32 & 65535) == 65535);

  const auto both = [&](const std::string& u, const std::string& v) {
    return withBsdf("<bsdf type=\"roughconductor\">" + bitmap("alpha_u", u) + bitmap("alpha_v", v) + "</bsdf>");
  };
  const scene::Scene isotropic = picture.sceneOf(both("", ""));
  CHECK(isotropic.materials[0].surface->anisotropy == 0);
  CHECK(referenceIn(isotropic, TextureSlot::metallicRoughness).image == 0);
  CHECK_FALSE(textureOf(isotropic.materials[0], TextureSlot::anisotropy));
  CHECK(isotropic.images.size() == 1);
  CHECK(
      xmlErrorsOf(both("", "<string name=\"wrap_mode\" value=\"clamp\"/>"), {}, "3.0.0", picture.path(""))
          .find(
              "textures of the roughness or the metalness of bsdf \"roughconductor\" that have different transforms") !=
      std::string::npos);

  const scene::Scene glass = picture.sceneOf(
      withBsdf("<bsdf type=\"dielectric\">" + bitmap("specular_reflectance") + "</bsdf>"));
  CHECK(referenceIn(glass, TextureSlot::specularColour).image == 0);
}

/// Alpha along the tangent and across it, and the metalness, that texel i of the textures of a material means.
glm::dvec3 microfacetsAt(const scene::Scene& scene, std::size_t i) {
  const scene::Material& material = scene.materials.at(0);
  const auto texel = [&](TextureSlot slot) {
    const std::uint64_t bits = scene.images.at(textureOf(material, slot).value().image).deepTexels.at(i);
    return glm::dvec4(bits & 65535, bits >> 16 & 65535, bits >> 32 & 65535, bits >> 48) / 65535.0;
  };
  const glm::dvec4 rough = texel(TextureSlot::metallicRoughness);
  const double roughness = rough.y * double{material.surface->roughness};
  const double across = roughness * roughness;
  if (!textureOf(material, TextureSlot::anisotropy)) return {across, across, rough.z};
  const glm::dvec4 facets = texel(TextureSlot::anisotropy);
  const double strength = facets.z * double{material.surface->anisotropy};
  const double along = glm::mix(across, 1.0, strength * strength);
  const glm::dvec2 direction = 2.0 * glm::dvec2(facets) - 1.0;
  CHECK(std::max(direction.x, direction.y) == Approx(1));
  CHECK(std::abs(std::min(direction.x, direction.y)) < 1e-4);
  return direction.x > direction.y ? glm::dvec3(along, across, rough.z) : glm::dvec3(across, along, rough.z);
}

bool isNear(const glm::dvec3& a, const glm::dvec3& b) { return length(a - b) < 1e-4; }

TEST_CASE("Textures of alpha_u and alpha_v are converted texel by texel, as one of them and a number are") {
  const auto board = [](const char* name, const char* even, const char* odd, const char* scale) {
    return fmt::format(R"(<texture type="checkerboard" name="{}"><float name="color0" value="{}"/>
<float name="color1" value="{}"/><transform name="to_uv">{}</transform></texture>)",
                       name, even, odd, scale);
  };
  const char* const scaled = R"(<scale x="-25" y="5"/>)";
  const auto rough = [](const std::string& content) {
    return withBsdf("<bsdf type=\"roughconductor\">" + content + "</bsdf>");
  };
  const scene::Scene both = xmlSceneOf(
      rough(board("alpha_u", "0.05", "0.3", scaled) + board("alpha_v", "0.2", "0.1", scaled)));
  CHECK(isNear(microfacetsAt(both, 0), {0.3, 0.1, 1}));
  CHECK(isNear(microfacetsAt(both, 1), {0.05, 0.2, 1}));
  CHECK(isNear(microfacetsAt(both, 2), microfacetsAt(both, 1)));
  CHECK(referenceIn(both, TextureSlot::anisotropy).filter == scene::TextureFilter::nearest);
  CHECK(referenceIn(both, TextureSlot::anisotropy).rowS == glm::vec3(-25, 0, 0));
  CHECK(referenceIn(both, TextureSlot::metallicRoughness).rowT == glm::vec3(0, 5, 0));
  const scene::Scene one = xmlSceneOf(
      rough(R"(<float name="alpha_u" value="0.2"/>)" + board("alpha_v", "0", "2", scaled)));
  CHECK(isNear(microfacetsAt(one, 0), {0.2, 1, 1}));
  CHECK(isNear(microfacetsAt(one, 1), {0.2, 1e-4, 1}));
  const scene::Scene twice = xmlSceneOf(
      rough(board("alpha_u", "0.05", "0.3", scaled) + board("alpha_v", "0.2", "0.1", scaled)) +
      rough(board("alpha_u", "0.05", "0.3", scaled) + board("alpha_v", "0.2", "0.1", scaled)));
  CHECK(twice.images.size() == 2);

  const std::string turned = rough(board("alpha_u", "0.05", "0.3", R"(<rotate z="1" angle="30"/>)") +
                                   board("alpha_v", "0.2", "0.1", R"(<rotate z="1" angle="30"/>)"));
  CHECK(xmlErrorsOf(turned).find("that \"to_uv\" turns are rendered without anisotropy; lenient takes the smaller") !=
        std::string::npos);
  CHECK(isNear(microfacetsAt(loadXml(turned, kLenient).scene, 0), {0.1, 0.1, 1}));
  const std::string apart = rough(board("alpha_u", "0.05", "0.3", scaled) + board("alpha_v", "0.2", "0.1", ""));
  CHECK(xmlErrorsOf(apart).find("have different transforms, wrap modes or filters are not rendered") !=
        std::string::npos);
  CHECK(isNear(microfacetsAt(loadXml(apart, kLenient).scene, 0), {0.3, 0.2, 1}));
}

TEST_CASE("Principled BSDFs have textures of roughness, anisotropy, metalness and transmission") {
  const auto board = [](const char* name, const char* even, const char* odd) {
    return fmt::format(R"(<texture type="checkerboard" name="{}"><float name="color0" value="{}"/>
<float name="color1" value="{}"/></texture>)",
                       name, even, odd);
  };
  const auto principled = [](const std::string& content) {
    return xmlSceneOf(withBsdf("<bsdf type=\"principled\">" + content + "</bsdf>"));
  };
  const scene::Scene metal = principled(board("metallic", "0.25", "0.75") + R"(<float name="roughness" value="0.5"/>)");
  CHECK(metal.materials[0].surface->metalness == 1);
  CHECK(isNear(microfacetsAt(metal, 0), {0.25, 0.25, 0.75}));
  CHECK(isNear(microfacetsAt(metal, 1), {0.25, 0.25, 0.25}));
  const scene::Scene rough = principled(board("roughness", "0", "0.8") + R"(<float name="metallic" value="0.25"/>)");
  CHECK(isNear(microfacetsAt(rough, 0), {0.64, 0.64, 0.25}));
  CHECK(isNear(microfacetsAt(rough, 1), {0.001, 0.001, 0.25}));
  const scene::Scene brushed = principled(board("roughness", "0.2", "0.5") + board("anisotropic", "0", "0.4") +
                                          board("metallic", "1", "0"));
  CHECK(isNear(microfacetsAt(brushed, 0), {0.3125, 0.2, 0}));
  CHECK(isNear(microfacetsAt(brushed, 1), {0.04, 0.04, 1}));
  const scene::SurfaceParameters constant = *principled(R"(<float name="roughness" value="0.5"/>
<float name="anisotropic" value="0.4"/><float name="metallic" value="0.25"/>)")
                                                 .materials[0]
                                                 .surface;
  CHECK(constant.roughness == Approx(std::sqrt(0.2)));
  CHECK(constant.anisotropy == Approx(std::sqrt(0.1125 / 0.8)));
  CHECK(constant.anisotropyRotation == 0);
  CHECK(constant.metalness == 0.25f);

  const scene::Scene glass = principled(board("spec_trans", "0.25", "0.5"));
  CHECK(glass.materials[0].surface->hasVolume());
  CHECK(glass.materials[0].surface->transmissionWeight == 1);
  CHECK_FALSE(glass.materials[0].opaque);
  const scene::TextureImage& image = glass.images.at(referenceIn(glass, TextureSlot::transmission).image);
  CHECK((image.deepTexels.at(0) & 65535) == 32768);
  CHECK((image.deepTexels.at(1) & 65535) == 16384);
}

TEST_CASE("Bitmaps have the filter, the wrap mode and the transform that the file states") {
  const Picture picture;
  const scene::Scene scene = picture.sceneOf(withBsdf("<bsdf type=\"diffuse\">" + bitmap("reflectance", R"(
<string name="filter_type" value="nearest"/><string name="wrap_mode" value="mirror"/>
<transform name="to_uv"><scale x="2" y="3"/><translate x="0.25" y="0.5"/></transform>)") +
                                                      "</bsdf>"));
  const scene::TextureReference reference = referenceIn(scene, TextureSlot::baseColour);
  CHECK(reference.filter == scene::TextureFilter::nearest);
  CHECK(reference.wrapS == scene::TextureWrap::mirroredRepeat);
  CHECK(reference.wrapT == scene::TextureWrap::mirroredRepeat);
  CHECK(reference.rowS == glm::vec3(2, 0, 0.25f));
  CHECK(reference.rowT == glm::vec3(0, 3, 0.5f));
  const std::string missing =
      "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string name=\"filename\" "
      "value=\"b.png\"/></texture></bsdf>";
  CHECK(xmlErrorsOf(withBsdf(missing), {}, "3.0.0", picture.path("")).find("2:46: image \"b.png\": ") !=
        std::string::npos);
  CHECK(loadXml(withBsdf(missing), kLenient, "3.0.0", picture.path("")).scene.images.empty());
}

TEST_CASE("A checkerboard is an image of two by two texels, whose colours numbers exchange") {
  const std::string board =
      R"(<texture type="checkerboard" name="NAME"><rgb name="color0" value="0.25"/><float name="color1" value="0.5"/></texture>)";
  const auto named = [&](const std::string& name) {
    std::string text = board;
    return text.replace(text.find("NAME"), 4, name);
  };
  const scene::Scene scene = xmlSceneOf(withBsdf("<bsdf type=\"diffuse\">" + named("reflectance") + "</bsdf>"));
  const scene::TextureImage& image = scene.images.at(0);
  CHECK(image.width == 2);
  REQUIRE(image.deepTexels.size() == 4);
  const auto valueAt = [&](std::size_t i) {
    return image::srgbDecode(static_cast<double>(image.deepTexels[i] & 65535) / 65535);
  };
  CHECK(valueAt(0) == Approx(0.25).epsilon(1e-4));
  CHECK(valueAt(1) == Approx(0.5).epsilon(1e-4));
  CHECK(valueAt(2) == valueAt(1));
  CHECK(valueAt(3) == valueAt(0));
  CHECK(referenceIn(scene, TextureSlot::baseColour).filter == scene::TextureFilter::nearest);
  const scene::Scene mask = xmlSceneOf(
      withBsdf("<bsdf type=\"mask\">" + named("opacity") + "<bsdf type=\"diffuse\"/></bsdf>"));
  CHECK((mask.images.at(0).deepTexels[0] >> 48) == 32768);
}

TEST_CASE("Bump maps are normal maps of heights") {
  const Picture picture;
  const scene::Scene scene = picture.sceneOf(withBsdf("<bsdf type=\"bumpmap\"><float name=\"scale\" value=\"0.5\"/>" +
                                                      bitmap("bumps") + "<bsdf type=\"diffuse\"/></bsdf>"));
  const scene::Material& material = scene.materials.at(0);
  CHECK(material.hasHeights);
  CHECK(material.normalScale == 0.5f);
  REQUIRE(scene.images.at(0).isDeep());
  const double grey = image::luminance({0, image::srgbDecode(0.2), image::srgbDecode(0.4)});
  CHECK(static_cast<double>(scene.images[0].deepTexels[0] & 65535) / 65535 == Approx(grey).margin(1e-5));
  CHECK(scene.meshes.at(0).tangents.size() == 6);
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="bumpmap"><bsdf type="diffuse"/></bsdf>)")).find("has a nested texture") !=
        std::string::npos);
}

TEST_CASE("Normal maps make surfaces with tangents, whose second one does not depend on the image") {
  const Picture picture;
  const scene::Scene scene = picture.sceneOf(withBsdf("<bsdf type=\"normalmap\">" +
                                                      bitmap("normalmap", "<boolean name=\"raw\" value=\"true\"/>") +
                                                      "<bsdf type=\"diffuse\"/></bsdf>"));
  const scene::Material& material = scene.materials.at(0);
  REQUIRE(material.surface);
  CHECK(material.surface->specularWeight == 0);
  CHECK(material.surface->baseColour == glm::vec3(0.5f));
  CHECK(scene.images.at(0).texels[0] == 0xff663300u);
  const std::vector<glm::vec4>& tangents = scene.meshes.at(0).tangents;
  REQUIRE(tangents.size() == 6);
  CHECK(near(glm::vec3(tangents[0]), {1, 0, 0}));
  CHECK(tangents[0].w == 1);
}

}  // namespace candela::mitsuba
