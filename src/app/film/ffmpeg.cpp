#include "app/film/ffmpeg.hpp"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "lab/process/failure.hpp"
#include "lab/process/spawn.hpp"
#include "lab/report/process.hpp"

namespace flipside::app::film {

namespace fs = std::filesystem;

namespace {

constexpr const char* no_ffmpeg = "ffmpeg cannot be run, and it writes videos; on Debian install ffmpeg";

/// A descriptor that other programs inherit under its number.
class Inherited {
  public:
    explicit Inherited(int descriptor) : descriptor_(dup(descriptor)) {}
    ~Inherited() { close(descriptor_); }
    Inherited(const Inherited&) = delete;
    Inherited& operator=(const Inherited&) = delete;

    [[nodiscard]] int get() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Nothing in it comes from outside but numbers: files go by the numbers under which they are open. Colours
/// are those of ITU-R BT.709, and said to be.
std::vector<std::string> ffmpeg_command(const VideoForm& form, const fs::path& sound, int target) {
    const std::string size = std::to_string(form.width) + "x" + std::to_string(form.height);
    const std::string rate = std::to_string(form.frames_per_second);
    return {"ffmpeg",
            "-nostdin",
            "-hide_banner",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb0",
            "-video_size",
            size,
            "-framerate",
            rate,
            "-i",
            "pipe:0",
            "-f",
            "wav",
            "-i",
            "file:" + sound.string(),
            "-c:v",
            "libx264",
            "-preset",
            "veryfast",
            "-crf",
            "18",
            "-vf",
            "scale=out_color_matrix=bt709",
            "-pix_fmt",
            "yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-c:a",
            "aac",
            "-b:a",
            "160k",
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            "file:/dev/fd/" + std::to_string(target)};
}

}  // namespace

void require_ffmpeg() {
    try {
        if (lab::report::run_program({"ffmpeg", "-version"}).code == 0) return;
    } catch (const lab::Failure&) {  // said below, with what helps
    }
    throw lab::Failure(no_ffmpeg);
}

void Video::start(const fs::path& sound, const VideoForm& form) {
    noted_.emplace([&] { return spawn(sound, form); });
}

pid_t Video::spawn(const fs::path& sound, const VideoForm& form) {
    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0) fail(std::generic_category().message(errno));
    const Inherited target(file_.descriptor());
    const int messages = open(said_.path().c_str(), O_WRONLY | O_CLOEXEC);
    const int error =
        lab::spawn(child_, ffmpeg_command(form, sound, target.get()), {pipe[0], messages, messages});
    close(messages);
    close(pipe[0]);
    pictures_ = pipe[1];
    if (error != 0) {
        child_ = 0;
        end();
        throw lab::Failure(no_ffmpeg);
    }
    return child_;
}

Video::~Video() {
    if (child_ > 0) kill(-child_, SIGKILL);
    end();
}

int Video::end() {
    if (pictures_ >= 0) close(std::exchange(pictures_, -1));
    return child_ > 0 ? lab::wait_for(std::exchange(child_, 0)) : 0;
}

void Video::fail(const std::string& why) const {
    throw lab::Failure(target_.string() + ": no video could be made (" + why + ")");
}

void Video::add(const sf::Image& picture) {
    const auto* from = reinterpret_cast<const char*>(picture.getPixelsPtr());
    std::size_t left = std::size_t{4} * picture.getSize().x * picture.getSize().y;
    while (left > 0) {
        const ssize_t written = write(pictures_, from, left);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) finish();  // it has ended, and says why
        from += written;
        left -= static_cast<std::size_t>(written);
    }
}

void Video::finish() {
    const int code = end();
    std::ifstream in(said_.path());
    std::string said{std::istreambuf_iterator<char>(in), {}};
    if (code != 0) fail("ffmpeg: " + (said.empty() ? "exit code " + std::to_string(code) : said));
    file_.finish();
}

}  // namespace flipside::app::film
