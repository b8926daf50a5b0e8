#include "pixelflow/shading/shading_node.h"

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
pixelflow::Program pre_shade() {
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

ShadingNode::ShadingNode(std::vector<Instance> surfaces, std::vector<Instance> lights, const TextureMemory* textures)
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
}

std::vector<ShadingNode::Group> ShadingNode::groups_in(const PixelArray& array) const {
  std::vector<std::uint8_t> low(static_cast<std::size_t>(array.lanes())), high(low.size());
  array.read(kShaderIdAt, low);
  array.read(kShaderIdAt + 1, high);
  std::vector<bool> present(kHighestId + 1);
  for (std::size_t n = 0; n < low.size(); ++n) present[static_cast<std::size_t>(low[n] | high[n] << 8)] = true;

  std::vector<Group> groups;
  for (const Instance& surface : surfaces_) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return &group.first->shader() == &surface.shader() && group.first->uniforms() == surface.uniforms() &&
             group.first->bound() == surface.bound();
    });
    (same == groups.end() ? groups.emplace_back(Group{&surface, {}}) : *same).ids.push_back(surface.id());
  }
  std::erase_if(groups, [&](const Group& group) {
    return std::none_of(group.ids.begin(), group.ids.end(),
                        [&](int id) { return present[static_cast<std::size_t>(id)]; });
  });
  return groups;
}

const Streams& ShadingNode::streams(const Instance& instance, const std::vector<int>& ids, int user) {
  return cache_.streams(instance.shader(),
                        {.uniforms = instance.uniforms(),
                         .bound_varying = instance.bound(),
                         .shader_ids = ids,
                         .lights = static_cast<int>(lights_.size())},
                        user);
}

void ShadingNode::share_illum(std::vector<Group>& groups) {
  const auto marked = [](const Group& group) { return group.first->shader().code.shared_phong.has_value(); };
  const auto first = std::find_if(groups.begin(), groups.end(), marked);
  if (first == groups.end() || lights_.empty()) return;
  if (!common_.code || !common_.code->serves(first->first->shader())) {
    common_ = {};
    common_.code = std::make_unique<SharedPhong>(first->first->shader());
  }
  int block = kParametersAt;
  std::vector<Group*> sharing;
  for (Group& group : groups) {
    if (!common_.code->serves(group.first->shader())) continue;
    sharing.push_back(&group);
    block = std::max(block, group.first->shader().map.high_water);
  }
  const int behind = block + common_.code->block_bytes();
  const bool fits = behind + common_.code->work_bytes() <= kSharedAt &&
                    std::all_of(lights_.begin(), lights_.end(),
                                [&](const Instance& light) { return light.shader().map.first_free >= behind; });
  if (sharing.size() < 2 || !fits) return;
  std::vector<std::vector<int>> ids;
  std::vector<int> all;
  for (Group* group : sharing) {
    group->shares = true;
    ids.push_back(group->ids);
    all.insert(all.end(), group->ids.begin(), group->ids.end());
  }
  shared_ += static_cast<int>(sharing.size());
  if (common_.ids == ids && common_.block == block) return;
  common_.ids = std::move(ids);
  common_.block = block;
  common_.illum = common_.code->illum(block, all);
  common_.to_block.clear();
  common_.from_block.clear();
  for (const Group* group : sharing) {
    common_.to_block.push_back(common_.code->copies(group->first->shader(), block, group->ids, false));
    common_.from_block.push_back(common_.code->copies(group->first->shader(), block, group->ids, true));
  }
}

void ShadingNode::shade(PixelArray& array) {
  std::vector<Group> groups = groups_in(array);
  if (groups.empty()) return;
  for (Group& group : groups) group.streams = &streams(*group.first, group.ids, group.ids.front());
  executions_ += static_cast<int>(groups.size());
  share_illum(groups);
  const bool shares = std::any_of(groups.begin(), groups.end(), [](const Group& group) { return group.shares; });

  const pixelflow::Program first = pre_shade();
  array.run(first);
  cycles_.pre += first.cycles();
  const auto has_illuminance = [](const Group& group) { return group.first->shader().code.has_illuminance; };
  for (const Group& group : groups) {
    if (has_illuminance(group)) run(group.streams->pre, array, cycles_.pre);
  }
  if (shares) {
    for (const Stream& copies : common_.to_block) run(copies, array, cycles_.pre);
  }
  for (std::size_t n = 0; n < lights_.size() && std::any_of(groups.begin(), groups.end(), has_illuminance); ++n) {
    // Lights have users of their own, counted down from -1.
    run(streams(lights_[n], {}, -1 - static_cast<int>(n)).pre, array, cycles_.lights);
    if (shares) run(common_.illum, array, cycles_.illum);
    for (const Group& group : groups) {
      if (!has_illuminance(group) || group.shares) continue;
      const std::vector<Stream>& illum = group.streams->illum;
      run(illum[illum.size() == 1 ? 0 : n], array, cycles_.illum);
    }
  }
  if (shares) {
    for (const Stream& copies : common_.from_block) run(copies, array, cycles_.post);
  }
  for (const Group& group : groups) {
    if (has_illuminance(group)) {
      run(group.streams->post, array, cycles_.post);
    } else {
      run(group.streams->pre, array, cycles_.pre);
    }
  }
}

void ShadingNode::run(const Stream& stream, PixelArray& array, std::uint64_t& cycles) {
  for (const Stream::Part& part : stream.parts) {
    array.run(part.program);
    if (part.lookup) look_up(*part.lookup, array);
  }
  cycles += stream.cycles();
}

void ShadingNode::look_up(const Lookup& lookup, PixelArray& array) {
  static const TextureMemory none;
  const TextureMemory& textures = textures_ ? *textures_ : none;
  const auto lanes = static_cast<std::size_t>(array.lanes());
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
  ++cycles_.lookups;
}

}  // namespace pfman
