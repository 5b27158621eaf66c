// Malformed files: each is refused with the place of its error.
#include <functional>

#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// A change to a valid file, and the beginning of its only error after the file's name.
struct Malformed {
  std::function<void(GltfFile&)> change;
  std::string error;
};

/// The triangle with indices, a material, a second node, a camera and a light.
GltfFile goodFile() {
  GltfFile file = triangleFile();
  file.primitive()["indices"] = file.accessor<std::uint16_t>({0, 1, 2}, kUnsignedShort, "SCALAR", 3);
  file.primitive()["attributes"]["NORMAL"] = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  file.primitive()["material"] = 0;
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0.5}}}}};
  file.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}}}}};
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", json::object()}}};
  file.addNode({{"camera", 0}, {"translation", {0, 0, 3}}});
  json lamp{{"translation", {0, 0, 3}}};
  lamp["extensions"]["KHR_lights_punctual"]["light"] = 0;
  file.addNode(lamp);
  return file;
}

/// Sets the value at a JSON pointer.
std::function<void(GltfFile&)> set(const std::string& pointer, const json& value) {
  return [=](GltfFile& file) { file.root[json::json_pointer(pointer)] = value; };
}
std::function<void(GltfFile&)> drop(const std::string& parent, const std::string& key) {
  return [=](GltfFile& file) { file.root[json::json_pointer(parent)].erase(key); };
}
/// Overwrites a float of the binary data.
std::function<void(GltfFile&)> poke(std::size_t offset, float value) {
  return [=](GltfFile& file) { std::memcpy(file.binary.data() + offset, &value, sizeof(value)); };
}

const json kHuge = 4294967296ull * 1048576;  // 2^52
const float kInfinity = std::numeric_limits<float>::infinity();

