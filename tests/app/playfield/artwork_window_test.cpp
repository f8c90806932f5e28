#include <set>

#include <SFML/Graphics/Image.hpp>

#include "app/command_line.hpp"
#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

class ArtworkWindow : public WindowTest {};

TEST_F(ArtworkWindow, CanBeSwitchedOffAndOn) {
    open("pinball", "single");
    pause();
    click("Artwork");
    window->wait("a bare table", [](const Json& s) { return s["artwork"] == false; });
    click("Artwork");
    window->wait("the artwork", [](const Json& s) { return s["artwork"] == true; });
}

class ArtworkPicture : public CommandLine {
  protected:
    ArtworkPicture() { environment = "env"; }  // with the display
    static void SetUpTestSuite() { display = std::make_unique<VirtualDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }

    sf::Image picture(const std::string& name, const std::string& arguments) {
        expect_good("render " + arguments + " --engine custom --width 900 --height 700 --out " + file(name));
        sf::Image image;
        EXPECT_TRUE(image.loadFromFile(file(name)));
        return image;
    }
    /// Of the pane: below the header, which has times in it, and above the plots.
    static void at_pixels(const sf::Image& image, auto&& visit) {
        for (unsigned y = 60; y < image.getSize().y - 140; ++y)
            for (unsigned x = 0; x < image.getSize().x; ++x) visit(x, y);
    }
    static std::size_t colours_in(const sf::Image& image) {
        std::set<sf::Uint32> colours;
        at_pixels(image, [&](unsigned x, unsigned y) { colours.insert(image.getPixel(x, y).toInteger()); });
        return colours.size();
    }

    static inline std::unique_ptr<VirtualDisplay> display;
};

TEST_F(ArtworkPicture, IsDrawnUnlessItIsNotWanted) {
    const std::size_t with = colours_in(picture("with.png", "pinball --at 3"));
    const std::size_t without = colours_in(picture("without.png", "pinball --at 3 --no-artwork"));
    EXPECT_GT(with, 2 * without);
}

TEST_F(ArtworkPicture, OfTheSameMomentIsTheSame) {
    const sf::Image one = picture("one.png", "toy --at 2"), two = picture("two.png", "toy --at 2");
    unsigned different = 0;
    at_pixels(one, [&](unsigned x, unsigned y) { different += one.getPixel(x, y) != two.getPixel(x, y); });
    EXPECT_EQ(different, 0U);
}

TEST_F(ArtworkPicture, OverlaysDimTheGround) {
    const auto light = [](const sf::Image& image) {
        double sum = 0;
        at_pixels(image, [&](unsigned x, unsigned y) {
            const sf::Color pixel = image.getPixel(x, y);
            sum += pixel.r + pixel.g + pixel.b;
        });
        return sum;
    };
    // Nothing sleeps at the start: the overlay itself draws nothing.
    const double full = light(picture("full.png", "pinball")),
                 dim = light(picture("dim.png", "pinball --show sleep"));
    EXPECT_LT(dim, 0.95 * full);
}

}  // namespace
}  // namespace flipside::app
