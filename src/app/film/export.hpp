#pragma once
/// Writes the films of a replay: pictures, a video, its sound.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/film/film.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app::film {

struct ExportOptions {
    std::filesystem::path frames;  ///< a folder for the pictures, and sound.wav; "": none
    std::filesystem::path video;   ///< "": none
    std::filesystem::path sound;   ///< a WAV file; "": none
    View view = View::split;
    Look look;
    unsigned frames_per_second = 60;
    Part part;
    unsigned width = 1280, height = 800;  ///< px
};

struct Exported {
    std::uint64_t frames = 0;
    double seconds = 0;
    std::string parted;  ///< a run that went another way than the game; "" where none did
};

/// `progress` is told the share of the whole, 0…1. Pictures and videos need an X server. Throws InputError
/// where the other engine, if there is one, cannot run the scene, for a part that the game does not have, and
/// for a folder that holds frames; lab::Failure where something cannot be written.
Exported export_film(const lab::Replay& replay, const Engine* other, const ExportOptions& options,
                     const std::function<void(double)>& progress);

}  // namespace flipside::app::film