const std::vector<Malformed> kMalformed{
    // The root
    {[](GltfFile& file) { file.root = json::array(); }, "the root: expected an object"},
    {drop("", "asset"), "the root: the property \"asset\" is missing"},
    {drop("/asset", "version"), "/asset: the property \"version\" is missing"},
    {set("/asset/version", 2), "/asset/version: expected a string"},
    {set("/asset", "2.0"), "/asset: expected an object"},
    {set("/extensionsRequired", "KHR_x"), "/extensionsRequired: expected an array"},
    {set("/extensionsRequired", {7}), "/extensionsRequired/0: expected a string"},
    {set("/extensionsUsed", json::array({json::object()})), "/extensionsUsed/0: expected a string"},
    {set("/extensions", 1), "/extensions: expected an object"},
    // Buffers
    {set("/buffers", json::object()), "/buffers: expected an array"},
    {set("/buffers", json::array()), "/bufferViews/0/buffer: index 0 into \"buffers\", which has 0 elements"},
    {set("/buffers", {{{"byteLength", 9}}}), "/buffers/0: the buffer has no \"uri\""},
    {set("/buffers", {{{"byteLength", 9}, {"uri", "http://example.org/a.bin"}}}),
     "/buffers/0/uri: only relative paths"},
    {set("/buffers", {{{"byteLength", 9}, {"uri", "nothing.bin"}}}), "/buffers/0/uri: ./nothing.bin: cannot open"},
    {set("/buffers", {{{"byteLength", 9}, {"uri", "/etc/passwd"}}}), "/buffers/0/uri: \"/etc/passwd\" is outside"},
    {set("/buffers", {{{"byteLength", 9}, {"uri", "a%2"}}}), "/buffers/0/uri: \"%\" without two hexadecimal digits"},
    {set("/buffers", {{{"byteLength", 9}, {"uri", "a%00b"}}}), "/buffers/0/uri: the path contains a zero byte"},
    {set("/buffers", {{{"byteLength", 9}, {"uri", ""}}}), "/buffers/0/uri: the URI is empty"},
    {set("/buffers", {{{"byteLength", kHuge}, {"uri", "data:;base64,AAAA"}}}),
     "/buffers/0/byteLength: 4503599627370496 bytes are stated, but there are only 3"},
    {set("/buffers", {{{"byteLength", -1}, {"uri", "data:;base64,AAAA"}}}), "/buffers/0/byteLength: expected a whole"},
    // Buffer views
    {set("/bufferViews/0/buffer", 1), "/bufferViews/0/buffer: index 1 into \"buffers\""},
    {set("/bufferViews/0/byteOffset", 200), "/bufferViews/0: bytes 200 to 236 of a buffer of 78 bytes"},
    {set("/bufferViews/0/byteOffset", kHuge), "/bufferViews/0: bytes 4503599627370496 to"},
    {set("/bufferViews/0/byteLength", kHuge), "/bufferViews/0: bytes 0 to 4503599627370496"},
    {set("/bufferViews/0/byteLength", 0), "/bufferViews/0/byteLength: a view of 0 bytes"},
    {set("/bufferViews/0/byteLength", 1e300), "/bufferViews/0/byteLength: expected a whole number"},
    {set("/bufferViews/0/byteLength", 35), "/accessors/0: 3 elements end at byte 36 of a buffer view of 35 bytes"},
    {set("/bufferViews/0/byteStride", 2), "/bufferViews/0/byteStride: 2 is outside 4 to 252"},
    {set("/bufferViews/0/byteStride", 8), "/accessors/0: elements of 12 bytes overlap"},
    {set("/bufferViews/0/byteStride", 16), "/accessors/0: 3 elements end at byte 44"},
    // Accessors
    {set("/accessors/0/bufferView", 99), "/accessors/0/bufferView: index 99 into \"bufferViews\""},
    {set("/accessors/0/count", 2147483648u), "/accessors/0: 2147483648 elements end at byte 25769803776"},
    {set("/accessors/0/count", kHuge), "/accessors/0/count: 4503599627370496 elements"},
    {set("/accessors/0/count", 0), "/accessors/0/count: 0 elements"},
    {set("/accessors/0/count", 2.5), "/accessors/0/count: expected a whole number"},
    {set("/accessors/0/count", -3), "/accessors/0/count: expected a whole number"},
    {set("/accessors/0/count", "3"), "/accessors/0/count: expected a whole number"},
    {set("/accessors/0/byteOffset", kHuge), "/accessors/0: 3 elements end at byte 4503599627370532"},
    {set("/accessors/0/componentType", 5124), "/accessors/0/componentType: 5124 is not a component type"},
    {set("/accessors/0/type", "VEC5"), "/accessors/0/type: \"VEC5\" is not a type of elements"},
    {set("/accessors/0/type", "VEC2"), "/meshes/0/primitives/0/attributes/POSITION: the accessor's elements have 2"},
    {set("/accessors/0/normalized", true), "/accessors/0/normalized: only bytes and shorts"},
    {poke(4, std::nanf("")), "/accessors/0: element 0 is not finite"},
    {poke(32, kInfinity), "/accessors/0: element 2 is not finite"},
    {set("/accessors/0/sparse", {{"count", 4}}), "/accessors/0/sparse/count: 4 of 3 elements are replaced"},
    {set("/accessors/0/sparse", {{"count", 1}}), "/accessors/0/sparse: the property \"indices\" is missing"},
    {set("/accessors/0/sparse", {{"count", 2},
                                 {"indices", {{"bufferView", 1}, {"componentType", kUnsignedByte}}},
                                 {"values", {{"bufferView", 0}}}}),
     "/accessors/0/sparse/indices: index 0 of element 1 is not below 3, or not above the one before"},
    {set("/accessors/0/sparse",
         {{"count", 1},
          {"indices", {{"bufferView", 0}, {"byteOffset", 14}, {"componentType", kUnsignedShort}}},
          {"values", {{"bufferView", 0}}}}),
     "/accessors/0/sparse/indices: index 16256 of element 0 is not below 3"},
    {set("/accessors/0/sparse", {{"count", 1}, {"indices", {{"bufferView", 1}, {"componentType", kFloat}}}}),
     "/accessors/0/sparse/indices: the accessor's elements are not unsigned"},
    // Meshes
    {set("/nodes/0/mesh", 5), "/nodes/0/mesh: index 5 into \"meshes\", which has 1 elements"},
    {drop("/meshes/0", "primitives"), "/meshes/0: the property \"primitives\" is missing"},
    {drop("/meshes/0/primitives/0", "attributes"), "/meshes/0/primitives/0: the property \"attributes\" is missing"},
    {set("/meshes/0/primitives/0/mode", 7), "/meshes/0/primitives/0/mode: 7 is not a mode"},
    {set("/meshes/0/primitives/0/material", 1), "/meshes/0/primitives/0/material: index 1 into \"materials\""},
    {set("/meshes/0/primitives/0/indices", 0), "/meshes/0/primitives/0/indices: the accessor's elements are not"},
    {set("/meshes/0/primitives/0/indices", -1), "/meshes/0/primitives/0/indices: expected a whole number"},
    {[](GltfFile& file) { file.binary[40] = 3; }, "/meshes/0/primitives/0/indices: element 2 is 3, but there are 3"},
    {set("/meshes/0/primitives/0/attributes/NORMAL", 1),
     "/meshes/0/primitives/0/attributes/NORMAL: the accessor's elements have 1"},
    {set("/accessors/2/count", 2), "/meshes/0/primitives/0/attributes/NORMAL: 2 values for 3 vertices"},
    {[](GltfFile& file) {
       file.primitive()["targets"] = {{{"POSITION", file.positions({1, 1, 1})}}};
       file.root["meshes"][0]["weights"] = {1};
     },
     "/meshes/0/primitives/0/targets/0/POSITION: 1 values for 3 vertices"},
    {set("/meshes/0/weights", {"1"}), "/meshes/0/weights/0: expected a number"},
    // Nodes
    {set("/nodes/0/children", {0}), "/nodes/0: the node is its own ancestor"},
    {[](GltfFile& file) {
       file.root["nodes"][0]["children"] = {1};
       file.root["nodes"][1]["children"] = {0};
     },
     "/nodes/0: the node is its own ancestor"},
    {[](GltfFile& file) {
       file.root["nodes"].push_back({{"children", {0}}});
       file.root["nodes"].push_back({{"children", {0}}});
     },
     "/nodes/4/children/0: node 0 has another parent already"},
    {set("/nodes/0/children", {77}), "/nodes/0/children/0: index 77 into \"nodes\""},
    {set("/nodes/0/matrix", {1, 2, 3}), "/nodes/0/matrix: expected an array of 16 numbers"},
    {set("/nodes/0/matrix", {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), "/nodes/0/matrix: the last row is not"},
    {set("/nodes/0/translation", {1, 2}), "/nodes/0/translation: expected an array of 3 numbers"},
    {set("/nodes/0/translation", {1e39, 0, 0}), "/nodes/0/translation/0: the number is too large"},
    {set("/nodes/0/translation", {3.4028236e+38, 0, 0}), "/nodes/0/translation/0: the number is too large"},
    {set("/nodes/0/rotation", {0, 0, 0, "w"}), "/nodes/0/rotation/3: expected a number"},
    {[](GltfFile& file) {
       file.root["nodes"][0]["scale"] = {3e38, 1, 1};
       file.root["nodes"].push_back({{"children", {0}}, {"scale", {3e38, 1, 1}}});
       file.root["scenes"][0]["nodes"] = {3};
     },
     "/nodes/0: a vertex is placed beyond the range"},
    {set("/scene", 3), "/scene: index 3 into \"scenes\", which has 1 elements"},
    {set("/scenes/0/nodes", {0, 0}), "/scenes/0/nodes/1: node 0 is in the scene twice"},
    {set("/scenes/0/nodes", {9}), "/scenes/0/nodes/0: index 9 into \"nodes\""},
    {[](GltfFile& file) {
       file.root["nodes"][1]["children"] = {0};
       file.root["nodes"][1]["translation"] = {1, 0, 0};
       file.root["scenes"][0]["nodes"] = {0};
     },
     "/scenes/0/nodes/0: node 0 is no root, and its ancestors have transforms"},
    // Instances and skins
    {set("/nodes/0/extensions/EXT_mesh_gpu_instancing", json::object()),
     "/nodes/0/extensions/EXT_mesh_gpu_instancing: the property \"attributes\""},
    {[](GltfFile& file) {
       file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
           {"TRANSLATION", 0}, {"SCALE", file.positions({1, 1, 1})}};
     },
     "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes: attributes of 1 and 3 instances"},
    {[](GltfFile& file) {
       file.root["nodes"][0]["skin"] = 0;
       file.root["skins"] = {{{"joints", {1}}}};
       json& attributes = file.primitive()["attributes"];
       attributes["JOINTS_0"] = file.accessor<std::uint8_t>({0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0}, kUnsignedByte, "VEC4",
                                                            3);
       attributes["WEIGHTS_0"] = file.vectors(std::vector<float>(12, 0.25f), "VEC4", 4);
     },
     "/meshes/0/primitives/0: vertex 1 has joint 4, but the skin has 1"},
    // Materials, cameras, lights
    {set("/materials/0/pbrMetallicRoughness/metallicFactor", 1.5),
     "/materials/0/pbrMetallicRoughness/metallicFactor: 1.5 is outside 0 to 1"},
    {set("/materials/0/pbrMetallicRoughness/roughnessFactor", -0.5),
     "/materials/0/pbrMetallicRoughness/roughnessFactor: -0.5 is outside"},
    {set("/materials/0/pbrMetallicRoughness/baseColorFactor", {1, 1, 1}),
     "/materials/0/pbrMetallicRoughness/baseColorFactor: expected an array of 4 numbers"},
    {set("/materials/0/emissiveFactor", {0, -2, 0}), "/materials/0/emissiveFactor: a component is negative"},
    {set("/materials/0/alphaMode", "GLOW"), "/materials/0/alphaMode: \"GLOW\" is not OPAQUE, MASK or BLEND"},
    {set("/materials/0/doubleSided", 1), "/materials/0/doubleSided: expected true or false"},
    {set("/materials/0/extensions/KHR_materials_ior/ior", 0.5),
     "/materials/0/extensions/KHR_materials_ior/ior: the index"},
    {set("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", -1),
     "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength: -1 is negative"},
    {set("/nodes/1/camera", 3), "/nodes/1/camera: index 3 into \"cameras\""},
    {set("/cameras/0/perspective/yfov", 4), "/cameras/0/perspective/yfov: the angle is outside 0 to pi"},
    {set("/cameras/0/perspective/aspectRatio", 0), "/cameras/0/perspective/aspectRatio: the ratio is not positive"},
    {drop("/cameras/0", "perspective"), "/cameras/0: the property \"perspective\" is missing"},
    {set("/nodes/2/extensions/KHR_lights_punctual/light", 1),
     "/nodes/2/extensions/KHR_lights_punctual/light: index 1 into \"lights\""},
    {set("/extensions/KHR_lights_punctual/lights/0/type", "area"),
     "/extensions/KHR_lights_punctual/lights/0/type: \"area\" is not point, spot or directional"},
    {set("/extensions/KHR_lights_punctual/lights/0/intensity", -1),
     "/extensions/KHR_lights_punctual/lights/0: a colour or intensity is negative"},
    {set("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", 2),
     "/extensions/KHR_lights_punctual/lights/0/spot: the angles of the cones"},
};

}  // namespace

