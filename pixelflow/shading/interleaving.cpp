#include "pixelflow/shading/interleaving.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "pixelflow/compiler/memory_layout.h"
#include "pixelflow/microcode/library.h"
#include "pixelflow/shading/lookups.h"

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

/// A region's streams on their way through the array.
class Execution {
 public:
  Execution(PixelArray& array, const TextureMemory& textures) : array_(array), textures_(textures) {}

  const Interleaving::Cycles& cycles() const { return cycles_; }
  using Count = std::uint64_t Interleaving::Cycles::*;

  /// Parts of a stream from `first` up to `last`, or all that follow. `ids`: the pixels of a surface.
  void run(const Stream& stream, Count count, const std::vector<int>& ids = {}, std::size_t first = 0,
           std::size_t last = kAll) {
    const std::uint64_t before = array_.counters().cycles;
    for (std::size_t n = first; n < std::min(last, stream.parts.size()); ++n) {
      const std::optional<Lookup>& lookup = stream.parts[n].lookup;
      array_.run(stream.parts[n].program);
      if (!lookup || n + 1 == last) continue;
      ++cycles_.lookups;
      if (lookup->shared) {
        const TextureUser alone{&ids, &*lookup};
        look_up_shared({&alone, 1}, textures_, array_);
      } else {
        look_up(*lookup, textures_, array_);
      }
    }
    cycles_.*count += array_.counters().cycles - before;
  }

  void share_lookup(const std::vector<TextureUser>& users, Count count) {
    if (users.empty()) return;
    const std::uint64_t before = array_.counters().cycles;
    look_up_shared(users, textures_, array_);
    cycles_.*count += array_.counters().cycles - before;
    ++cycles_.lookups;
  }

 private:
  static constexpr auto kAll = static_cast<std::size_t>(-1);

  PixelArray& array_;
  const TextureMemory& textures_;
  Interleaving::Cycles cycles_;
};

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

void Interleaving::share_lookup(std::vector<Present>& present) const {
  for (Present& one : present) {
    const bool waits_for_lights = !one.shader->code.has_illuminance;
    const bool fits = std::all_of(lights_.begin(), lights_.end(), [&](const Instance& light) {
      return light.shader().map.first_free >= one.shader->map.lookup_water;
    });
    if (waits_for_lights && !fits) continue;
    const auto& parts = one.streams->pre.parts;
    const auto shared =
        std::find_if(parts.begin(), parts.end(), [](const auto& part) { return part.lookup && part.lookup->shared; });
    if (shared != parts.end()) one.before_lookup = static_cast<std::size_t>(shared - parts.begin()) + 1;
  }
}

Interleaving::Work Interleaving::shade(PixelArray& array, StreamCache& cache) const {
  Work work;
  std::vector<Present> present = present_in(array, cache);
  if (present.empty()) return work;
  const CommonIllum* const common = share_illum(present, cache);
  share_lookup(present);
  work.executions = static_cast<int>(present.size());
  work.shared =
      static_cast<int>(std::count_if(present.begin(), present.end(), [](const auto& one) { return one.shares; }));

  static const TextureMemory none;
  Execution execution(array, textures_ ? *textures_ : none);
  static const Stream first{{{clear_mask(), {}, {}}}};
  execution.run(first, &Cycles::pre);
  std::vector<TextureUser> users;
  for (const Present& one : present) {
    if (one.before_lookup == 0) continue;
    execution.run(one.streams->pre, &Cycles::pre, *one.ids, 0, one.before_lookup);
    users.push_back({one.ids, &*one.streams->pre.parts[one.before_lookup - 1].lookup});
  }
  execution.share_lookup(users, &Cycles::pre);
  const auto has_illuminance = [](const Present& one) { return one.shader->code.has_illuminance; };
  for (const Present& one : present) {
    if (has_illuminance(one)) execution.run(one.streams->pre, &Cycles::pre, *one.ids, one.before_lookup);
  }
  if (common) {
    for (const Stream& copies : common->to_block) execution.run(copies, &Cycles::pre);
  }
  for (std::size_t n = 0; n < lights_.size() && std::any_of(present.begin(), present.end(), has_illuminance); ++n) {
    // Lights have users of their own, counted down from -1.
    execution.run(streams(lights_[n], {}, -1 - static_cast<int>(n), cache).pre, &Cycles::lights);
    if (common) execution.run(common->illum, &Cycles::illum);
    for (const Present& one : present) {
      if (!has_illuminance(one) || one.shares) continue;
      const std::vector<Stream>& illum = one.streams->illum;
      execution.run(illum[illum.size() == 1 ? 0 : n], &Cycles::illum);
    }
  }
  if (common) {
    for (const Stream& copies : common->from_block) execution.run(copies, &Cycles::post);
  }
  for (const Present& one : present) {
    if (has_illuminance(one)) {
      execution.run(one.streams->post, &Cycles::post);
    } else {
      execution.run(one.streams->pre, &Cycles::pre, *one.ids, one.before_lookup);
    }
  }
  work.cycles = execution.cycles();
  return work;
}

}  // namespace pfman
