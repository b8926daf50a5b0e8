#include "cmodel/pixelflow/golden_array.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <stdexcept>
#include <string>

#include "cmodel/pixelflow/macro.h"

namespace pixelflow {
namespace {

/// Elements of the tile that an operation at the macro level computes.
int elements_of_groups(std::uint32_t groups, const PixelRow& tile) {
  int elements = std::popcount(groups) * PixelRow::kGroup;
  const int last = (tile.lanes() - 1) / PixelRow::kGroup;
  if (groups >> last & 1u) elements -= tile.padded_lanes() - tile.lanes();
  return elements;
}

void check_size(std::size_t given, int elements) {
  if (given != static_cast<std::size_t>(elements)) {
    throw std::invalid_argument(std::to_string(elements) + " elements of the array work, not " + std::to_string(given));
  }
}

void check_packets(std::size_t given, int elements) {
  const auto all = static_cast<std::size_t>(elements) * kPacketBytes;
  if (given != all) {
    throw std::invalid_argument("the array's packets have " + std::to_string(all) + " bytes in all, not " +
                                std::to_string(given));
  }
}

bool is_send(const Instruction& instruction) {
  return instruction.kind == Kind::Control && instruction.fn == static_cast<std::uint8_t>(Control::Send);
}

void check_address(int address) {
  if (address < 0 || address >= kMemoryBytes) {
    throw std::invalid_argument("an element has " + std::to_string(kMemoryBytes) +
                                " bytes of memory; there is no byte " + std::to_string(address));
  }
}

}  // namespace

GoldenArray::GoldenArray(Level level, int lanes, int multiplier_bits)
    : level_(level), lanes_(lanes), covered_(lanes), working_(lanes), multiplier_bits_(multiplier_bits) {
  if (level == Level::Rtl) throw std::invalid_argument("the golden model has the levels model and macro");
  if (lanes < 1 || lanes > kRegionWidth * kRegionHeight) {
    throw std::invalid_argument("an array has 1 to " + std::to_string(kRegionWidth * kRegionHeight) +
                                " elements, not " + std::to_string(lanes));
  }
  if (multiplier_bits != 1 && multiplier_bits != 2 && multiplier_bits != 4 && multiplier_bits != 8) {
    throw std::invalid_argument("a digit of the multiplier has 1, 2, 4 or 8 bits, not " +
                                std::to_string(multiplier_bits));
  }
  if (level == Level::Macro) check_host_arithmetic();
  sent_.resize(static_cast<std::size_t>(lanes) * kPacketBytes);
  own_won_.resize(static_cast<std::size_t>(lanes));
  for (int first = 0; first < lanes; first += PixelRow::kLanes) {
    PixelRow& tile = tiles_.emplace_back(std::min(PixelRow::kLanes, lanes - first));
    for (int n = 0; n < tile.lanes(); ++n) {
      tile.columns()[n] = static_cast<std::uint8_t>((first + n) % kRegionWidth);
      tile.rows()[n] = static_cast<std::uint8_t>((first + n) / kRegionWidth);
    }
  }
}

void GoldenArray::cover(int elements) {
  if (elements < 1 || elements > lanes_) {
    throw std::invalid_argument("1 to " + std::to_string(lanes_) + " elements of the array can work, not " +
                                std::to_string(elements));
  }
  mode_ = Compose::Own;
  covered_ = elements;
  working_ = std::min((elements + kElements - 1) / kElements * kElements, lanes_);
  int left = working_;
  for (PixelRow& tile : working_tiles()) {
    tile.resize(std::min(left, PixelRow::kLanes));
    left -= tile.lanes();
  }
}

std::span<PixelRow> GoldenArray::working_tiles() {
  return std::span(tiles_).first(static_cast<std::size_t>((working_ + PixelRow::kLanes - 1) / PixelRow::kLanes));
}

void GoldenArray::write(int address, std::span<const std::uint8_t> bytes) {
  check_address(address);
  check_size(bytes.size(), covered_);
  for (PixelRow& tile : working_tiles()) {
    const auto part = bytes.first(std::min(bytes.size(), static_cast<std::size_t>(tile.lanes())));
    std::copy(part.begin(), part.end(), tile.memory(address));
    bytes = bytes.subspan(part.size());
  }
}

void GoldenArray::read(int address, std::span<std::uint8_t> bytes) const {
  check_address(address);
  check_size(bytes.size(), covered_);
  for (auto tile = tiles_.begin(); !bytes.empty(); ++tile) {
    const std::size_t part = std::min(bytes.size(), static_cast<std::size_t>(tile->lanes()));
    std::copy_n(tile->memory(address), part, bytes.begin());
    bytes = bytes.subspan(part);
  }
}

void GoldenArray::place(std::span<const std::uint8_t> columns, std::span<const std::uint8_t> rows) {
  check_size(columns.size(), covered_);
  check_size(rows.size(), covered_);
  for (PixelRow& tile : working_tiles()) {
    const std::size_t part = std::min(columns.size(), static_cast<std::size_t>(tile.lanes()));
    std::copy_n(columns.begin(), part, tile.columns());
    std::copy_n(rows.begin(), part, tile.rows());
    columns = columns.subspan(part);
    rows = rows.subspan(part);
  }
}

void GoldenArray::places(std::span<std::uint8_t> columns, std::span<std::uint8_t> rows) const {
  check_size(columns.size(), covered_);
  check_size(rows.size(), covered_);
  for (auto tile = tiles_.begin(); !columns.empty(); ++tile) {
    const std::size_t part = std::min(columns.size(), static_cast<std::size_t>(tile->lanes()));
    std::copy_n(tile->columns(), part, columns.begin());
    std::copy_n(tile->rows(), part, rows.begin());
    columns = columns.subspan(part);
    rows = rows.subspan(part);
  }
}

Registers GoldenArray::registers(int lane) const {
  if (lane < 0 || lane >= lanes_) {
    throw std::invalid_argument("the array has " + std::to_string(lanes_) + " elements; there is no element " +
                                std::to_string(lane));
  }
  return tiles_[static_cast<std::size_t>(lane / PixelRow::kLanes)].registers(lane % PixelRow::kLanes);
}

void GoldenArray::check_program(const Program& program) const {
  std::uint64_t next = 0;
  for (std::size_t n = 0; n < program.steps.size(); ++n) {
    const Step& step = program.steps[n];
    if (step.first != next) {
      throw std::invalid_argument("step " + std::to_string(n) + " starts at instruction " + std::to_string(step.first) +
                                  ", not at " + std::to_string(next));
    }
    next += step.count;
    if (step.operation) {
      try {
        check(*step.operation, step.workspace_bytes);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("step " + std::to_string(n) + ", " + error.what());
      }
    }
  }
  if (next != program.instructions.size()) {
    throw std::invalid_argument("the steps cover " + std::to_string(next) + " instructions of " +
                                std::to_string(program.instructions.size()));
  }
}

void GoldenArray::run(const Program& program) {
  check_program(program);
  std::vector<std::uint64_t> step_cycles;
  step_cycles.reserve(program.steps.size());
  std::uint64_t cycles = 0;
  for (const Step& step : program.steps) {
    // All instructions but multiplications take one cycle: this loop must not be felt beside native operations.
    std::uint64_t sum = step.count;
    for (const Instruction& i : std::span(program.instructions).subspan(step.first, step.count)) {
      if (i.kind == Kind::Wide && i.fn == static_cast<std::uint8_t>(Wide::Multiply)) {
        sum += static_cast<std::uint64_t>(pixelflow::cycles(i, multiplier_bits_) - 1);
      }
    }
    step_cycles.push_back(sum);
    cycles += sum;
  }
  const auto sends = std::count_if(program.instructions.begin(), program.instructions.end(), is_send);
  if (mode_ != Compose::Own && sends > 1) throw std::invalid_argument("only one Send of a program can be composed");
  for (std::size_t tile = 0; tile < working_tiles().size(); ++tile) run_tile(program, step_cycles, tile);
  if (sends > 0) mode_ = Compose::Own;
  counters_.cycles += cycles;
  counters_.instructions += program.instructions.size();
  counters_.element_cycles += cycles * static_cast<std::uint64_t>(lanes_);
}

void GoldenArray::load(std::span<const std::uint8_t> packets) {
  check_packets(packets.size(), covered_);
  const std::uint8_t *from = packets.data(), *const end = from + packets.size();
  for (PixelRow& tile : working_tiles()) {
    for (int n = 0; n < tile.lanes(); ++n) {
      for (int byte = 0; byte < kPacketBytes; ++byte) tile.inbound(byte)[n] = from != end ? from[byte] : 0;
      if (from != end) from += kPacketBytes;
    }
  }
}

void GoldenArray::compose(Compose closer_or_repeat, std::span<const std::uint8_t> upstream) {
  if (closer_or_repeat != Compose::Closer && closer_or_repeat != Compose::Repeat) {
    throw std::invalid_argument("a program's packets are composed by Closer or Repeat");
  }
  check_packets(upstream.size(), covered_);
  mode_ = closer_or_repeat;
  upstream_.assign(static_cast<std::size_t>(working_) * kPacketBytes, 0);
  std::copy(upstream.begin(), upstream.end(), upstream_.begin());
}

void GoldenArray::sent(std::span<std::uint8_t> packets) const {
  check_packets(packets.size(), covered_);
  std::copy_n(sent_.begin(), packets.size(), packets.begin());
}

void GoldenArray::send_packets(PixelRow& tile, std::size_t first) {
  for (std::size_t n = 0; n < static_cast<std::size_t>(tile.lanes()); ++n) {
    const std::size_t element = first + n;
    std::uint8_t* const to = sent_.data() + element * kPacketBytes;
    for (int byte = 0; byte < kPacketBytes; ++byte) to[byte] = tile.outbound(byte)[n];
    if (mode_ == Compose::Own) continue;
    const std::uint8_t* const upstream = upstream_.data() + element * kPacketBytes;
    if (mode_ == Compose::Closer) {
      // The most significant byte comes last.
      const auto depth = [](const std::uint8_t* packet) { return std::reverse_iterator(packet + kDepthBytes); };
      own_won_[element] = std::lexicographical_compare(depth(to), depth(to) + kDepthBytes, depth(upstream),
                                                       depth(upstream) + kDepthBytes);
    }
    if (!own_won_[element]) std::copy_n(upstream, kPacketBytes, to);
  }
}

void GoldenArray::run_instructions(std::span<const Instruction> instructions, std::size_t number) {
  PixelRow& tile = tiles_[number];
  while (!instructions.empty()) {
    const auto send = std::find_if(instructions.begin(), instructions.end(), is_send);
    const auto before = static_cast<std::size_t>(send - instructions.begin());
    tile.run(instructions.first(before));
    if (send == instructions.end()) return;
    send_packets(tile, number * PixelRow::kLanes);
    instructions = instructions.subspan(before + 1);
  }
}

void GoldenArray::run_tile(const Program& program, const std::vector<std::uint64_t>& step_cycles, std::size_t number) {
  PixelRow& tile = tiles_[number];
  for (std::size_t n = 0; n < program.steps.size(); ++n) {
    const Step& step = program.steps[n];
    const bool natively = level_ == Level::Macro && step.operation.has_value();
    int simulated = tile.lanes();
    if (step.operation && !is_comparison(step.operation->code)) {
      const std::uint32_t enabled = tile.enabled_groups().any;
      if (enabled == 0) continue;
      if (natively) simulated = elements_of_groups(enabled, tile);
    }
    if (natively) {
      compute(*step.operation, tile);
    } else if (step.operation) {
      tile.run(std::span(program.instructions).subspan(step.first, step.count));
    } else {
      run_instructions(std::span(program.instructions).subspan(step.first, step.count), number);
    }
    counters_.simulated_element_cycles += step_cycles[n] * static_cast<std::uint64_t>(simulated);
  }
}

std::unique_ptr<PixelArray> make_golden_array(Level level, int lanes, int multiplier_bits) {
  return std::make_unique<GoldenArray>(level, lanes, multiplier_bits);
}

}  // namespace pixelflow
