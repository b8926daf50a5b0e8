// What an array executes while a region is on its way through the nodes, shading apart (Olano and Lastra 1998, sections
// 6.1.5.2 and 6.2.1). All elements take part, whatever their enable flag.
//
// A pixel lies in memory as RegionPixels says: its payload from kShaderIdAt on, its depth at kDepthAt. All cycles are
// the same for every region but those of pre_shade(), whose uniform factors differ.
#pragma once

#include "cmodel/pixelflow/program.h"
#include "pixelflow/shading/region.h"

namespace pfman {

/// Behind the largest payload; the workspace of what comes before shading follows.
constexpr int kDepthAt = kMostPackets * kPacketPayload;

/// Rendering node: depth and the bytes of packet `number`, from 0, leave.
pixelflow::Program send_pixel(int number);
/// Shading node: takes a packet in; the depth comes with the first.
pixelflow::Program take_pixel(int number);

/// The position in eye space from the depth and the element's place in the region, float[3] at kPositionAt.
///
/// Perspective: with u the complement of the depth, exact, 1/w = 1/far + u (1/near - 1/far) / kFarthest has no
/// cancellation; z = -w, x = w (x0 + dx column), y likewise, the planes in integers. Seven roundings of floats at most
/// add up: against exact arithmetic on the same depth the error of the position is below kPositionError of its length,
/// at all depths and for all ratios of far to near (largest that the tests saw: 2.3e-7). What rounding the depth to 32
/// bits costs comes to that: half a unit is w (far - near) / (2 near far kFarthest) of the length.
///
/// Orthographic: z = -(near + depth (far - near) / kFarthest); errors are below kPositionError of the largest length in
/// the view.
pixelflow::Program pre_shade(const EyeSpace& eye, int first_column, int first_row);
constexpr double kPositionError = 4.2e-7;

/// Zero everywhere but in the payload of so many packets and in the position: what a shader reads before it has written
/// it does not depend on what was there before.
pixelflow::Program clear_rest(int packets);

/// The colours leave, in the first bytes of a packet.
pixelflow::Program send_colors();

}  // namespace pfman
