#pragma once
/// Samples as a WAV file (Microsoft and IBM 1991, "Multimedia Programming Interface and Data
/// Specifications"): stereo, 16 bits.

#include <cstdint>
#include <filesystem>
#include <span>

#include "lab/files/whole_file.hpp"

namespace flipside::app::sound {

class WavFile {
  public:
    /// Of so many samples a side, at most 2^30 − 10: the form has 32 bits for its size. Throws lab::Failure
    /// where the file cannot be written.
    WavFile(const std::filesystem::path& file, std::uint64_t length);

    /// Left and right in turn. What is beyond the length is left out.
    void write(std::span<const std::int16_t> samples);
    /// Fills up with silence what is missing, and puts the file into its place.
    void finish();

  private:
    lab::WholeFile file_;
    std::uint64_t left_;  ///< samples of both sides that are missing
};

}  // namespace flipside::app::sound