TEST_CASE("each error in a file is reported with its JSON pointer and exit code 2") {
  REQUIRE(errorsOf(goodFile().text()).empty());
  for (const Malformed& malformed : kMalformed) {
    GltfFile file = goodFile();
    malformed.change(file);
    const std::string error = errorsOf(file.text());
    CAPTURE(malformed.error, error);
    CHECK(error.starts_with("test.gltf: " + malformed.error));
  }
}

TEST_CASE("damaged GLB files are refused") {
  const std::string good = goodFile().glb();
  const auto with = [&](std::size_t offset, char byte) {
    std::string bytes = good;
    bytes[offset] = byte;
    return errorsOf(bytes);
  };
  CHECK(errorsOf(good.substr(0, 11)) == "test.gltf: GLB: the file ends within the header of 12 bytes");
  CHECK(errorsOf(good.substr(0, good.size() - 1)).find("GLB: the header states") != std::string::npos);
  CHECK(with(4, 1).find("GLB: container version 1") != std::string::npos);
  CHECK(with(8, 3).find("GLB: ") != std::string::npos);
  CHECK(with(15, 0x7f).find("GLB: the chunk at byte 12 has") != std::string::npos);
  CHECK(with(16, 'j').find("GLB: the first chunk is not JSON") != std::string::npos);
  CHECK(errorsOf(glbOf({})).find("GLB: the file ends within a chunk header") != std::string::npos);
  CHECK(errorsOf(glbOf({{0x4e4f534a, R"({"asset":{"version":"2.0"}})"}})).empty());
}

TEST_CASE("several errors are reported together") {
  GltfFile file = goodFile();
  file.root["materials"][0]["alphaMode"] = "GLOW";
  file.primitive()["mode"] = 9;
  const std::string error = errorsOf(file.text());
  CHECK(error.find("/materials/0/alphaMode") != std::string::npos);
  CHECK(error.find("/meshes/0/primitives/0/mode") != std::string::npos);
}

TEST_CASE("names in messages cannot send control sequences to a terminal") {
  GltfFile file = goodFile();
  file.root["extensionsRequired"] = {"\x1b[31m"};
  CHECK(errorsOf(file.text()).find('\x1b') == std::string::npos);
  GltfFile other = goodFile();
  other.root["extensionsUsed"] = {"\x1b[31m" + std::string(1000, 'x')};
  for (const scene::Diagnostic& warning : load(other).warnings) {
    CHECK(warning.message.find('\x1b') == std::string::npos);
    CHECK(warning.message.size() < 200);
  }
}

}  // namespace candela::gltf
