// The answers to the three questions of a verification, which text and JUnit XML share.
#pragma once
#include <string>

#include "host/judge/verify/verify.h"

namespace candela::verify {
/// "Same numbers, same paths?", with the causes of differences: some lines.
std::string pathsText(const VerifyReport& report);
/// "Same light?", with the most significant difference: some lines.
std::string lightText(const VerifyReport& report);
/// "Right light?": two lines; one for a scene that states no exact result.
std::string exactText(const VerifyReport& report);

}  // namespace candela::verify
