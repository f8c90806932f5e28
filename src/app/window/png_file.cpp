#include "app/window/png_file.hpp"

#include <cstring>

#include <SFML/Graphics/Image.hpp>
#include <png.h>

#include "lab/files/whole_file.hpp"
#include "lab/process/failure.hpp"

namespace flipside::app {

// Not by sf::Image::saveToFile, which does not notice a full disk.
std::string png_of(const sf::Image& picture) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = picture.getSize().x;
    png.height = picture.getSize().y;
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;  // without filters: letters and plain areas come out smaller
    // What a display shows has no alpha, whatever blending has left there.
    const std::size_t count = std::size_t{png.width} * png.height;
    std::string pixels(3 * count, '\0');
    for (std::size_t i = 0; i < count; ++i) std::memcpy(&pixels[3 * i], picture.getPixelsPtr() + 4 * i, 3);
    const auto write = [&](void* to, png_alloc_size_t& size) {
        if (png_image_write_to_memory(&png, to, &size, 0, pixels.data(), 0, nullptr) == 0)
            throw lab::Failure(std::string("the picture cannot be made PNG (") + png.message + ")");
    };
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    write(bytes.data(), size);
    bytes.resize(size);
    return bytes;
}

void write_png(const sf::Image& picture, const std::filesystem::path& file) {
    lab::write_whole_file(file, png_of(picture));
}

}  // namespace flipside::app
