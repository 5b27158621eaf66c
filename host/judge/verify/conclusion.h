// The conclusion of a comparison of light, and the reason why one that found no difference may leave it open.
#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/judge/verify/region_result.h"

namespace candela::verify {

enum class Conclusion { same, different, undecided };

/// The cause that may hide a difference from a comparison that found none. darkness: the reference is black; renders:
/// there are too few of them for the level.
enum class Doubt { none, rounding, noise, darkness, renders };
inline constexpr std::array<const char*, 5> kDoubtNames{"none", "rounding", "noise", "darkness", "renders"};

/// The fraction of the image mean that a comparison may overlook, unless --bias states another.
inline constexpr double kMaxOverlooked = 0.01;

/// Two sides in words: the first begins a sentence.
struct SideNames {
  std::string first = "The device";
  std::string second = "the reference";
};

/// Returns what may hide a difference of more than the fraction `maxOverlooked` from the test of the whole image, which
/// found none. Rounding is the cause where what it excuses alone is more; otherwise, more samples help.
Doubt doubtOf(const RegionResult& image, double maxOverlooked);

/// Returns whether replicas with perturbed arithmetic lose, or gain, a good part of the light that the device does,
/// beyond the noise of both.
bool isLostBySinglePrecision(const RegionResult& image);

/// Returns sentences that state the doubt, the limit, and the sign and size of the difference; empty without a doubt,
/// and for Doubt::renders, which only the test of sets has (render_set_test.h).
std::string doubtText(Doubt doubt, const RegionResult& image, double maxOverlooked, const SideNames& names = {});

/// Returns a sentence on what decides a doubt, after a space; empty where doubtText() is. `moreSamples` says what would
/// give more of them.
std::string remedyText(Doubt doubt, const RegionResult& image, const std::string& moreSamples);

/// Returns the member `agrees` of a document: true, false, or null for undecided.
nlohmann::ordered_json agreesJson(Conclusion conclusion);
/// Returns an object with the same figures, or null without a doubt.
nlohmann::ordered_json doubtJson(Doubt doubt, const RegionResult& image, double maxOverlooked);

}  // namespace candela::verify
