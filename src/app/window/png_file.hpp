#pragma once
/// Pictures as PNG files.

#include <filesystem>

namespace sf {
class Image;
}

namespace flipside::app {

/// A whole file or none (lab/files/whole_file.hpp). Throws lab::Failure or InputError where it cannot be
/// written.
void write_png(const sf::Image& picture, const std::filesystem::path& file);

}  // namespace flipside::app
