#include "tests/program/run_program.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace vsg_tests {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

pid_t spawn(const std::vector<std::string>& arguments, const std::filesystem::path& folder, const std::string& out,
            const std::string& err) {
  std::vector<char*> argv{const_cast<char*>(VSG_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int in = ::open("/dev/null", O_RDONLY);
  const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(in, 0);
  ::dup2(to_out, 1);
  ::dup2(to_err, 2);
  if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
  ::_exit(127);
}

}  // namespace

ProgramTest::ProgramTest() {
  std::string name = (std::filesystem::temp_directory_path() / "vsg-test-XXXXXX").string();
  if (!::mkdtemp(name.data())) ADD_FAILURE() << "no folder for the test";
  folder_ = name;
}

ProgramTest::~ProgramTest() { std::filesystem::remove_all(folder_); }

Outcome ProgramTest::run(const std::vector<std::string>& arguments) const {
  // Beside the folder, so that the test sees only what the program leaves in it.
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  Outcome result;
  result.status = wait_for(spawn(arguments, folder_, out, err));
  result.out = content(out);
  result.err = content(err);
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return result;
}

pid_t ProgramTest::start(const std::vector<std::string>& arguments) const {
  return spawn(arguments, folder_, "/dev/null", "/dev/null");
}

int ProgramTest::wait_for(pid_t process) {
  int status = 0;
  if (process < 0 || ::waitpid(process, &status, 0) != process) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void ProgramTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string ProgramTest::read(const std::string& name) const { return content(path(name)); }

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::string project_file(const std::string& name) { return std::string(VSG_SOURCE_DIR) + "/" + name; }

std::string flat_scene(int width, int height, const std::string& objects) {
  std::ostringstream text;
  text << "version = 1\nsize = [" << width << ", " << height << "]\nbackground = [0, 0, 1]\n"
       << "[camera]\nprojection = \"orthographic\"\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\nheight = 2\nnear = 1\n"
       << "far = 9\n[[light]]\nkind = \"ambient\"\nintensity = 1\n"
       << objects;
  return text.str();
}

std::string rectangle_off(double left, double bottom, double right, double top, double z) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n4 1 0\n";
  for (const auto& [x, y] : {std::pair{left, bottom}, {right, bottom}, {right, top}, {left, top}}) {
    text << x << ' ' << y << ' ' << z << '\n';
  }
  text << "4 0 1 2 3\n";
  return text.str();
}

Image read_image(const std::filesystem::path& path) {
  Image image;
  const auto in = OIIO::ImageInput::open(path.string());
  if (!in) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return image;
  }
  const OIIO::ImageSpec& spec = in->spec();
  image.width = spec.width;
  image.height = spec.height;
  image.names.assign(spec.channelnames.begin(), spec.channelnames.end());
  for (int i = 0; i < spec.nchannels; ++i) image.formats.push_back(spec.channelformat(i).c_str());
  const std::size_t count = static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels;
  image.values.resize(count);
  if (spec.format == OIIO::TypeDesc::UINT8) {
    std::vector<unsigned char> bytes(count);
    EXPECT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data()));
    std::copy(bytes.begin(), bytes.end(), image.values.begin());
    return image;
  }
  // Every channel of our own EXR files is 32 bits wide, a float or an unsigned number.
  std::vector<std::uint32_t> words(count);
  EXPECT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UNKNOWN, words.data()));
  for (std::size_t i = 0; i < count; ++i) {
    const bool number = image.formats[i % spec.nchannels] == "uint";
    image.values[i] = number ? static_cast<float>(words[i]) : std::bit_cast<float>(words[i]);
  }
  return image;
}

}  // namespace vsg_tests
