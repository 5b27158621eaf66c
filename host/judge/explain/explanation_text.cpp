// Formats explanations as text, with the two paths side by side.
#include <fmt/format.h>

#include "host/judge/explain/explanation.h"
#include "host/judge/explain/value_text.h"

namespace candela::explain {
namespace {

constexpr std::size_t kNameWidth = 18;
constexpr std::size_t kSideWidth = 36;
constexpr std::size_t kNumberWidth = 12;
constexpr std::size_t kLineWidth = 100;

// Each number has a column, so that the components of vectors are aligned; words begin where digits do.
std::string cell(const Value& value) {
  std::string text = value.words.empty() ? "" : " " + value.words;
  for (const double number : value.numbers) text += fmt::format("{:<{}}", fmt::format("{: .5g}", number), kNumberWidth);
  return fmt::format("{:<{}}", text, kSideWidth);
}

std::string lastCell(const Quantity& quantity) {
  if (quantity.kind == Quantity::Kind::decision) return quantity.differs ? "DIFFERS" : "=";
  return quantity.differs ? apartText(quantity) + " DIFFERS" : apartText(quantity);
}

std::string amplificationCell(const Quantity& quantity) {
  if (quantity.kind == Quantity::Kind::decision) return quantity.undecidable ? "; undecidable" : "";
  return quantity.spread > 0 ? fmt::format("; {:.1g}", quantity.amplification()) : "";
}

class TextLayout {
 public:
  explicit TextLayout(const Explanation& explanation) : explanation_(explanation) {}

  std::string text() {
    addHead();
    for (std::size_t stage = 0; stage < explanation_.stages.size(); ++stage) addStage(stage);
    return std::move(text_);
  }

 private:
  void addHead() {
    const render::PixelSample& sample = explanation_.sample;
    text_ += fmt::format("{}, pixel {},{}, sample {}, seed {}: {} compared with the reference\n", explanation_.scene,
                         sample.x, sample.y, sample.index, explanation_.seed, explanation_.statistics.device);
    text_ += explanation_.verdict() + "\n";
    if (explanation_.isCut()) {
      text_ += fmt::format("The paths have {} and {} vertices; the first {} are shown.\n",
                           explanation_.device.vertexCount, explanation_.reference.vertexCount,
                           render::PathTrace::kMaxVertices);
    }
    text_ += fmt::format("\n{:<{}} {:<{}}{:<{}}apart{}\n", "", kNameWidth, "device", kSideWidth, "reference",
                         kSideWidth - 1, explanation_.replicas > 0 ? "; amplification" : "");
  }

  void addStage(std::size_t index) {
    const Stage& stage = explanation_.stages[index];
    text_ += stage.title + "\n";
    addRandomNumbers(stage);
    for (std::size_t i = 0; i < stage.quantities.size(); ++i) {
      const Quantity& quantity = stage.quantities[i];
      if (quantity.kind != Quantity::Kind::randomNumber || quantity.differs) addRow({index, i});
    }
  }

  // Random numbers that are equal, as they nearly always are, need no columns.
  void addRandomNumbers(const Stage& stage) {
    std::string line = "  random";
    const std::size_t empty = line.size();
    for (const Quantity& quantity : stage.quantities) {
      if (quantity.kind != Quantity::Kind::randomNumber || quantity.differs) continue;
      const std::string item = fmt::format("  {} {:.7f}", quantity.name, quantity.device.numbers.front());
      if (line.size() + item.size() > kLineWidth) {
        text_ += line + "\n";
        line = "        ";
      }
      line += item;
    }
    if (line.size() > empty) text_ += line + "\n";
  }

  // After the decision at which the paths diverge, numbers are shown but not compared, except for the result.
  void addRow(const QuantityIndex& index) {
    const Quantity& quantity = explanation_.at(index);
    const bool isResult = index.stage + 1 == explanation_.stages.size();
    const bool comparable = isResult || !explanation_.firstDecision || index <= *explanation_.firstDecision;
    const bool first = index == explanation_.firstDifference || index == explanation_.firstDecision;
    const bool compared = comparable && !quantity.device.isAbsent() && !quantity.reference.isAbsent();
    std::string row = fmt::format("{:<{}}{}{}{}", (first ? "> " : "  ") + quantity.name, kNameWidth,
                                  cell(quantity.device), cell(quantity.reference), compared ? lastCell(quantity) : "");
    if (compared && explanation_.replicas > 0) row += amplificationCell(quantity);
    row.erase(row.find_last_not_of(' ') + 1);
    text_ += row + "\n";
  }

  const Explanation& explanation_;
  std::string text_;
};

}  // namespace

std::string toText(const Explanation& explanation) { return TextLayout(explanation).text(); }

std::string nothingToExplain(const verify::PixelAgreement& pixels) {
  return fmt::format("Nothing to explain: at one sample all {} pixels are equal.", pixels.pixels);
}

}  // namespace candela::explain
