#pragma once
/// Encodes a video by the program ffmpeg: pictures come to it through a pipe, sound from a file.

#include <filesystem>
#include <optional>

#include <SFML/Graphics/Image.hpp>
#include <sys/types.h>

#include "lab/files/whole_file.hpp"
#include "lab/process/unfinished.hpp"
#include "lab/report/memory_file.hpp"

namespace flipside::app::film {

struct VideoForm {
    unsigned width = 0, height = 0;  ///< px, both even
    unsigned frames_per_second = 0;
};

/// Throws lab::Failure, with what to install, where there is no ffmpeg in PATH.
void require_ffmpeg();

/// H.264 and AAC in an MP4 file, which is there as a whole or not at all.
class Video {
  public:
    /// Opens the file. Throws like lab::WholeFile.
    explicit Video(const std::filesystem::path& target) : target_(target), file_(target) {}
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Starts ffmpeg, once. `sound` is a WAV file of the same length. Throws lab::Failure where it does not
    /// start.
    void start(const std::filesystem::path& sound, const VideoForm& form);
    /// A picture of that size. Throws lab::Failure, with what ffmpeg says, where it takes no more.
    void add(const sf::Image& picture);
    /// Waits for ffmpeg, and puts the video into its place. Throws lab::Failure.
    void finish();

  private:
    pid_t spawn(const std::filesystem::path& sound, const VideoForm& form);
    /// No more pictures come; its exit code.
    int end();
    [[noreturn]] void fail(const std::string& why) const;

    std::filesystem::path target_;
    lab::WholeFile file_;
    lab::report::MemoryFile said_;  ///< what ffmpeg says
    int pictures_ = -1;             ///< the pipe to it
    pid_t child_ = 0;
    std::optional<lab::UnfinishedChild> noted_;
};

}  // namespace flipside::app::film
