// Where in an element's memory the things lie that all shaders and lights share (Olano and Lastra 1998,
// sections 6.1.5.1 and 6.2.1). What is between kParametersAt and kSharedAt belongs to the shader that the pixel shows:
// its parameters from kParametersAt on, in the order of its transfer map, then whatever its memory map says.
#pragma once

#include "pixelflow_parameters.h"

namespace pfman {

constexpr int kShaderIdAt = 0;  ///< two bytes, least significant first; 0 is background
constexpr int kShaderIdBytes = 2;
constexpr int kParametersAt = kShaderIdAt + kShaderIdBytes;

// From the top down.
constexpr int kLightSpecularAt = pixelflow::kMemoryBytes - 6;  ///< U(16,12)[3]
constexpr int kLightAmbientAt = kLightSpecularAt - 6;          ///< U(16,12)[3]
constexpr int kLightColorAt = kLightAmbientAt - 6;             ///< U(16,12)[3]
constexpr int kLightDirectionAt = kLightColorAt - 6;           ///< S(16,14)[3], from surface to light
/// U(8,8)[3]: the picture's colour, written at the end of the last stage over what the lights no longer need.
constexpr int kColorAt = kLightDirectionAt;
/// Mask bits 0 to 7: zero between streams. A shader that nests deeper has more mask bytes in its own part.
constexpr int kMaskAt = kLightDirectionAt - 1;
constexpr int kMaskByteBits = 8;
constexpr int kPositionAt = kMaskAt - 12;  ///< float[3], in eye space, rebuilt from depth before any shading
constexpr int kSharedAt = kPositionAt;
constexpr int kCommunicationBytes = pixelflow::kMemoryBytes - kSharedAt;

/// Packets of the composition network that a pixel's parameters may fill at 30 frames per second of 1280 x 1024 pixels
/// (section 6.2), and the bytes that each carries beside the depth.
constexpr int kMostPackets = 5;
constexpr int kPacketPayload = pixelflow::kPacketBytes - pixelflow::kDepthBytes;

}  // namespace pfman
