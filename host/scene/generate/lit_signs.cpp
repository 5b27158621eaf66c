// Draws words in letters of 5 x 7 dots.
#include "host/scene/generate/lit_signs.h"

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>

namespace candela::generate {
namespace {

using glm::dvec3;

struct Letter {
  char character;
  std::array<std::string_view, 7> dots;  ///< rows from the top
};

constexpr std::array kLetters{
    Letter{'A', {" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    Letter{'B', {"#### ", "#   #", "#   #", "#### ", "#   #", "#   #", "#### "}},
    Letter{'C', {" ####", "#    ", "#    ", "#    ", "#    ", "#    ", " ####"}},
    Letter{'E', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"}},
    Letter{'F', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#    "}},
    Letter{'H', {"#   #", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    Letter{'I', {"#####", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", "#####"}},
    Letter{'L', {"#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"}},
    Letter{'M', {"#   #", "## ##", "# # #", "# # #", "#   #", "#   #", "#   #"}},
    Letter{'N', {"#   #", "##  #", "# # #", "# # #", "#  ##", "#   #", "#   #"}},
    Letter{'O', {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}},
    Letter{'R', {"#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"}},
    Letter{'T', {"#####", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  "}},
    Letter{'V', {"#   #", "#   #", "#   #", "#   #", "#   #", " # # ", "  #  "}},
};

struct Sign {
  std::string_view word;  ///< at most six letters
  dvec3 letters, ground;  ///< sRGB
};

constexpr std::array kSigns{
    Sign{"HOTEL", {1, 0.95, 0.8}, {0.45, 0.05, 0.05}}, Sign{"BAR", {1, 0.3, 0.55}, {0.1, 0.03, 0.2}},
    Sign{"CAFE", {1, 0.85, 0.4}, {0.1, 0.2, 0.1}},     Sign{"CINEMA", {0.7, 0.9, 1}, {0.05, 0.1, 0.4}},
    Sign{"LOTTO", {1, 0.75, 0.2}, {0.3, 0.03, 0.1}},   Sign{"TAVERN", {0.5, 1, 0.5}, {0.05, 0.15, 0.2}}};

constexpr std::uint32_t kDot = 4;                                  // pixels
constexpr std::uint32_t kDotColumns = SignPicture::kWidth / kDot;  // dots
constexpr std::uint32_t kDotRows = SignPicture::kHeight / kDot;
constexpr std::uint32_t kLetterWidth = 5, kLetterPitch = 6, kLetterHeight = 7;

bool isLit(std::string_view word, std::uint32_t x, std::uint32_t y) {
  const auto width = static_cast<std::uint32_t>(word.size()) * kLetterPitch - 1;
  const std::uint32_t left = (kDotColumns - width) / 2, top = (kDotRows - kLetterHeight) / 2;
  if (x < left || x >= left + width || y < top || y >= top + kLetterHeight) return false;
  const std::uint32_t column = (x - left) % kLetterPitch;
  if (column >= kLetterWidth) return false;
  for (const Letter& letter : kLetters) {
    if (letter.character == word[(x - left) / kLetterPitch]) return letter.dots[y - top][column] == '#';
  }
  return false;
}

bool isBorder(std::uint32_t x, std::uint32_t y) {
  return x == 0 || y == 0 || x == kDotColumns - 1 || y == kDotRows - 1;
}

SignPicture pictureOf(const Sign& sign) {
  SignPicture picture;
  for (std::uint32_t y = 0; y < SignPicture::kHeight; ++y) {
    for (std::uint32_t x = 0; x < SignPicture::kWidth; ++x) {
      const bool isBright = isBorder(x / kDot, y / kDot) || isLit(sign.word, x / kDot, y / kDot);
      const dvec3& colour = isBright ? sign.letters : sign.ground;
      for (int channel = 0; channel < 3; ++channel) {
        picture.rgb.push_back(static_cast<std::byte>(std::lround(255 * colour[channel])));
      }
    }
  }
  return picture;
}

}  // namespace

std::vector<SignPicture> signPictures() {
  std::vector<SignPicture> pictures;
  for (const Sign& sign : kSigns) pictures.push_back(pictureOf(sign));
  return pictures;
}

}  // namespace candela::generate
