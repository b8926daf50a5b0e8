// Positions, normals, texture coordinates and depths of pixels against rays through their samples.
#include "tests/deferred/judge.h"

namespace deferred {
namespace {

constexpr std::uint64_t kSeed = 20;

class Pixels : public vsg_tests::ProgramTest {
 protected:
  /// Renders with every shader, and has all of it judged. `least`: share of the covered samples that lie within the
  /// polygon they show.
  void judge(Picture& picture, const std::vector<Body>& bodies, int halvings, double least) {
    write("show.pfman", shader_text());
    for (std::size_t n = 0; n < bodies.size(); ++n) write("body" + std::to_string(n) + ".obj", bodies[n].obj());
    write("scene.toml", picture.scene(Quantity::kPosition, 0, halvings));
    const vsg_tests::Outcome frame = run({"frame", "scene.toml", "-o", "scene.frame", "--quiet"});
    ASSERT_EQ(frame.status, 0) << frame.err;
    picture.read_frame(read("scene.frame"));
    for (const Quantity quantity : kQuantities) {
      const bool place = quantity == Quantity::kPosition || quantity == Quantity::kVolume;
      const int shift = place ? halvings : 0;
      for (int component = 0; component < components(quantity); ++component) {
        const vsg_tests::Image image = render(picture.scene(quantity, component, shift));
        if (HasFatalFailure()) return;
        const Verdict verdict = picture.judge(image, quantity, component, shift);
        EXPECT_EQ(verdict.wrong, 0) << name(quantity) << '[' << component << "], of " << verdict.judged << ": "
                                    << verdict.first;
        EXPECT_GT(verdict.covered, 500);
        EXPECT_GE(verdict.judged, least * verdict.covered);
        if (quantity != Quantity::kPosition || component != 0) continue;
        const Verdict channels = picture.judge_channels(image);
        EXPECT_EQ(channels.wrong, 0) << "channels: " << channels.first;
        const Verdict seen = picture.judge_visibility(image);
        EXPECT_EQ(seen.wrong, 0) << "of " << seen.judged << ": " << seen.first;
        EXPECT_GT(seen.judged, picture.view.width * picture.view.height / 2);
      }
    }
  }

  vsg_tests::Image render(const std::string& scene) {
    write("scene.toml", scene);
    const vsg_tests::Outcome result =
        run({"render", "scene.toml", "-o", "a.exr", "--channels", "--vsg", "model", "--pe", "macro", "--quiet"});
    [&] { ASSERT_EQ(result.status, 0) << result.err; }();
    return vsg_tests::read_image(path("a.exr"));
  }
};

std::string replay(std::uint64_t seed) { return "seed " + std::to_string(seed) + " (set VSG_TEST_SEED to it)"; }

std::uint64_t seed() {
  const char* const text = std::getenv("VSG_TEST_SEED");
  return text != nullptr ? std::stoull(text) : kSeed;
}

std::vector<Body> soup(std::uint64_t from, int count, int sixteenths) {
  std::mt19937_64 random(from);
  return {triangle_soup(random, count, sixteenths)};
}

TEST_F(Pixels, TrianglesInPerspective) {
  SCOPED_TRACE(replay(seed()));
  const std::vector<Body> bodies = soup(seed(), 60, 32);
  View view;
  view.position = {1, 2, 9};
  view.target = {0.25, 0, 0};
  Picture picture(view, bodies);
  judge(picture, bodies, 0, 0.98);
}

TEST_F(Pixels, TrianglesWithoutPerspective) {
  SCOPED_TRACE(replay(seed() + 1));
  const std::vector<Body> bodies = soup(seed() + 1, 60, 32);
  View view;
  view.perspective = false;
  view.position = {3, 4, 7};
  view.up = {0.5, 1, 0};
  view.extent = 7;
  view.far = 30;
  Picture picture(view, bodies);
  judge(picture, bodies, 0, 0.98);
}

TEST_F(Pixels, TrianglesCutByAllSixPlanes) {
  SCOPED_TRACE(replay(seed() + 2));
  const std::vector<Body> bodies = soup(seed() + 2, 60, 96);
  for (const bool perspective : {true, false}) {
    View view;
    view.perspective = perspective;
    view.position = {0, 0.5, 3};
    view.field_of_view = 80;
    view.extent = 5;
    view.near = 0.5;
    view.far = 5;
    Picture picture(view, bodies);
    judge(picture, bodies, 0, 0.98);
  }
}

TEST_F(Pixels, TurnedFlattenedMirroredObjects) {
  Body first = box(), second = box(), third = star(7);
  first.rotate = {30, 40, 50};
  first.scale = {1, 0.5, 2};
  first.translate = {-2, 0.25, 0};
  second.rotate = {-20, 70, 10};
  second.scale = {-1.5, 1, 0.75};
  second.translate = {1.5, 0, -0.5};
  third.rotate = {10, -30, 5};
  third.scale = {1, -1, 1};
  third.translate = {0, 0.5, -4};
  const std::vector<Body> bodies = {first, second, third};
  View view;
  view.position = {0.5, 1.5, 7};
  Picture picture(view, bodies);
  judge(picture, bodies, 0, 0.98);
}

TEST_F(Pixels, StarsOfManyCorners) {
  Body near = star(16), far = star(23);
  near.scale = glm::dvec3(0.5);
  near.translate = {0.5, 0, 2};
  near.rotate = {0, 180, 0};  // from behind
  const std::vector<Body> bodies = {near, far};
  View view;
  view.position = {-1, -2, 6};
  Picture picture(view, bodies);
  judge(picture, bodies, 0, 0.98);
}

TEST_F(Pixels, NearAndFarThingsInOneView) {
  // From 0.03 to 400: the depth keeps most of its steps for what is near.
  std::mt19937_64 random(seed() + 3);
  SCOPED_TRACE(replay(seed() + 3));
  std::vector<Body> bodies(4, triangle_soup(random, 15, 32));
  double scale = 0.04;
  for (Body& body : bodies) {
    body.scale = glm::dvec3(scale);
    body.translate = {0.6 * scale, 0.4 * scale, 0.05 - 3 * scale};
    scale *= 12;
  }
  View view;
  view.position = {0, 0, 0};
  view.target = {0, 0, -1};
  view.near = 0.03;
  view.far = 400;
  Picture picture(view, bodies);
  judge(picture, bodies, 5, 0.95);
}

TEST_F(Pixels, TheJudgeSeesASampleThatIsATenthOfAPixelOff) {
  const std::vector<Body> bodies = soup(kSeed, 60, 32);
  View view;
  view.position = {1, 2, 9};
  Picture picture(view, bodies);
  write("show.pfman", shader_text());
  write("body0.obj", bodies[0].obj());
  write("scene.toml", picture.scene(Quantity::kTexture, 0, 0));
  ASSERT_EQ(run({"frame", "scene.toml", "-o", "scene.frame", "--quiet"}).status, 0);
  picture.read_frame(read("scene.frame"));
  const vsg_tests::Image image = render(picture.scene(Quantity::kTexture, 0, 0));
  EXPECT_EQ(picture.judge(image, Quantity::kTexture, 0, 0).wrong, 0);
  // A smaller angle moves every sample a little towards the middle.
  picture.view.field_of_view *= 0.999;
  const Verdict verdict = picture.judge(image, Quantity::kTexture, 0, 0);
  EXPECT_GT(verdict.wrong, 0.9 * verdict.judged);
}

}  // namespace
}  // namespace deferred
