#pragma once
/// All scenes at a glance, over the window: a picture, the name and its one sentence each. Arrow keys or the
/// mouse choose one.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <SFML/Graphics/Texture.hpp>
#include <SFML/Window/Event.hpp>

#include "app/window/controls.hpp"
#include "app/window/lettering.hpp"

namespace flipside::app {

class SceneBrowser {
  public:
    /// Lists the scenes that come with the program and those in the folder of `current`, which is a name or a
    /// path, or "". That one is marked.
    void open(const std::string& current);
    void close() { open_ = false; }
    [[nodiscard]] bool is_open() const { return open_; }

    /// True where the event was for it.
    bool process(const sf::Event& event);
    /// Over all of the window. A scene that was chosen, as Stage::open() takes it.
    std::optional<std::string> draw(const Rect& window, const Lettering& lettering, ControlPlaces& places);
    /// What stands in the way of the choice, to be read here.
    void warn(std::string words) { warning_ = std::move(words); }

  private:
    struct Card {
        std::string scene;  ///< a name or a path
        std::filesystem::path file;
        bool read = false;
        std::string name, about, fault;
        std::shared_ptr<const sf::Texture> picture;
    };

    void list(const std::string& current);
    /// One file that has not been read yet, so that the window goes on.
    void read_one(const Lettering& lettering);
    void read(Card& card, const Lettering& lettering);
    bool draw_card(std::size_t i, double width, double height, ControlPlaces& places);
    void draw_cards(ControlPlaces& places);

    bool open_ = false;
    std::vector<Card> cards_;
    std::size_t marked_ = 0;
    std::size_t columns_ = 1;
    bool follow_ = false;  ///< the marked one is to come into sight
    std::optional<std::size_t> chosen_;
    std::string warning_;
    std::map<std::string, std::shared_ptr<const sf::Texture>> pictures_;  ///< by the text of the file
};

}  // namespace flipside::app
