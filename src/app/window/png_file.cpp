#include "app/window/png_file.hpp"

#include <string>

#include <SFML/Graphics/Image.hpp>
#include <png.h>

#include "lab/failure.hpp"
#include "lab/whole_file.hpp"

namespace flipside::app {

// Not by sf::Image::saveToFile, which does not notice a full disk.
void write_png(const sf::Image& picture, const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = picture.getSize().x;
    png.height = picture.getSize().y;
    png.format = PNG_FORMAT_RGBA;
    const auto write = [&](void* to, png_alloc_size_t& size) {
        if (png_image_write_to_memory(&png, to, &size, 0, picture.getPixelsPtr(), 0, nullptr) == 0)
            throw lab::Failure(file.string() + ": cannot be made a picture (" + png.message + ")");
    };
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    write(bytes.data(), size);
    bytes.resize(size);
    lab::write_whole_file(file, bytes);
}

}  // namespace flipside::app
