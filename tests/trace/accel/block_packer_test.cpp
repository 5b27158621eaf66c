// Blocks of eight slots in each other's gaps.
#include "host/trace/accel/block_packer.h"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

namespace candela::accel {

TEST_CASE("blocks lie in each other's gaps, and no slot is taken twice") {
  std::mt19937 random(3);
  BlockPacker packer;
  std::vector<bool> taken{true};
  std::size_t used = 1;
  for (int i = 0; i < 20000; ++i) {
    const auto mask = static_cast<std::uint8_t>(1 + random() % 255);
    const std::uint32_t block = packer.place(mask);
    taken.resize(packer.end());
    for (std::uint32_t k = 0; k < 8; ++k) {
      if ((mask >> k & 1) == 0) continue;
      REQUIRE(block + k < packer.end());
      REQUIRE_FALSE(taken[block + k]);
      taken[block + k] = true;
      ++used;
    }
  }
  CHECK(4 * packer.end() < 5 * used);
}

TEST_CASE("full blocks are consecutive, and single slots fill the gaps from the front") {
  BlockPacker packer;
  CHECK(packer.place(0xff) == 1);
  CHECK(packer.place(0xff) == 9);
  CHECK(packer.place(0b101) == 17);
  CHECK(packer.place(0b10) == 17);  // slot 18
  CHECK(packer.place(0x80) == 13);  // slot 20
  CHECK(packer.end() == 21);
}

}  // namespace candela::accel
