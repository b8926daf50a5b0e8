#include "pixelflow/shading/interleaving.h"

#include <algorithm>
#include <bit>
#include <set>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"

namespace pfman {
namespace {

using pixelflow::PixelArray;

constexpr int kHighestId = (1 << 8 * kShaderIdBytes) - 1;

const Shader& source(const Instance& instance) { return *instance.shader().shader; }

void check_fit(const Instance& surface, const Instance& light) {
  const std::string names = "surface '" + source(surface).name + "' and light '" + source(light).name + "': ";
  const int above = surface.shader().map.high_water, from = light.shader().map.first_free;
  if (from < above) {
    throw std::invalid_argument(names + "the light needs memory from byte " + std::to_string(from) +
                                " on, the surface keeps what is below byte " + std::to_string(above));
  }
  if (source(surface).three_colours && !source(light).three_colours) {
    throw std::invalid_argument(names + "the surface reads ambient or specular light, which the light does not assign");
  }
}

/// What every region begins with.
pixelflow::Program clear_mask() {
  pixelflow::Program program;
  pixelflow::append_instructions(
      program, [](pixelflow::Assembler& out) { out.store_constant(0, kMaskAt, pixelflow::Gate::None); });
  return program;
}

float float_at(const std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  for (int n = 0; n < 4; ++n) bits |= static_cast<std::uint32_t>(bytes[n]) << 8 * n;
  return std::bit_cast<float>(bits);
}

}  // namespace

Interleaving::Interleaving(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures)
    : surfaces_(std::move(surfaces)), lights_(std::move(lights)), textures_(textures) {
  std::set<int> ids;
  for (const Instance& surface : surfaces_) {
    const std::string name = "'" + source(surface).name + "'";
    if (source(surface).kind != Shader::Kind::Surface) throw std::invalid_argument(name + " is no surface");
    if (surface.id() < 1 || surface.id() > kHighestId) {
      throw std::invalid_argument("surface " + name + " has the shader ID " + std::to_string(surface.id()) + ", 1 to " +
                                  std::to_string(kHighestId) + " are possible");
    }
    if (!ids.insert(surface.id()).second) {
      throw std::invalid_argument("two surfaces have the shader ID " + std::to_string(surface.id()));
    }
    for (const Instance& light : lights_) check_fit(surface, light);
  }
  for (const Instance& light : lights_) {
    if (source(light).kind != Shader::Kind::Light) {
      throw std::invalid_argument("'" + source(light).name + "' is no light");
    }
  }
  std::stable_sort(lights_.begin(), lights_.end(),
                   [](const Instance& a, const Instance& b) { return a.id() < b.id(); });
  group();
}

void Interleaving::group() {
  groups_.clear();
  for (const Instance& surface : surfaces_) {
    const auto same = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
      const Instance& first = surfaces_[group.first];
      return &first.shader() == &surface.shader() && first.uniforms() == surface.uniforms() &&
             first.bound() == surface.bound();
    });
    const auto number = static_cast<std::size_t>(&surface - surfaces_.data());
    (same == groups_.end() ? groups_.emplace_back(Group{number, {}}) : *same).ids.push_back(surface.id());
  }
}

std::vector<Interleaving::Present> Interleaving::present_in(const PixelArray& array, StreamCache& cache) const {
  std::vector<std::uint8_t> low(static_cast<std::size_t>(array.covered())), high(low.size());
  array.read(kShaderIdAt, low);
  array.read(kShaderIdAt + 1, high);
  std::vector<bool> seen(kHighestId + 1);
  for (std::size_t n = 0; n < low.size(); ++n) seen[static_cast<std::size_t>(low[n] | high[n] << 8)] = true;

  std::vector<Present> all;
  for (const Group& group : groups_) {
    if (std::none_of(group.ids.begin(), group.ids.end(), [&](int id) { return seen[static_cast<std::size_t>(id)]; }))
      continue;
    const Instance& first = surfaces_[group.first];
    all.push_back({&first.shader(), &group.ids, &streams(first, group.ids, group.ids.front(), cache)});
  }
  return all;
}

const Streams& Interleaving::streams(const Instance& instance, const std::vector<int>& ids, int user,
                                     StreamCache& cache) const {
  return cache.streams(instance.shader(),
                       {.uniforms = instance.uniforms(),
                        .bound_varying = instance.bound(),
                        .shader_ids = ids,
                        .lights = static_cast<int>(lights_.size())},
                       user);
}

