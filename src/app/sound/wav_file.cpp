#include "app/sound/wav_file.hpp"

#include <algorithm>
#include <string>

#include "app/sound/voice.hpp"

namespace flipside::app::sound {

namespace {

constexpr std::uint32_t channels = 2, sample_bytes = 2, frame_bytes = channels * sample_bytes;
constexpr std::uint64_t header_bytes = 44;

/// From the lowest byte on.
std::string little_endian(std::uint64_t number, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xffU);
    return text;
}

std::string header(std::uint64_t data_bytes) {
    return "RIFF" + little_endian(header_bytes - 8 + data_bytes, 4) + "WAVEfmt " + little_endian(16, 4) +
           little_endian(1, 2) /* plain samples */ + little_endian(channels, 2) +
           little_endian(sample_rate, 4) + little_endian(sample_rate * frame_bytes, 4) +
           little_endian(frame_bytes, 2) + little_endian(8 * sample_bytes, 2) + "data" +
           little_endian(data_bytes, 4);
}

}  // namespace

WavFile::WavFile(const std::filesystem::path& file, std::uint64_t length)
    : file_(file), left_(channels * length) {
    file_.out() << header(left_ * sample_bytes);
}

void WavFile::write(std::span<const std::int16_t> samples) {
    const std::size_t size = std::min<std::uint64_t>(left_, samples.size());
    std::string bytes;
    bytes.reserve(size * sample_bytes);
    for (const std::int16_t sample : samples.first(size))
        bytes += little_endian(static_cast<std::uint16_t>(sample), sample_bytes);
    file_.out().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    left_ -= size;
}

void WavFile::finish() {
    constexpr std::int16_t silence[4096]{};
    while (left_ > 0) write(silence);
    file_.finish();
}

}  // namespace flipside::app::sound
