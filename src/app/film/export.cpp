#include "app/film/export.hpp"

#include <cstdio>
#include <optional>

#include "app/film/ffmpeg.hpp"
#include "app/painter.hpp"
#include "app/sound/wav_file.hpp"
#include "app/window/png_file.hpp"
#include "world/input_error.hpp"

namespace flipside::app::film {

namespace fs = std::filesystem;

namespace {

constexpr const char* frame_name = "frame-";

std::string name_of_frame(std::uint64_t number) {
    char digits[24];
    std::snprintf(digits, sizeof digits, "%06llu", static_cast<unsigned long long>(number));
    return std::string(frame_name) + digits + ".png";
}

/// Frames of another film would stand between those of this one.
void prepare_folder(const fs::path& folder) {
    lab::make_folder(folder);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(frame_name))
            throw InputError(folder.string() + ": holds frames already (" + entry.path().filename().string() +
                             "); allowed is a folder without");
}

/// The share of a pass over the film, of two: the sound is there before the pictures are, which a video
/// needs.
class Share {
  public:
    Share(const std::function<void(double)>& progress, double seconds)
        : progress_(progress), seconds_(seconds) {}

    /// That pass takes so much of the whole.
    void begin_pass(double share) { done_ += std::exchange(share_, share); }
    void at(double time) const { progress_(done_ + share_ * (seconds_ > 0 ? time / seconds_ : 1)); }

  private:
    const std::function<void(double)>& progress_;
    double seconds_, done_ = 0, share_ = 0;
};

void write_sound(const Film& film, ReplayStage& stage, const std::vector<fs::path>& files,
                 const Share& share) {
    std::vector<std::unique_ptr<sound::WavFile>> wavs;
    for (const fs::path& file : files) wavs.push_back(std::make_unique<sound::WavFile>(file, film.samples()));
    film.play(stage, {{},
                      [&](std::span<const std::int16_t> samples) {
                          for (const auto& wav : wavs) wav->write(samples);
                      },
                      [&](double time) { share.at(time); }});
    for (const auto& wav : wavs) wav->finish();
}

void write_pictures(const Film& film, ReplayStage& stage, const ExportOptions& options, Video* video,
                    const Share& share) {
    Painter painter(options.width, options.height,
                    usual_scale(options.height, options.width, options.height));
    Look look = options.look;
    look.advice = false;
    std::uint64_t number = 0;
    film.play(stage, {[&](const Stage& now) {
                          const sf::Image picture = painter.paint(now, look);
                          if (!options.frames.empty())
                              write_png(picture, options.frames / name_of_frame(number++));
                          if (video != nullptr) video->add(picture);
                      },
                      {},
                      [&](double time) { share.at(time); }});
}

}  // namespace

Exported export_film(const lab::Replay& replay, const Engine* other, const ExportOptions& options,
                     const std::function<void(double)>& progress) {
    ReplayStage heard(replay, options.view, other);
    const Film film(heard.end(), options.frames_per_second, options.part);
    Share share(progress, film.to());
    const bool pictures = !options.frames.empty() || !options.video.empty();

    std::optional<lab::report::MemoryFile> sound_of_video;
    std::vector<fs::path> sounds;
    if (!options.frames.empty()) {
        prepare_folder(options.frames);
        sounds.push_back(options.frames / "sound.wav");
    }
    if (!options.sound.empty()) sounds.push_back(options.sound);
    if (!options.video.empty()) sounds.push_back(sound_of_video.emplace().path());
    std::optional<Video> video;
    if (!options.video.empty()) video.emplace(options.video);
    share.begin_pass(pictures ? 0.05 : 1);
    write_sound(film, heard, sounds, share);
    while (heard.step()) continue;  // what is left after the last frame
    const std::string* parted = heard.parted();
    Exported exported{film.frames(), film.to() - film.from(), parted != nullptr ? *parted : ""};
    if (!pictures) return exported;

    if (video)
        video->start(sound_of_video->path(),
                     VideoForm{options.width, options.height, options.frames_per_second});
    ReplayStage seen(replay, options.view, other);
    share.begin_pass(0.95);
    write_pictures(film, seen, options, video ? &*video : nullptr, share);
    if (video) video->finish();
    return exported;
}

}  // namespace flipside::app::film
