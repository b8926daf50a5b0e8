// Writes random frames, for comparison with other programs: vsg_random_frames FOLDER FIRST_SEED COUNT. Prints a line a frame:
// its file and whether back faces are to be kept.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/random/random_frames.h"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: vsg_random_frames FOLDER FIRST_SEED COUNT\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  const std::uint64_t first = std::strtoull(argv[2], nullptr, 10);
  const int count = std::atoi(argv[3]);
  std::filesystem::create_directories(folder);
  for (int i = 0; i < count; ++i) {
    const auto random = vsg_tests::random_frame(first + static_cast<std::uint64_t>(i));
    const auto path = folder / ("random" + std::to_string(first + static_cast<std::uint64_t>(i)) + ".frame");
    std::ofstream out(path);
    scanline::write_frame(out, random.frame);
    std::printf("%s %d\n", path.c_str(), random.keep_back_faces ? 1 : 0);
  }
  return 0;
}
