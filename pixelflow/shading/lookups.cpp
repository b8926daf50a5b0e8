#include "pixelflow/shading/lookups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace pfman {
namespace {

using pixelflow::PixelArray;

float float_at(const std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  for (int n = 0; n < 4; ++n) bits |= static_cast<std::uint32_t>(bytes[n]) << 8 * n;
  return std::bit_cast<float>(bits);
}

std::vector<std::size_t> enabled(const PixelArray& array) {
  std::vector<std::size_t> lanes;
  for (int n = 0; n < array.covered(); ++n) {
    if (array.registers(n).e) lanes.push_back(static_cast<std::size_t>(n));
  }
  return lanes;
}

/// The packets that were sent, and the places of their elements.
struct Sent {
  explicit Sent(const PixelArray& array)
      : columns(static_cast<std::size_t>(array.covered())),
        rows(columns.size()),
        packets(columns.size() * pixelflow::kPacketBytes) {
    array.places(columns, rows);
    array.sent(packets);
  }

  /// Puts the answers in the place of the questions.
  void answer(const Lookup& lookup, const std::vector<std::size_t>& lanes, const TextureMemory& textures) {
    std::vector<TextureMemory::Sample> samples;
    for (const std::size_t lane : lanes) {
      const std::uint8_t* const packet = packets.data() + lane * pixelflow::kPacketBytes;
      std::array<float, 2> at = {float_at(packet), float_at(packet + 4)};
      if (lookup.environment) at = TextureMemory::on_sphere({at[0], at[1], float_at(packet + 8)});
      samples.push_back({columns[lane], rows[lane], at[0], at[1]});
    }
    const std::vector<TextureMemory::Texel> texels = textures.lookup(lookup.texture, samples);
    for (std::size_t n = 0; n < lanes.size(); ++n) {
      std::copy_n(texels[n].begin(), lookup.components, packets.data() + lanes[n] * pixelflow::kPacketBytes);
    }
  }

  std::vector<std::uint8_t> columns, rows, packets;
};

}  // namespace

void look_up(const Lookup& lookup, const TextureMemory& textures, PixelArray& array) {
  Sent sent(array);
  sent.answer(lookup, enabled(array), textures);
  array.load(sent.packets);
}

void look_up_shared(std::span<const TextureUser> users, const TextureMemory& textures, PixelArray& array) {
  std::vector<std::vector<std::size_t>> lanes;
  for (const TextureUser& user : users) {
    array.run(put_coordinates(user));
    lanes.push_back(enabled(array));
  }
  array.run(send_coordinates());
  Sent sent(array);
  for (std::size_t n = 0; n < users.size(); ++n) sent.answer(*users[n].lookup, lanes[n], textures);
  array.load(sent.packets);
  array.run(take_texels(users));
}

}  // namespace pfman
