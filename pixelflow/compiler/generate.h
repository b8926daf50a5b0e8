// Streams of SIMD instructions from a compiled shader and the values of its uniform parameters: uniform expressions and
// control flow are executed here (Olano and Lastra 1998, section 6.1.6).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cmodel/pixelflow/program.h"
#include "pixelflow/compiler/compile.h"
#include "pixelflow/compiler/host.h"

namespace pfman {

/// A texture lookup: the program before it has sent s and t, or a direction, in the first bytes of the outbound packet
/// of every element that is enabled, as floats; the one after it takes 3 or 4 bytes from the beginning of the inbound
/// packet. Around a shared lookup the programs neither send nor take anything: the surfaces of a region do it together
/// (shared_texture.h), and the elements of other shaders may work between the two.
struct Lookup {
  std::int64_t texture = 0;
  int components = 3;
  bool environment = false;
  struct Shared {
    int coordinates = 0, texel = 0;  ///< where they lie
  };
  std::optional<Shared> shared;
};

/// Programs that run one after another, with a lookup behind each but the last.
struct Stream {
  struct Part {
    pixelflow::Program program;
    std::vector<Location> places;  ///< of each step of the program, in the text
    std::optional<Lookup> lookup;
  };
  std::vector<Part> parts;

  std::uint64_t cycles() const;
};

/// What surfaces and lights run. `illum` has a stream for each light; where the uniform values are the same for all of
/// them, so are the streams, and `illum` holds one.
struct Streams {
  Stream pre;  ///< of a light: all of it
  std::vector<Stream> illum;
  Stream post;
  /// For --dump=cycles: cycles by line of the source, all stages.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> cycles_by_line;  ///< (file, line)
};

struct GenerateInput {
  std::map<std::string, Raw> uniforms;       ///< by parameter name; the others have their defaults
  std::map<std::string, Raw> bound_varying;  ///< loaded into pixel memory before the shader runs
  std::vector<int> shader_ids;               ///< surface: pixels that it runs for; empty: all pixels
  int lights = 1;

  friend bool operator==(const GenerateInput&, const GenerateInput&) = default;
};

/// Throws std::invalid_argument where a parameter's value does not have as many scalars as its type.
void check_count(const Variable& parameter, const Raw& value);

/// A varying argument: where it lies in pixel memory, and its type.
struct PixelVariable {
  std::uint8_t address = 0;
  std::uint8_t bytes = 0;  ///< of one number
  std::uint8_t kind = 0;   ///< 0 unsigned, 1 signed fixed, 2 float
  std::int16_t exponent = 0;
  int count = 1;
};
struct ExternalArgument {
  std::optional<PixelVariable> pixel;
  Raw uniform;
};
/// What an external function may use besides its arguments.
struct PixelWorkspace {
  int first = 0;  ///< in pixel memory
  int bytes = 0;
  /// Of the shared mask byte: its value wherever the enable flag is set, and the first bit that may be used; from that
  /// one on the byte is zero everywhere, and has to be again.
  int mask = 0;
  int free_mask_bit = 0;
};

/// A C++ function that shaders call with varying arguments: it appends to the stream. Arguments come in the order of
/// its parameters, a varying result behind them. The enable flag has to be left as it was.
using PixelFunction = void (*)(pixelflow::Program& stream, const std::vector<ExternalArgument>& arguments,
                               const PixelWorkspace& workspace);

/// Functions of C++ that shaders may call, by linkage name. Register before compiling.
void register_external(const std::string& name, UniformFunction function);
void register_external(const std::string& name, PixelFunction function, int workspace_bytes);

/// The streams of a surface or a light. Throws UniformError, and std::invalid_argument for a parameter with another
/// number of values than it has.
Streams generate(const CompiledShader& shader, const GenerateInput& input);

/// Appends a call of a function of the language, for C++: arguments in the order of its parameters, then the result.
/// Varying parameters also take uniform arguments, uniform ones take no others; outputs are in pixel memory, and have
/// the values that the function leaves where the enable flag is set. Throws std::invalid_argument for a function that
/// the unit does not have or that looks up textures, for arguments that do not fit it, and where the workspace does not
/// suffice; UniformError.
void append_call(pixelflow::Program& stream, const CompiledUnit& unit, const std::string& function,
                 const std::vector<ExternalArgument>& arguments, const PixelWorkspace& workspace);

/// What a parameter has where it is not set, in its own type.
Raw default_value(const CompiledShader& shader, const ShaderParameter& parameter);

}  // namespace pfman
