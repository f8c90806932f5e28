#pragma once
/// Pictures as PNG files.

#include <filesystem>
#include <string>

namespace sf {
class Image;
}

namespace flipside::app {

/// The bytes of a PNG file. Throws lab::Failure where the picture is too large for one.
[[nodiscard]] std::string png_of(const sf::Image& picture);
/// A whole file or none (lab/files/whole_file.hpp). Throws lab::Failure or InputError where it cannot be
/// written.
void write_png(const sf::Image& picture, const std::filesystem::path& file);

}  // namespace flipside::app