const CommonIllum* Interleaving::share_illum(std::vector<Present>& present, StreamCache& cache) const {
  const auto first = std::find_if(present.begin(), present.end(),
                                  [](const Present& one) { return one.shader->code.shared_phong.has_value(); });
  if (first == present.end() || lights_.empty()) return nullptr;
  const SharedPhong& code = cache.common_code(*first->shader);
  int block = kParametersAt;
  std::vector<Sharer> sharers;
  for (const Present& one : present) {
    if (!code.serves(*one.shader)) continue;
    sharers.push_back({one.shader, *one.ids});
    block = std::max(block, one.shader->map.high_water);
  }
  const int behind = block + code.block_bytes();
  const bool fits = behind + code.work_bytes() <= kSharedAt &&
                    std::all_of(lights_.begin(), lights_.end(),
                                [&](const Instance& light) { return light.shader().map.first_free >= behind; });
  if (sharers.size() < 2 || !fits) return nullptr;
  for (Present& one : present) one.shares = code.serves(*one.shader);
  return &cache.common_illum(sharers, block);
}

Interleaving::Work Interleaving::shade(PixelArray& array, StreamCache& cache) const {
  Work work;
  std::vector<Present> present = present_in(array, cache);
  if (present.empty()) return work;
  const CommonIllum* const common = share_illum(present, cache);
  work.executions = static_cast<int>(present.size());
  work.shared =
      static_cast<int>(std::count_if(present.begin(), present.end(), [](const auto& one) { return one.shares; }));

  const auto run = [&](const Stream& stream, std::uint64_t& cycles) {
    const std::uint64_t before = array.counters().cycles;
    for (const Stream::Part& part : stream.parts) {
      array.run(part.program);
      if (!part.lookup) continue;
      look_up(*part.lookup, array);
      ++work.cycles.lookups;
    }
    cycles += array.counters().cycles - before;
  };
  static const Stream first{{{clear_mask(), {}, {}}}};
  run(first, work.cycles.pre);
  const auto has_illuminance = [](const Present& one) { return one.shader->code.has_illuminance; };
  for (const Present& one : present) {
    if (has_illuminance(one)) run(one.streams->pre, work.cycles.pre);
  }
  if (common) {
    for (const Stream& copies : common->to_block) run(copies, work.cycles.pre);
  }
  for (std::size_t n = 0; n < lights_.size() && std::any_of(present.begin(), present.end(), has_illuminance); ++n) {
    // Lights have users of their own, counted down from -1.
    run(streams(lights_[n], {}, -1 - static_cast<int>(n), cache).pre, work.cycles.lights);
    if (common) run(common->illum, work.cycles.illum);
    for (const Present& one : present) {
      if (!has_illuminance(one) || one.shares) continue;
      const std::vector<Stream>& illum = one.streams->illum;
      run(illum[illum.size() == 1 ? 0 : n], work.cycles.illum);
    }
  }
  if (common) {
    for (const Stream& copies : common->from_block) run(copies, work.cycles.post);
  }
  for (const Present& one : present) {
    if (has_illuminance(one)) {
      run(one.streams->post, work.cycles.post);
    } else {
      run(one.streams->pre, work.cycles.pre);
    }
  }
  return work;
}

void Interleaving::look_up(const Lookup& lookup, PixelArray& array) const {
  static const TextureMemory none;
  const TextureMemory& textures = textures_ ? *textures_ : none;
  const auto lanes = static_cast<std::size_t>(array.covered());
  std::vector<std::uint8_t> packets(lanes * pixelflow::kPacketBytes);
  array.sent(packets);
  for (std::size_t n = 0; n < lanes; ++n) {
    if (!array.registers(static_cast<int>(n)).e) continue;
    std::uint8_t* const packet = packets.data() + n * pixelflow::kPacketBytes;
    const float x = float_at(packet), y = float_at(packet + 4);
    const std::array<std::uint8_t, 4> texel = lookup.environment
                                                  ? textures.environment(lookup.texture, {x, y, float_at(packet + 8)})
                                                  : textures.lookup(lookup.texture, x, y);
    std::copy_n(texel.begin(), lookup.components, packet);
  }
  array.load(packets);
}

}  // namespace pfman
