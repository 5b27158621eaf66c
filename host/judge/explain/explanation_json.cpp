// Formats explanations as JSON.
#include <cctype>
#include <nlohmann/json.hpp>

#include "host/base/report_head.h"
#include "host/judge/explain/explanation.h"

namespace candela::explain {
namespace {

using nlohmann::ordered_json;

// Converts "light pdf" to "lightPdf" and "BSDF u" to "bsdfU".
std::string keyOf(const std::string& name) {
  std::string key;
  bool startsWord = false;
  for (const char character : name) {
    const auto letter = static_cast<unsigned char>(character);
    if (character != ' ') key += static_cast<char>(startsWord ? std::toupper(letter) : std::tolower(letter));
    startsWord = character == ' ';
  }
  return key;
}

ordered_json valueJson(const Value& value) {
  if (value.isAbsent()) return nullptr;
  if (!value.words.empty()) return value.words;
  if (value.numbers.size() == 1) return value.numbers.front();
  return value.numbers;
}

ordered_json quantityJson(const Quantity& quantity) {
  ordered_json json{{"device", valueJson(quantity.device)}, {"reference", valueJson(quantity.reference)}};
  if (quantity.kind != Quantity::Kind::decision) json["apart"] = quantity.apart;
  if (quantity.kind == Quantity::Kind::number) json["amplification"] = quantity.amplification();
  if (quantity.kind == Quantity::Kind::decision) json["decidable"] = !quantity.undecidable;
  json["agrees"] = !quantity.differs;
  return json;
}

ordered_json stageJson(const Stage& stage) {
  ordered_json json{{"stage", stage.title}};
  for (const Quantity& quantity : stage.quantities) json[keyOf(quantity.name)] = quantityJson(quantity);
  return json;
}

ordered_json quantityIndexJson(const Explanation& explanation, const std::optional<QuantityIndex>& index) {
  if (!index) return nullptr;
  const Quantity& quantity = explanation.at(*index);
  ordered_json json{{"stage", explanation.stages[index->stage].title}, {"quantity", keyOf(quantity.name)}};
  json.update(quantityJson(quantity));
  return json;
}

ordered_json headJson(const std::string& scene, bool agrees) {
  ordered_json json = reportHead("candela-explain/2");
  json["scene"] = scene;
  json["agrees"] = agrees;
  return json;
}

}  // namespace

ordered_json toJson(const Explanation& explanation) {
  const render::PixelSample& sample = explanation.sample;
  ordered_json json = headJson(explanation.scene, !explanation.firstDifference);
  json["verdict"] = explanation.verdict();
  json["device"] = explanation.statistics.device;
  json["driver"] = explanation.statistics.driver;
  json["x"] = sample.x;
  json["y"] = sample.y;
  json["sample"] = sample.index;
  json["seed"] = explanation.seed;
  json["tolerance"] = kTolerance;
  json["replicas"] = explanation.replicas;
  json["firstDifference"] = quantityIndexJson(explanation, explanation.firstDifference);
  json["firstDecision"] = quantityIndexJson(explanation, explanation.firstDecision);
  json["vertexCount"] = {{"device", explanation.device.vertexCount}, {"reference", explanation.reference.vertexCount}};
  json["maxVertices"] = render::PathTrace::kMaxVertices;
  for (const Stage& stage : explanation.stages) json["stages"].push_back(stageJson(stage));
  return json;
}

ordered_json nothingJson(const scene::Scene& scene, const verify::PixelAgreement& pixels) {
  ordered_json json = headJson(scene.name, true);
  json["verdict"] = nothingToExplain(pixels);
  json["pixelCount"] = pixels.pixels;
  return json;
}

}  // namespace candela::explain
