// Several samples a pixel: the mean of what a larger picture shows, sample by sample.
#include <cmath>

#include "tests/deferred/judge.h"

namespace deferred {
namespace {

class Samples : public vsg_tests::ProgramTest {};

TEST_F(Samples, AreThoseOfALargerPicture) {
  std::mt19937_64 random(31);
  const std::vector<Body> bodies = {triangle_soup(random, 40, 32)};
  View view;
  view.position = {1, 2, 9};
  view.width = 90;  // regions end within pixels when there are three samples across
  view.height = 50;
  Picture picture(view, bodies);
  write("show.pfman", shader_text());
  write("body0.obj", bodies[0].obj());
  write("scene.toml", picture.scene(Quantity::kTexture, 1, 0));
  for (const int n : {2, 3, 5}) {
    const std::string large = std::to_string(view.width * n) + "x" + std::to_string(view.height * n);
    const std::vector<std::string> common = {"--vsg", "model", "--pe", "macro", "--channels", "--quiet"};
    std::vector<std::string> one = {"render", "scene.toml", "-o", "one.exr", "--size", large};
    std::vector<std::string> many = {"render", "scene.toml", "-o", "many.exr", "--samples", std::to_string(n)};
    one.insert(one.end(), common.begin(), common.end());
    many.insert(many.end(), common.begin(), common.end());
    ASSERT_EQ(run(one).status, 0);
    ASSERT_EQ(run(many).status, 0);
    const vsg_tests::Image single = vsg_tests::read_image(path("one.exr")),
                           mean = vsg_tests::read_image(path("many.exr"));
    ASSERT_EQ(single.width, n * mean.width);
    int mixed = 0;
    for (int row = 0; row < mean.height; ++row) {
      for (int column = 0; column < mean.width; ++column) {
        for (int k = 0; k < 3; ++k) {
          int sum = 0, least = 255, most = 0;
          for (int s = 0; s < n * n; ++s) {
            const auto byte = static_cast<int>(std::lround(255 * single.at(n * column + s % n, n * row + s / n, k)));
            sum += byte;
            least = std::min(least, byte);
            most = std::max(most, byte);
          }
          mixed += least != most;
          ASSERT_NEAR(mean.at(column, row, k), sum / (255.0 * n * n), 1e-6) << column << ", " << row << ", " << k;
        }
        // Channels are not mixed: they are the middle sample's.
        for (int k = 3; k < 9; ++k) {
          ASSERT_EQ(mean.at(column, row, k), single.at(n * column + n / 2, n * row + n / 2, k))
              << column << ", " << row << ", " << k;
        }
      }
    }
    EXPECT_GT(mixed, 1000);
  }
}

}  // namespace
}  // namespace deferred
