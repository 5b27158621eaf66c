// How the cases that render pictures are tested.
#pragma once
#include <cstdint>

namespace candela::conformance {

struct PictureTest {
  std::uint32_t seed = 0;  ///< of the random numbers of the pictures
  double alpha = 1e-5;     ///< upper bound on the probability that a picture of a correct device fails
};

}  // namespace candela::conformance
