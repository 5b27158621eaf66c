// Writes the content of packets, then their size.
#include "host/app/cli/tev_packet.h"

#include <bit>
#include <concepts>

namespace candela::cli {
namespace {

constexpr std::uint8_t kCreateImage = 4;
constexpr std::uint8_t kUpdateImage = 6;  // with an offset and a stride for each channel

class PacketWriter {
 public:
  explicit PacketWriter(std::uint8_t kind) {
    add(std::uint32_t{0});
    add(kind);
    add(std::uint8_t{0});  // the viewer does not take the focus
  }

  template <std::unsigned_integral Number>
  void add(Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i) bytes_.push_back(static_cast<std::byte>(number >> (8 * i) & 255u));
  }
  void add(const std::string& text) {
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
    bytes_.push_back(std::byte{0});
  }
  void add(std::span<const std::string> texts) {
    for (const std::string& text : texts) add(text);
  }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }

  TevPacket finish() {
    for (std::size_t i = 0; i < 4; ++i) bytes_[i] = static_cast<std::byte>(bytes_.size() >> (8 * i) & 255u);
    return std::move(bytes_);
  }

 private:
  TevPacket bytes_;
};

std::uint32_t countOf(std::span<const std::string> channels) { return static_cast<std::uint32_t>(channels.size()); }

}  // namespace

TevPacket tevCreateImage(const std::string& name, const render::Extent& size, std::span<const std::string> channels) {
  PacketWriter packet(kCreateImage);
  packet.add(name);
  packet.add(size.width);
  packet.add(size.height);
  packet.add(countOf(channels));
  packet.add(channels);
  return packet.finish();
}

TevPacket tevUpdateImage(const std::string& name, std::span<const std::string> channels, const render::Window& window,
                         std::span<const float> values) {
  PacketWriter packet(kUpdateImage);
  packet.add(name);
  packet.add(countOf(channels));
  packet.add(channels);
  for (const std::uint32_t number : {window.x, window.y, window.width, window.height}) packet.add(number);
  for (std::uint64_t i = 0; i < channels.size(); ++i) packet.add(i);
  for (std::size_t i = 0; i < channels.size(); ++i) packet.add(std::uint64_t{channels.size()});
  for (const float value : values) packet.add(value);
  return packet.finish();
}

}  // namespace candela::cli
