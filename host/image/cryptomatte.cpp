// Ranks the ids of a pixel, and describes them.
#include "host/image/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "host/base/json_text.h"
#include "host/image/murmur_hash.h"

namespace candela::image {
namespace {

const char* layerNameOf(MatteKind kind) { return kind == MatteKind::object ? "CryptoObject" : "CryptoMaterial"; }

std::vector<std::string> channelNamesOf(MatteKind kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < 2 * kMatteRanks; ++i) {
    names.push_back(fmt::format("{}{:02}.{}", layerNameOf(kind), i / 4, "rgba"[i % 4]));
  }
  return names;
}

// The entries of all ranks, and possibly more.
IdCounts rankedCounts(const IdCounts& counts) {
  IdCounts sorted = counts;
  std::erase_if(sorted, [](const IdCount& entry) { return entry.id == kNoId; });
  std::ranges::stable_sort(sorted, std::greater{}, &IdCount::count);  // equal counts stay sorted by their ids
  return sorted;
}

}  // namespace

std::span<const std::string> cryptomatteChannelNames(MatteKind kind) {
  static const std::array names{channelNamesOf(MatteKind::object), channelNamesOf(MatteKind::material)};
  return names[static_cast<std::size_t>(kind)];
}

CryptomatteValues cryptomatteValues(const IdCounts& counts) {
  CryptomatteValues values{};
  const IdCounts ranked = rankedCounts(counts);
  const double samples = sampleCountOf(counts);
  for (std::size_t rank = 0; rank < std::min(ranked.size(), kMatteRanks); ++rank) {
    values[2 * rank] = std::bit_cast<float>(ranked[rank].id);
    values[2 * rank + 1] = static_cast<float>(ranked[rank].count / samples);
  }
  return values;
}

std::map<std::string, std::string> cryptomatteMetadata(MatteKind kind, std::span<const std::string> names) {
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
  for (const std::string& name : names) manifest[name] = fmt::format("{:08x}", matteId(name));
  const std::string key = fmt::format("cryptomatte/{:.7}/", fmt::format("{:08x}", murmurHash3(layerNameOf(kind))));
  return {{key + "name", layerNameOf(kind)},
          {key + "hash", "MurmurHash3_32"},
          {key + "conversion", "uint32_to_float32"},
          {key + "manifest", asciiJsonText(manifest)}};
}

}  // namespace candela::image
